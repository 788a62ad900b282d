// @ts-check

import { brief, significant } from "../../format/number.js";
import { sentenceOf } from "../../format/sentence.js";
import { byTestId, find } from "../../widgets/find.js";
import { currentTheme } from "../../widgets/theme.js";
import { write } from "../../widgets/write.js";
import { contactScene } from "./contact-drawing.js";
import { contactMotion } from "./contact-motion.js";
import { createPlayback } from "./playback.js";

const WORDS = { forward: "slides →", backward: "← slides back", sticking: "sticks" };
/** Where it rests on a page that nobody has touched: the spring is wound up there. */
const TELLING_SHARE = 0.42;
/** How long the end is shown before it goes back there, in ms. */
const REST = 900;

/**
 * The two surfaces in contact with their spring, to play, to pause and to move to and fro in time.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(share: number) => void} handlers.onShare told every instant that it shows
 */
export function mountContactAnimation(element, { onShare }) {
  const stage = find(".contact-stage", element);
  const picture = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (find("svg", stage)));
  const playButton = byTestId("contact-play", element);
  const scrub = /** @type {HTMLInputElement} */ (byTestId("contact-time", element));
  const part = (/** @type {string} */ name) => find(`.contact-${name}`, stage);
  const [ball, spring, shoe, ground, trackGroup] = [
    "ball",
    "spring",
    "shoe",
    "ground",
    "tracks",
  ].map(part);
  const arrows = { normal: part("normal"), tangential: part("tangential") };
  const labels = { normal: part("normal-label"), tangential: part("tangential-label") };
  const anchor = part("anchor");
  const teeth = part("teeth");
  const word = part("word");
  const enlarged = part("enlarged");
  /** @type {import("./contact-motion.js").Motion | null} */
  let motion = null;
  /** @type {import("../../figures/plot-area.js").Size | null} */
  let size = null;
  let isGentle = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;

  const playback = createPlayback({
    onShare(share) {
      draw();
      onShare(share);
    },
    onPlaying(isPlaying) {
      playButton.toggleAttribute("data-playing", isPlaying);
      playButton.setAttribute("aria-label", isPlaying ? "Pause" : "Play the contact");
      describe();
      if (isGentle && !isPlaying) {
        rest = setTimeout(() => playback.seek(TELLING_SHARE), REST);
      }
    },
    nextFrame: (task) => requestAnimationFrame(task),
    initial: TELLING_SHARE,
  });

  function draw() {
    const share = playback.share();
    scrub.valueAsNumber = 1000 * share;
    if (!motion || !size) {
      return;
    }
    const scene = contactScene(motion, share, size);
    picture.dataset.regime = scene.regime;
    ball.setAttribute("d", scene.ball);
    ground.setAttribute("y", String(scene.ground));
    spring.setAttribute("d", scene.spring);
    place(anchor, { cx: scene.anchor.x, cy: scene.anchor.y });
    const { x, y, width } = scene.shoe;
    place(shoe, { x: x - width / 2, y });
    teeth.setAttribute("transform", `translate(${x.toFixed(2)},${scene.ground})`);
    const { normalArrow, tangentialArrow } = scene;
    arrows.normal.setAttribute("d", normalArrow.path);
    arrows.tangential.setAttribute("d", tangentialArrow.path);
    labels.normal.toggleAttribute("hidden", normalArrow.path === "");
    labels.tangential.toggleAttribute("hidden", tangentialArrow.path === "");
    // Each on its own side, so that they are apart where the forces are small.
    const isLeft = scene.tangentialForce < 0;
    place(labels.normal, { x: normalArrow.tip.x + (isLeft ? 8 : -20), y: normalArrow.tip.y + 6 });
    place(labels.tangential, {
      x: tangentialArrow.tip.x + (isLeft ? -34 : 7),
      y: tangentialArrow.tip.y + 4,
    });
    place(enlarged, { x: size.width - 10, y: size.height - 10 });
    drawTracks(scene.tracks);
    write(word, WORDS[scene.regime]);
    write(
      enlarged,
      scene.enlarged > 1.5 && scene.enlarged < 1e6
        ? `stretch drawn × ${brief(rounded(scene.enlarged))}`
        : "",
    );
    if (!playback.isPlaying()) {
      scrub.setAttribute(
        "aria-valuetext",
        `t ${significant(scene.instant, 3)} of ${significant(motion.trace.contact_duration, 3)}, ${WORDS[scene.regime]}`,
      );
    }
  }

  /** @param {ReturnType<typeof contactScene>["tracks"]} tracks */
  function drawTracks(tracks) {
    const lines = [...trackGroup.children];
    for (const line of lines.slice(tracks.length)) {
      line.remove();
    }
    for (const [i, { regime, from, to, y }] of tracks.entries()) {
      const line =
        lines[i] ?? trackGroup.appendChild(document.createElementNS(picture.namespaceURI, "line"));
      line.setAttribute("class", regime);
      place(line, { x1: from, x2: to, y1: y, y2: y });
    }
  }

  function describe() {
    if (motion && !playback.isPlaying()) {
      picture.setAttribute(
        "aria-label",
        `A ball pressed on a plane, joined by a spring to the foot it drags along. ${sentenceOf(motion.trace)}`,
      );
    }
  }

  /** Gives up showing itself: someone has taken over. */
  function endGentle() {
    clearTimeout(rest);
    isGentle = false;
  }

  playButton.addEventListener("click", () => {
    endGentle();
    if (playback.isPlaying()) {
      playback.pause();
    } else {
      playback.play();
    }
  });
  scrub.addEventListener("input", () => {
    endGentle();
    playback.seek(scrub.valueAsNumber / 1000);
  });
  byTestId("contact-speed", element).addEventListener("change", (event) => {
    playback.setSpeed(Number(/** @type {HTMLInputElement} */ (event.target).value));
  });
  const observer = new ResizeObserver(([{ contentRect }]) => {
    const { unit } = currentTheme();
    size = { width: contentRect.width / unit, height: contentRect.height / unit };
    picture.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    draw();
  });
  observer.observe(stage);
  onShare(TELLING_SHARE);

  return {
    /** @param {import("../../api/answers.js").Trace} trace */
    show(trace) {
      motion = contactMotion(trace);
      stage.removeAttribute("data-reason");
      draw();
    },

    showNothing() {
      playback.pause();
      stage.toggleAttribute("data-reason", true);
    },

    describe,

    /** Where it had moved by itself, it goes back to rest. */
    pause: playback.pause,

    /** Where a hand points in a trace; what plays is left alone. @param {number} share */
    point(share) {
      if (!playback.isPlaying()) {
        endGentle();
        playback.seek(share);
      }
    },

    /** Once, for those who have not asked for rest. */
    playGently() {
      if (motion && !matchMedia("(prefers-reduced-motion: reduce)").matches) {
        playback.seek(0);
        playback.play();
        isGentle = true;
      }
    },
  };
}

/**
 * @param {Element} element
 * @param {Record<string, number>} attributes
 */
function place(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, value.toFixed(2));
  }
}

/** To one digit. @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(1));
}
