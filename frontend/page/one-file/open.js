// @ts-check

import { createFileClient, kernelOf } from "../../api/file-client.js";
import { serverAlone } from "../../state/loading/collision-load.js";
import { find } from "../../widgets/find.js";
import { afterNextFrame } from "../../widgets/painted.js";
import { answersBy } from "../kernel.js";

/** So long, in ms, Plotly waits at most for a moment without work: it takes longer than all else. */
const PAUSE = 200;

/** Not everywhere yet. */
const idle =
  globalThis.requestIdleCallback ?? ((/** @type {() => void} */ task) => setTimeout(task, PAUSE));

/** @typedef {import("../../api/file-client.js").Contents} Contents */

/** Scenes that are nothing without a server. */
const SERVED = ["spheres", "accuracy", "paper"];

/**
 * What a page that is one file has instead of a server: the kernel answers.
 * @param {Contents} contents
 * @param {string} search
 */
export async function openFile(contents, search) {
  const answers = await answersBy(kernelOf(contents));
  afterNextFrame(() => idle(runPlotly, { timeout: PAUSE }));
  const client = createFileClient(contents, answers);
  return {
    words: wordsOfFile(contents, search),
    client,
    source: { ...serverAlone(client), isNear: () => true },
    server: contents.server,
    standIns: Object.fromEntries(SERVED.map((id) => [id, () => standIn(id)])),
  };
}

/**
 * The words in the language of an address, else the first that the reader has, else the usual one.
 * @param {Contents} contents
 * @param {string} search
 * @returns {import("../../format/words.js").Words}
 */
function wordsOfFile({ language: usual, languages, texts }, search) {
  const preferred = navigator.languages.map((name) => name.split("-")[0]);
  const wanted = [new URLSearchParams(search).get("lang") ?? "", ...preferred];
  const language = wanted.find((name) => Object.hasOwn(texts, name)) ?? usual;
  document.documentElement.lang = language;
  return { language, languages, texts: { ...texts[language].first, ...texts[language].later } };
}

/** What mounts a scene that is nothing without a server. @param {string} id */
async function standIn(id) {
  const { mountStandIn } = await import("./stand-in.js");
  return (/** @type {import("../../scenes/scene.js").Page} */ page) => mountStandIn(id, page);
}

/** After what needs no plot is there. */
function runPlotly() {
  const script = document.createElement("script");
  script.text = find("#plotly").textContent ?? "";
  document.head.append(script);
  dispatchEvent(new Event("restitution:plotly"));
}
