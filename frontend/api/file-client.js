// @ts-check

import { NeedsServer } from "./client.js";

/**
 * What a page that is one file holds of what others ask the server for.
 * @typedef {object} Contents
 * @property {string} language the usual one
 * @property {{id: string, name: string}[]} languages
 * @property {Record<string, {first: Record<string, any>, later: Record<string, any>}>} texts by their languages:
 *   those of the first view, and those that come later
 * @property {import("./answers.js").Preset[]} presets
 * @property {string} server where one usually is, for requests that are shown
 * @property {string} kernel kernel.wasm in base64
 */

/** @typedef {ReturnType<typeof import("./client.js").createClient>} Client */

/**
 * A client that asks nobody: what was written into the file it reads, what is computed the kernel answers.
 * @param {Contents} contents
 * @param {import("../state/loading/source.js").Answers} answers
 * @returns {Client}
 */
export function createFileClient(contents, answers) {
  const { texts, presets } = contents;
  const needed = async () => {
    throw new NeedsServer();
  };

  return {
    collision: certain(answers.collision),
    isAnswering: async () => {},
    trace: certain(answers.trace),
    bounce: certain(answers.bounce),
    map: certain(answers.map),
    cut: certain(answers.cut),

    words: async (language) => texts[language].later,
    presets: async () => presets,
    kernel: () => kernelOf(contents),
    font: async (address) => blobOf(address),

    answer: needed,
    stepped: needed,
    steps: needed,
    errorMap: needed,
    tradeoff: needed,
    startRun: needed,
    run: needed,
    cancelRun: needed,
    materials: needed,
    scaling: needed,
    codes: needed,
    velocityMap: needed,
    paper: needed,
    columns: needed,
    file: needed,
  };
}

/**
 * An answer, or that it takes a server.
 * @template {unknown[]} Asked, Answer
 * @param {(...asked: Asked) => Promise<Answer | null>} answer
 */
function certain(answer) {
  return async (/** @type {Asked} */ ...asked) => {
    const found = await answer(...asked);
    if (found === null) {
      throw new NeedsServer();
    }
    return found;
  };
}

/** What an address holds in base64. @param {string} address */
function blobOf(address) {
  const [, type, text] = /** @type {RegExpExecArray} */ (
    /^data:([^;]+);base64,(.*)$/.exec(address)
  );
  return new Blob([bytesOf(text)], { type });
}

/** @param {Contents} contents */
export function kernelOf({ kernel }) {
  return WebAssembly.compile(bytesOf(kernel));
}

/** @param {string} text in base64 */
function bytesOf(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}
