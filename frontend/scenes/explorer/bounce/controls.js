// @ts-check

import { say } from "../../../format/words.js";
import { SPIN_SHARE } from "../../../state/parameters.js";
import { choose } from "../../../widgets/choices.js";
import { byTestId, find } from "../../../widgets/find.js";
import { nameSweepButton } from "../../../widgets/sweep-buttons.js";

/**
 * What the ball bounces off, how often, and how much of g_t is spin.
 * @param {HTMLElement} panel
 * @param {import("../../scene.js").Page["set"]} onOption
 */
export function mountBallControls(panel, onOption) {
  const slider = /** @type {HTMLInputElement} */ (byTestId("spin-share", panel));
  const quick = [
    .../** @type {NodeListOf<HTMLInputElement>} */ (
      byTestId("spin-choices", panel).querySelectorAll("input")
    ),
  ];
  byTestId("bounce-partner", panel).addEventListener("change", ({ target }) => {
    onOption({ bounce: /** @type {HTMLInputElement} */ (target).value });
  });
  byTestId("spin-choices", panel).addEventListener("change", ({ target }) => {
    onOption({ spin_share: Number(/** @type {HTMLInputElement} */ (target).value) });
  });
  for (const [kind, dragging] of /** @type {[string, boolean][]} */ ([
    ["input", true],
    ["change", false],
  ])) {
    slider.addEventListener(kind, ({ timeStamp }) => {
      onOption({ spin_share: slider.valueAsNumber }, { dragging, inputTimeStamp: timeStamp });
    });
  }
  nameSweepButton(
    /** @type {HTMLButtonElement} */ (byTestId("spin-share-sweep", panel)),
    SPIN_SHARE.key,
    say("bounce.spinShare"),
  );
  slider.setAttribute(
    "aria-label",
    find("legend", byTestId("spin-choices", panel)).textContent ?? "",
  );

  return {
    /** @param {import("../../../state/address/options.js").PageState} state */
    show({ bounce, spin_share: share }) {
      choose(panel, { bounce });
      slider.valueAsNumber = share;
      slider.setAttribute(
        "aria-valuetext",
        say("bounce.shareValue", { percent: Number((100 * share).toPrecision(3)) }),
      );
      quick.forEach((choice) => {
        choice.checked = Number(choice.value) === share;
      });
    },
  };
}
