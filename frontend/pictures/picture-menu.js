// @ts-check

import { addressOf, curlOf, pythonOf, serverOf } from "../format/requests.js";
import { say } from "../format/words.js";
import { codeBlock } from "../widgets/copy.js";
import { find } from "../widgets/find.js";
import { download } from "./download.js";
import { panelPicture } from "./panel-picture.js";
import { openSheet, tableElement } from "./sheet.js";

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
 * @property {(error: unknown) => void} explain why it does not give what was asked for
 * @property {string} server its address, where it is not that of the page
 * @property {(reason: string) => void} reportLost where the server does not answer
 */

/**
 * The menu of a panel: its data, its picture, its table, its request, its frame.
 * @param {HTMLElement} panel with its name as `data-panel`
 * @param {import("./panel-picture.js").Picture} picture
 * @param {(name: string) => void} embed shows how it stands in a frame of another page
 * @param {Load} load
 */
export function mountPictureMenu(panel, picture, embed, load) {
  const saved = panelPicture(panel, picture);
  const { name, hasPicture } = saved;
  const menu = document.createElement("div");
  const button = document.createElement("button");
  panel.dataset.title = picture.title;
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
    link.addEventListener("click", (event) => {
      const request = saved.request(form);
      if (request.body || load.server) {
        event.preventDefault();
        load
          .file(request)
          .then((file) => download(file, link.download))
          .catch(load.explain);
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
  const toEmbed = item(say("page.embed"), () => embed(name));
  toEmbed.className = "to-embed";
  menu.append(...groups, table, item(say("menu.request"), showRequest), toEmbed);
  pictureGroup.hidden = !hasPicture;
  (panel.querySelector(".panel-head") ?? panel).append(button, menu);

  menu.addEventListener("beforetoggle", () => {
    const isHere = saved.isHere();
    dataGroup.hidden = !isHere;
    pictureGroup.hidden = !hasPicture || !isHere;
    table.hidden = !picture.table || !isHere;
    for (const { form, link } of data) {
      link.href = addressOf(saved.request(form), load.server);
      link.download = saved.fileName(form.format);
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

  /** @param {"png" | "svg"} format */
  async function save(format) {
    const saving = await import("./save-drawing.js").catch(() => null);
    if (!saving) {
      load.reportLost(say("server.saverMissing"));
      return;
    }
    const files = await saving.savedPicture(saved, load.font);
    if (files) {
      download(await files[format](), saved.fileName(format));
    }
  }

  function showRequest() {
    const request = picture.request();
    const server = load.server || serverOf(location.href);
    openSheet(say("menu.requestOf", { title: picture.title }), [
      codeBlock("curl", curlOf(request, server)),
      codeBlock("Python", pythonOf(request, server)),
    ]);
  }

  return saved;
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
