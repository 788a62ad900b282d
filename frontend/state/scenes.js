// @ts-check

/**
 * The scenes of the page in the order of its navigation; the first is the usual one. What belongs to
 * some of them alone carries their ids as `data-scene`.
 * @type {{id: string, title: string, hasTrace: boolean}[]} `hasTrace`: whether it shows the collision over time
 */
export const SCENES = [
  { id: "explorer", title: "Explorer", hasTrace: true },
  { id: "spheres", title: "Real spheres", hasTrace: false },
  { id: "accuracy", title: "Speed and accuracy", hasTrace: true },
  { id: "paper", title: "The paper", hasTrace: false },
  { id: "lesson", title: "Lesson", hasTrace: true },
];
