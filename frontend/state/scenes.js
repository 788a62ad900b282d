// @ts-check

/**
 * The scenes of the page in the order of its navigation; the first is the usual one. What belongs to
 * one of them alone carries its id as `data-scene`.
 * @type {{id: string, title: string}[]}
 */
export const SCENES = [
  { id: "explorer", title: "Explorer" },
  { id: "accuracy", title: "Speed and accuracy" },
];
