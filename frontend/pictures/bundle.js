// @ts-check

import { PLAIN_SYMBOLS, TEXT_SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import { savedPicture } from "./save-drawing.js";
import { zipOf } from "./zip.js";

/**
 * @typedef {import("./panel-picture.js").PanelPicture} PanelPicture
 * @typedef {import("../state/address/options.js").PageState} PageState
 * @typedef {{name: string, content: Blob | string, title: string}} File
 */

/** Below a line of units, as "CSV + units" of a menu. */
const TABLE = { format: "csv", header: "units" };

/** Calls that answer with one row, the numbers of a collision. */
const RESULTS = ["collision", "scaling"];

/** @type {Record<string, string>} */
const SYMBOLS = { ...PLAIN_SYMBOLS, ...TEXT_SYMBOLS };

/**
 * All that is shown as one ZIP: state and results, the link, table and pictures of each panel. A table
 * that is not to be had now is left out, and the ZIP says so.
 * @param {object} shown
 * @param {PageState} shown.state
 * @param {string} shown.link
 * @param {PanelPicture[]} shown.panels
 * @param {import("./picture-menu.js").Load} shown.load
 * @returns {Promise<{zip: Blob, lack: string}>} with what it lacks in words
 */
export async function bundle({ state, link, panels, load }) {
  const time = new Date();
  const answerTo = untilSilent(load.file);
  /** @type {File[]} */
  const files = [];
  /** @type {string[]} */
  const missing = [];
  /** @type {Record<string, object>} */
  const results = {};
  // All at this moment, for the page may be steered on meanwhile.
  const subjects = panels.map(subjectOf);
  const pictures = await Promise.all(
    panels.map((panel) => (panel.hasPicture ? savedPicture(panel, load.font) : null)),
  );
  for (const [i, { title, names, call, table, row }] of subjects.entries()) {
    const content = await answerTo(table);
    if (content) {
      files.push({ name: names.csv, content, title });
    } else {
      missing.push(title);
    }
    const numbers = row && (await answerTo(row));
    if (numbers) {
      results[call] = valuesIn(await numbers.text());
    }
    const picture = pictures[i];
    if (picture) {
      files.push({ name: names.svg, content: await picture.svg(), title });
      files.push({ name: names.png, content: await picture.png(), title });
    }
  }
  const own = [
    { name: "link.txt", content: `${link}\n`, title: say("bundle.link") },
    {
      name: "state.json",
      content: `${JSON.stringify(stateInWords(state, link, time, results), null, 2)}\n`,
      title: say("bundle.state"),
    },
  ];
  const all = [...own, ...files];
  const lack = missing.length > 0 ? say("bundle.without", { titles: missing.join(", ") }) : "";
  const readme = readmeOf({ scene: state.scene, link, time, panels, files: all, lack });
  return { zip: await zipOf([{ name: "README.txt", content: readme }, ...all], time), lack };
}

/**
 * Asks as long as somebody answers: each request would else be waited for as long again.
 * @param {import("./picture-menu.js").Load["file"]} file
 */
function untilSilent(file) {
  let isSilent = false;
  return async (/** @type {import("../format/requests.js").Request} */ request) => {
    if (isSilent) {
      return null;
    }
    try {
      return await file(request);
    } catch (error) {
      // A refusal has a status, and is of one request.
      isSilent = !(error instanceof Error && "status" in error);
      return null;
    }
  };
}

/**
 * What is asked for a panel, and what it is called.
 * @param {PanelPicture} panel
 */
function subjectOf({ picture: { title }, request, fileName }) {
  const table = request(TABLE);
  return {
    title,
    names: { csv: fileName("csv"), svg: fileName("svg"), png: fileName("png") },
    call: table.call,
    table,
    row: RESULTS.includes(table.call) ? request({ ...TABLE, separator: "tab" }) : null,
  };
}

/**
 * What the page shows, for a program.
 * @param {PageState} state
 * @param {string} link
 * @param {Date} time
 * @param {Record<string, object>} results
 */
function stateInWords(state, link, time, results) {
  const parameters = Object.entries(state.collision).map(([name, value]) => [
    name,
    { symbol: SYMBOLS[name], value, unit: "1" },
  ]);
  return {
    saved: time.toISOString(),
    link,
    options: Object.fromEntries(new URLSearchParams(link.replace(/^[^?]*/, ""))),
    parameters: Object.fromEntries(parameters),
    results,
  };
}

/**
 * The values of a table with one row, each with its unit, and its symbol where the page has one.
 * @param {string} table a line of units, one of names, one of values
 */
function valuesIn(table) {
  const [units, names, values] = table.split(/\r?\n/).map((line) => line.split("\t"));
  units[0] = units[0].replace(/^# /, "");
  const entries = names.map((name, i) => {
    const symbol = SYMBOLS[name.replace(/^.*\./, "")];
    // Over the convention stands the convention.
    const unit = name === "convention" ? "" : units[i];
    return [name, { ...(symbol && { symbol }), value: valueOf(values[i]), ...(unit && { unit }) }];
  });
  return Object.fromEntries(entries);
}

/** @param {string} text a number, a truth, or a word; nothing where there is none */
function valueOf(text) {
  const isJson = /^(true|false|-?\d+(\.\d+)?(e[+-]?\d+)?)$/i.test(text);
  return isJson ? JSON.parse(text) : text || null;
}

/**
 * What is in it, for a reader.
 * @param {object} contents
 * @param {string} contents.scene
 * @param {string} contents.link
 * @param {Date} contents.time
 * @param {PanelPicture[]} contents.panels
 * @param {File[]} contents.files
 * @param {string} contents.lack
 */
function readmeOf({ scene, link, time, panels, files, lack }) {
  const [result] = [panels.find(({ name }) => name === "result")?.picture.table?.()].flat();
  // Words may be divided on the page alone.
  const rows = result?.rows.map((row) => row.join(" = ").replaceAll("\u00ad", "")) ?? [];
  return [
    `Restitution · ${say(`page.scenes.${scene}`)}`,
    time.toLocaleString(document.documentElement.lang),
    "",
    ...(result ? [result.caption, ...rows, ""] : []),
    say("bundle.link"),
    `  ${link}`,
    "",
    say("bundle.files"),
    ...files.map(({ name, title }) => `  ${name} (${title})`),
    "",
    say("bundle.units"),
    ...(lack ? [lack] : []),
    "",
    `${say("bundle.after")} T. Schwager, V. Becker, T. Pöschel, Eur. Phys. J. E 27, 107 (2008), doi:10.1140/epje/i2007-10356-3`,
    "",
  ].join("\n");
}
