// @ts-check

import { afterNextFrame } from "../painted.js";

/** So long, in ms, it waits at most for a moment without work. */
const PAUSE = 200;

/** @type {Promise<void> | null} */
let coming = null;

/** Resolves once Plotly has run. */
export function plotlyIsHere() {
  const text = document.querySelector("#plotly")?.textContent;
  coming ??= new Promise((resolve) => (text ? runLater(text, resolve) : waitForScripts(resolve)));
  return coming;
}

/**
 * Where the page is one file, after what needs no plot is there: it takes longer than all else.
 * @param {string} text
 * @param {() => void} onDone
 */
function runLater(text, onDone) {
  // not everywhere yet
  const idle =
    globalThis.requestIdleCallback ?? ((/** @type {() => void} */ task) => setTimeout(task, PAUSE));
  afterNextFrame(() =>
    idle(
      () => {
        const script = document.createElement("script");
        script.text = text;
        document.head.append(script);
        onDone();
      },
      { timeout: PAUSE },
    ),
  );
}

/** It is among the deferred scripts of the page. @param {() => void} onDone */
function waitForScripts(onDone) {
  if (document.readyState === "complete") {
    onDone();
  } else {
    addEventListener("DOMContentLoaded", onDone, { once: true });
    addEventListener("load", onDone, { once: true });
  }
}
