// @ts-check

/**
 * The scenes of the page in the order of its navigation; the first is the usual one. What belongs to
 * some of them alone carries their ids as `data-scene`.
 * @type {{id: string, hasTrace: boolean}[]} `hasTrace`: whether it shows the collision over time
 */
export const SCENES = [
  { id: "explorer", hasTrace: true },
  { id: "spheres", hasTrace: false },
  { id: "accuracy", hasTrace: true },
  { id: "paper", hasTrace: false },
  { id: "lesson", hasTrace: true },
];
