// @ts-check

import { say } from "../../../format/words.js";
import { significant } from "../../../format/number.js";
import { bounceOf, sameCollision } from "../../../state/parameters.js";
import { byTestId, find } from "../../../widgets/find.js";
import { calm } from "../../../widgets/motion.js";
import { afterNextFrame } from "../../../widgets/painted.js";
import { writeAttribute } from "../../../widgets/write.js";
import { clockOf, phaseAt, shareAt } from "./clock.js";
import { contactMotion, mirrored, stateAt } from "./contact-motion.js";
import { mountBallControls } from "./controls.js";
import { bounceInWords, motionsOf } from "./motions.js";
import { mountNumbers } from "./numbers.js";
import { mountPicture } from "./picture.js";
import { createPlayback } from "./playback.js";
import { mountRibbon } from "./ribbon.js";
import { REGIME_KEYS } from "./view.js";

/**
 * @typedef {import("../../../api/answers.js").Bounces} Bounces
 * @typedef {import("../../../state/loading/collision-load.js").LoadedBall} LoadedBall
 */

/**
 * The bounce at two scales: the flight of the ball, and the contact that the camera goes into.
 * @param {HTMLElement} panel
 * @param {object} handlers
 * @param {(share: number | null) => void} handlers.onShare told every instant of the first contact that it shows, null in flight
 * @param {import("../../scene.js").Page["set"]} handlers.onOption
 */
