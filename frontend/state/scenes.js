// @ts-check

/**
 * The scenes of the page in the order of its navigation; the first is the usual one. What belongs to
 * some of them alone carries their ids as `data-scene`.
 * @type {{id: string, title: string}[]}
 */
export const SCENES = [
  { id: "explorer", title: "Explorer" },
  { id: "spheres", title: "Real spheres" },
  { id: "accuracy", title: "Speed and accuracy" },
  { id: "paper", title: "The paper" },
  { id: "lesson", title: "Lesson" },
];

/** Those that show map and cut. */
export const WITH_MAP = ["explorer", "lesson"];
