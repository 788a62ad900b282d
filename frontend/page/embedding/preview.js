// @ts-check

import { say } from "../../format/words.js";
import { make } from "../../widgets/elements.js";
import { typeset } from "../../widgets/typeset.js";

/** Smaller than this it could not be read. */
const LEAST_SCALE = 0.4;

/** Of the window's height, so that the text to be copied is in sight. */
const SHARE = 0.6;

/**
 * What a frame says of itself, as soon as it is there.
 * @typedef {{height: number, names: string[]}} Told
 */

/**
 * A frame as another page shows it, in a sandbox, where it may run scripts alone. What is larger than its
 * place is shown smaller.
 * @param {object} handlers
 * @param {() => void} handlers.onSize told when the frame has said something
 */
export function createPreview({ onSize }) {
  const heading = make("h3", "");
  const place = make("div", "builder-preview");
  const element = make("div", "", heading, place);
  /** @type {HTMLIFrameElement | null} */
  let frame = null;
  let shown = "";
  /** @type {Told | null} */
  let told = null;
  /** That of the last frame stays until the next one tells its own. @type {number | null} */
  let height = null;
  let size = { width: 1, height: 1 };

  /** A new frame, for to send one elsewhere would be a step of the browser's history. */
  function renew() {
    const next = make("iframe", "");
    next.sandbox.add("allow-scripts");
    next.src = shown;
    frame = next;
    told = null;
    place.replaceChildren(next);
  }

  addEventListener("message", ({ data, source }) => {
    const asked = frame;
    if (asked && source === asked.contentWindow && data === "restitution-frame") {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = (event) => {
        if (frame === asked) {
          told = event.data;
          height = told?.height ?? null;
          onSize();
        }
      };
      asked.contentWindow?.postMessage("restitution-size", "*", [port2]);
    }
  });

  function scale() {
    const { width, height: whole } = size;
    if (frame && element.clientWidth > 0) {
      const room = Math.min(element.clientWidth / width, (SHARE * innerHeight) / whole);
      const share = Math.max(LEAST_SCALE, Math.min(1, room));
      Object.assign(frame.style, { width: `${width}px`, height: `${whole}px`, scale: `${share}` });
      place.style.width = `${Math.min(element.clientWidth, share * width)}px`;
      place.style.height = `${share * whole}px`;
      const percent = Math.round(100 * share);
      typeset(heading, say(share < 1 ? "embedding.scaled" : "embedding.preview", { percent }));
    }
  }
  new ResizeObserver(scale).observe(element);

  return {
    element,

    /**
     * @param {string} address
     * @returns {{height: number | null, names: string[] | null}} what is known of it
     */
    load(address) {
      if (address !== shown) {
        shown = address;
        renew();
      }
      return { height, names: told?.names ?? null };
    },

    /** @param {{title: string, width: number, height: number}} wanted */
    show({ title, ...wanted }) {
      if (frame) {
        frame.title = title;
      }
      size = wanted;
      scale();
    },

    end() {
      shown = "";
      frame = null;
      place.replaceChildren();
    },
  };
}