export function mountBounce(panel, { onShare, onOption }) {
  const stage = find(".bounce-stage", panel);
  const picture = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (byTestId("bounce", panel)));
  const reason = byTestId("bounce-reason", panel);
  const playButton = byTestId("bounce-play", panel);
  const scrub = /** @type {HTMLInputElement} */ (byTestId("bounce-time", panel));
  const template = /** @type {HTMLTemplateElement} */ (find("#bounce-view", panel)).content;
  const numbers = mountNumbers(byTestId("bounce-numbers", panel));
  const ribbon = mountRibbon(find(".bounce-ribbon", panel));
  const controls = mountBallControls(panel, onOption);
  const view = mountPicture(picture, template);

  /** @type {import("../../../state/address/options.js").PageState | null} */
  let state = null;
  /** @type {LoadedBall | null} */
  let ball = null;
  /** @type {{epsilonT: number, epsilonN: number, isExact: boolean} | null} */
  let result = null;
  /** About the collision, where it has a trace. */
  let sentence = "";
  /** @type {(import("./contact-motion.js").Motion | null)[]} */
  const contacts = [null, null];
  /** @type {import("./motions.js").Motion[] | null} */
  let motions = null;
  /** @type {import("../../../figures/plot-area.js").Size | null} */
  let size = null;
  let clock = clockOf(1);
  let isWaiting = false;
  /** Whether ε_t is what the map has for the present collision. */
  let isFromMap = false;
  /** Whether it plays by itself, as it does once. */
  let isGentle = false;

  const playback = createPlayback({
    onShare: drawInstant,
    onPlaying(isPlaying) {
      playButton.toggleAttribute("data-playing", isPlaying);
      playButton.setAttribute("aria-label", say(isPlaying ? "bounce.pause" : "bounce.play"));
      describe();
    },
    nextFrame: (task) => requestAnimationFrame(task),
    duration: () => clock.duration,
    initial: 1,
  });

  /** Every other frame, whatever has changed: numbers and curves go first, each frame of a drag. */
  function redraw() {
    if (!isWaiting) {
      isWaiting = true;
      afterNextFrame(() =>
        afterNextFrame(() => {
          isWaiting = false;
          draw();
        }),
      );
    }
  }

  function draw() {
    // Where it is not shown it has no width.
    if (!state || !ball || !result || !size?.width) {
      return;
    }
    motions = allMotions(state, ball, result);
    numbers.show(motions, result.isExact);
    const { partner, times } = chosen();
    const phase = phaseAt(clock.stretches, playback.share());
    view.draw(
      { motions, times, isWall: partner === "wall", contacts: contacts.slice(0, times) },
      size,
      isResting() ? null : phase,
    );
    tell(phase);
    describe();
  }

  /** Whether nothing is to move, nor has been moved by a hand. */
  function isResting() {
    return calm.matches && !playback.isPlaying() && playback.share() === 1;
  }

  const chosen = () => bounceOf(state?.bounce);

  function drawInstant() {
    const phase = phaseAt(clock.stretches, playback.share());
    if (view.areStills() === isResting()) {
      view.drawInstant(phase);
      tell(phase);
    } else {
      draw();
    }
  }

  /** Says where the clock stands. @param {ReturnType<typeof phaseAt>} phase */
  function tell(phase) {
    const isFirst = phase.kind === "contact" && phase.index === 0;
    scrub.valueAsNumber = 1000 * playback.share();
    onShare(isFirst ? phase.progress : null);
    if (!playback.isPlaying()) {
      scrub.setAttribute("aria-valuetext", whereItIs(phase));
    }
  }

  /** @param {ReturnType<typeof phaseAt>} phase */
  function whereItIs({ kind, index, progress }) {
    const motion = contacts[index];
    if (kind === "flight") {
      const { times } = chosen();
      const after = index === times ? "bounce.goingOut" : "bounce.between";
      return say(index === 0 ? "bounce.comingIn" : after);
    }
    if (!motion) {
      return say("bounce.atTouch");
    }
    const duration = motion.trace.contact_duration;
    const time = progress * duration;
    return say("bounce.inContact", {
      time: significant(time, 3),
      duration: significant(duration, 3),
      regime: say(REGIME_KEYS[stateAt(motion, time).regime]),
    });
  }

  function showClock() {
    if (size) {
      const traces = Array.from({ length: chosen().times }, (_, i) => contacts[i]?.trace ?? null);
      ribbon.show(clock.stretches, traces, size.width);
    }
  }

  function describe() {
    if (motions && !playback.isPlaying()) {
      const words = [bounceInWords(motions), sentence].join(" ").trim();
      writeAttribute(picture, "aria-label", words);
    }
  }

  playButton.addEventListener("click", () => {
    isGentle = false;
    if (playback.isPlaying()) {
      playback.pause();
    } else {
      playback.play();
    }
  });
  scrub.addEventListener("input", () => playback.seek(scrub.valueAsNumber / 1000));
  byTestId("bounce-speed", panel).addEventListener("change", ({ target }) => {
    playback.setSpeed(Number(/** @type {HTMLInputElement} */ (target).value));
  });
  calm.addEventListener("change", redraw);
  playButton.setAttribute("aria-label", say("bounce.play"));
  scrub.setAttribute("aria-label", say("bounce.time"));
  new ResizeObserver(([{ contentRect }]) => {
    const unit = Number.parseFloat(getComputedStyle(stage).fontSize) / 12;
    size = { width: contentRect.width / unit, height: contentRect.height / unit };
    picture.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    // Not by shares of the stage, whose height the browser tries twice whenever a number of the page changes.
    picture.setAttribute("width", String(contentRect.width));
    picture.setAttribute("height", String(contentRect.height));
    showClock();
    redraw();
  }).observe(stage);

  return {
    /** What is known at once. @param {import("../../../state/address/options.js").PageState} next */
    show(next) {
      const isOther = next.bounce !== state?.bounce;
      // Whoever moves something wants to see the way out.
      if (isGentle && state && !sameCollision(next.collision, state.collision)) {
        isGentle = false;
        playback.seek(1);
      }
      state = next;
      controls.show(next);
      if (isOther) {
        clock = clockOf(chosen().times);
        showClock();
      }
      redraw();
    },

    /**
     * ε_t as the map has it, of a collision that the server has not answered yet; null where the map does not know.
     * @param {number | null} epsilonT
     */
    preview(epsilonT) {
      isFromMap = epsilonT !== null;
      if (epsilonT !== null) {
        result = { epsilonT, epsilonN: result?.epsilonN ?? 1, isExact: false };
      }
      redraw();
    },

    /** @param {LoadedBall} loaded */
    showBall(loaded) {
      ball = loaded;
      const { trace: second, answer } = loaded;
      const isBack = answer.second?.direction === -1;
      contacts[1] = second && contactMotion(isBack ? mirrored(second) : second);
      reason.textContent =
        chosen().times === 2 && !loaded.answer.second ? say("bounce.noSecond") : "";
      showClock();
      redraw();
    },

    /**
     * @param {import("../../../state/loading/collision-load.js").LoadedCollision} answer
     * @param {boolean} isPresent whether it is of the present collision, and not of one a moment ago
     */
    settle({ result: settled, trace, sentence: told }, isPresent) {
      if (isPresent || !isFromMap) {
        const { epsilon_t: epsilonT, epsilon_n: epsilonN } = trace ?? settled;
        result = { epsilonT, epsilonN, isExact: isPresent };
      }
      sentence = trace ? told : "";
      contacts[0] = trace && contactMotion(trace);
      showClock();
      redraw();
    },

    /** What is drawn, for the table of it. */
    motions: () => motions,

    /** Where a hand points in a trace; what plays is left alone. @param {number} share of the contact */
    point(share) {
      if (!playback.isPlaying()) {
        isGentle = false;
        playback.seek(shareAt(clock.stretches, 0, share));
      }
    },

    /** Once, for those who have not asked for rest. */
    playGently() {
      if (!calm.matches) {
        isGentle = true;
        playback.play();
      }
    },
  };
}

/**
 * The motions that are known: the last of two bounces once the server has answered for this collision.
 * @param {import("../../../state/address/options.js").PageState} state
 * @param {LoadedBall} ball
 * @param {{epsilonT: number, epsilonN: number}} result
 */
function allMotions({ collision, spin_share, bounce }, { answer, collision: of }, result) {
  const { second } = answer;
  const isKnown = bounce === "wall_twice" && sameCollision(of, collision);
  const collided = [{ gtOverGn: collision.gt_over_gn, ...result }];
  if (isKnown && second) {
    collided.push({
      gtOverGn: second.direction * second.gt_over_gn,
      epsilonT: second.epsilon_t,
      epsilonN: second.epsilon_n,
    });
  }
  return motionsOf(answer, spin_share, collided);
}
