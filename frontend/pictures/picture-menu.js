// @ts-check

import { addressOf, curlOf, fileName, frameOf, pythonOf, serverOf } from "../format/requests.js";
import { say } from "../format/words.js";
import { writeAddress } from "../state/url.js";
import { find } from "../widgets/find.js";
import { download } from "./download.js";
import { codeBlock, openSheet, tableElement } from "./sheet.js";

/** Pixels between a button and its menu. */
const GAP = 4;

/**
 * The files that hold what a picture shows, each with what a request says for it.
 * @type {{text: () => string, title?: () => string, form: Record<string, string>}[]}
 */
const FILES = [
  { text: () => "CSV", form: { format: "csv" } },
  {
    text: () => "CSV 0,5",
    title: () => say("menu.withCommas"),
    form: { format: "csv", separator: "semicolon", decimal: "comma" },
  },
  {
    text: () => say("menu.units"),
    title: () => say("menu.withUnits"),
    form: { format: "csv", header: "units" },
  },
  { text: () => "JSON", form: { format: "json" } },
];

/**
 * What a menu asks the server for: the answer to what is posted, which no link can ask, and a font.
 * @typedef {object} Load
 * @property {(request: import("../format/requests.js").Request) => Promise<Blob>} file
 * @property {(address: string) => Promise<Blob>} font
 * @property {(reason: string) => void} reportLost where the server does not answer
 */

/**
 * What the menu of a picture needs to know of it, asked when the menu is used.
 * @typedef {object} Picture
 * @property {string} title
 * @property {() => string} [subject] what of several things it shows, for names of files
 * @property {() => string} [subjectTitle] the same for titles, where it is no symbol
 * @property {() => import("../format/requests.js").Request} request whose answer it shows
 * @property {() => Record<string, number | string>} parameters that name its files
 * @property {() => import("../figures/tables.js").Table | import("../figures/tables.js").Table[] | null} [table] null while there is no picture
 * @property {() => import("./save-picture.js").Crosshair | null} [place] of a crosshair that belongs to the picture
 */

/**
 * The menu of a panel: its data, its picture, its table, its request, its frame.
 * @param {HTMLElement} panel with its name as `data-panel`
 * @param {Picture} picture
 * @param {() => import("../state/url.js").PageState} present
 * @param {Load} load
 */
