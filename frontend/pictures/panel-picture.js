// @ts-check

import { fileName } from "../format/requests.js";
import { say } from "../format/words.js";

/**
 * What a panel shows, as its scene knows it, asked when it is wanted.
 * @typedef {object} Picture
 * @property {string} title
 * @property {() => string} [subject] what of several things it shows, for names of files
 * @property {() => string} [subjectTitle] the same for titles, where it is no symbol
 * @property {() => import("../format/requests.js").Request} request whose answer it shows
 * @property {() => Record<string, number | string>} parameters that name its files
 * @property {() => import("../figures/tables.js").Table | import("../figures/tables.js").Table[] | null} [table] null while there is no picture
 * @property {() => import("./save-picture.js").Crosshair | null} [place] of a crosshair that belongs to the picture
 */

/** @typedef {ReturnType<typeof panelPicture>} PanelPicture */

/** @type {Record<string, string>} */
const MARKUP = {
  epsilon_t: "<i>ε</i><sub>t</sub>",
  kappa: "<i>κ</i>",
  mu_over_alpha: "<i>μ</i>/<i>α</i>",
  gt_over_gn: "<i>g</i><sub>t</sub>/<i>g</i><sub>n</sub>",
  damping: "<i>η</i>",
};

/**
 * What is saved of a panel, and under which names.
 * @param {HTMLElement} element with its name as `data-panel`
 * @param {Picture} picture
 */
export function panelPicture(element, picture) {
  const name = element.dataset.panel ?? "";
  // A surface in depth stands before the flat map; what is drawn is looked for when it is saved.
  const drawn = () => element.querySelector(".surface") ?? element.querySelector(".plot, svg");

  function titleWithSubject() {
    const { title } = picture;
    const subject = picture.subjectTitle?.() ?? picture.subject?.();
    return subject ? say("menu.of", { title, subject: MARKUP[subject] ?? subject }) : title;
  }

  return {
    name,
    element,
    picture,
    drawn,
    hasPicture: drawn() !== null,

    /** Whether there is anything to be saved by now. */
    isHere: () => !picture.table || picture.table() !== null,

    /** @param {Record<string, string>} form @returns {import("../format/requests.js").Request} */
    request(form) {
      const request = picture.request();
      return { ...request, query: { ...request.query, ...form } };
    },

    /** @param {string} extension */
    fileName(extension) {
      const what = [name, picture.subject?.() ?? []].flat().join("-");
      return fileName(what, picture.parameters(), extension);
    },

    /** With markup, and the numbers that it is of. */
    title() {
      const parameters = Object.entries(picture.parameters());
      const numbers = parameters.map(([key, value]) => `${MARKUP[key] ?? key} = ${value}`);
      return `${titleWithSubject()} · ${numbers.join(", ")}`;
    },

    /** Of the crosshair, which a surface in depth has none of. */
    place: () => (drawn()?.matches(".surface") ? null : (picture.place?.() ?? null)),
  };
}