export function mountPictureMenu(panel, picture, present, load) {
  const name = panel.dataset.panel ?? "";
  // A surface in depth stands before the flat map; what is drawn is looked for when it is saved.
  const drawn = () => panel.querySelector(".surface") ?? panel.querySelector(".plot, svg");
  const hasPicture = drawn() !== null;
  const menu = document.createElement("div");
  const button = document.createElement("button");
  menu.id = `menu-${name}`;
  menu.className = "menu";
  menu.popover = "auto";
  button.className = "menu-button";
  button.type = "button";
  button.textContent = "⋯";
  button.dataset.testid = `menu-${name}`;
  button.setAttribute("aria-label", say("menu.label", { title: picture.title }));
  button.popoverTargetElement = menu;

  const data = FILES.map(({ text, title, form }) => {
    const link = document.createElement("a");
    link.textContent = text();
    link.title = title?.() ?? "";
    link.addEventListener("click", async (event) => {
      const request = picture.request();
      if (request.body) {
        event.preventDefault();
        const file = await load.file({ ...request, query: { ...request.query, ...form } });
        download(URL.createObjectURL(file), link.download);
      }
    });
    return { form, link };
  });
  const pictures = /** @type {("png" | "svg")[]} */ (["png", "svg"]).map((format) =>
    item(format.toUpperCase(), () => save(format)),
  );
  const table = item(say("sheet.table"), () => {
    const rows = picture.table?.();
    if (rows) {
      openSheet(picture.title, [rows].flat().map(tableElement));
    }
  });
  const groups = [
    group(
      say("menu.data"),
      data.map(({ link }) => link),
    ),
    group(say("menu.picture"), hasPicture ? pictures : []),
  ];
  const [dataGroup, pictureGroup] = groups;
  menu.append(
    ...groups,
    table,
    item(say("menu.request"), showRequest),
    item(say("menu.embed"), () =>
      openSheet(say("menu.embedOf", { title: picture.title }), [
        codeBlock("HTML", frameOf(embedAddress(), say("menu.frame", { title: picture.title }))),
        codeBlock(say("menu.address"), embedAddress()),
      ]),
    ),
  );
  pictureGroup.hidden = !hasPicture;
  (panel.querySelector(".panel-head") ?? panel).append(button, menu);

  menu.addEventListener("beforetoggle", () => {
    const request = picture.request();
    const isHere = !picture.table || picture.table() !== null;
    dataGroup.hidden = !isHere;
    pictureGroup.hidden = !hasPicture || !isHere;
    table.hidden = !picture.table || !isHere;
    for (const { form, link } of data) {
      link.href = addressOf({ ...request, query: { ...request.query, ...form } });
      link.download = fileName(fileSubject(), picture.parameters(), form.format);
    }
  });
  for (const [target, kind] of [
    [menu, "toggle"],
    [window, "scroll"],
    [window, "resize"],
  ]) {
    /** @type {EventTarget} */ (target).addEventListener(
      /** @type {string} */ (kind),
      moveToButton,
    );
  }
  menu.addEventListener("keydown", (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) {
      event.preventDefault();
      const items = /** @type {HTMLElement[]} */ ([...menu.querySelectorAll("a, button")]).filter(
        (each) => each.offsetParent,
      );
      const at = items.indexOf(/** @type {HTMLElement} */ (document.activeElement));
      items.at((at + step) % items.length)?.focus();
    }
  });
  button.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") {
      event.preventDefault();
      menu.showPopover();
      find("a[href]", menu).focus();
    }
  });
  /** Below its button, or where there is no room for it, above. */
  function moveToButton() {
    if (menu.matches(":popover-open")) {
      const { top, bottom, right } = button.getBoundingClientRect();
      const { height } = menu.getBoundingClientRect();
      const y =
        bottom + GAP + height > innerHeight ? Math.max(0, top - height - GAP) : bottom + GAP;
      menu.style.setProperty("top", `${y}px`);
      menu.style.setProperty("right", `${document.documentElement.clientWidth - right}px`);
    }
  }

  /**
   * @param {string} text
   * @param {() => void} act
   */
  function item(text, act) {
    const element = document.createElement("button");
    element.type = "button";
    element.textContent = text;
    element.addEventListener("click", () => {
      menu.hidePopover();
      act();
    });
    return element;
  }

  function fileSubject() {
    return [name, picture.subject?.() ?? []].flat().join("-");
  }

  function titleWithSubject() {
    const { title } = picture;
    const subject = picture.subjectTitle?.() ?? picture.subject?.();
    return subject ? say("menu.of", { title, subject: MARKUP[subject] ?? subject }) : title;
  }

  /** @param {"png" | "svg"} format */
  async function save(format) {
    const element = drawn();
    const parameters = Object.entries(picture.parameters());
    const numbers = parameters.map(([key, value]) => `${MARKUP[key] ?? key} = ${value}`);
    const options = {
      format,
      title: `${titleWithSubject()} · ${numbers.join(", ")}`,
      fileName: fileName(fileSubject(), picture.parameters(), format),
      loadFont: load.font,
    };
    const saving = await import("./save-drawing.js").catch(() => null);
    if (!saving) {
      load.reportLost(say("server.saverMissing"));
    } else if (element instanceof SVGSVGElement) {
      saving.saveDrawing(element, options);
    } else {
      const place = element?.matches(".surface") ? null : (picture.place?.() ?? null);
      saving.savePicture(/** @type {HTMLElement} */ (element), { ...options, place });
    }
  }

  function showRequest() {
    const request = picture.request();
    openSheet(say("menu.requestOf", { title: picture.title }), [
      codeBlock("curl", curlOf(request, serverOf(location.href))),
      codeBlock("Python", pythonOf(request, serverOf(location.href))),
    ]);
  }

  function embedAddress() {
    return new URL(writeAddress({ ...present(), embed: name }), location.href).href;
  }
}

/**
 * @param {string} name
 * @param {HTMLElement[]} items
 */
function group(name, items) {
  const element = document.createElement("p");
  const label = document.createElement("span");
  label.textContent = name;
  element.setAttribute("role", "group");
  element.setAttribute("aria-label", name);
  element.append(label, ...items);
  return element;
}

/** @type {Record<string, string>} */
const MARKUP = {
  epsilon_t: "<i>ε</i><sub>t</sub>",
  kappa: "<i>κ</i>",
  mu_over_alpha: "<i>μ</i>/<i>α</i>",
  gt_over_gn: "<i>g</i><sub>t</sub>/<i>g</i><sub>n</sub>",
  damping: "<i>η</i>",
};
