// @ts-check

import { valueAt } from "../../figures/sample.js";
import { significant } from "../../format/number.js";
import { clamp } from "../../state/scales.js";
import { byTestId, find } from "../../widgets/find.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { sphereCutFigure } from "./sphere-cut-figure.js";

/**
 * @typedef {import("../../api/answers.js").VelocityMap} VelocityMap
 * @typedef {ReturnType<typeof import("../../state/impact.js").velocityView>} VelocityView
 * @typedef {{map: VelocityMap, view: VelocityView}} ShownVelocities
 */

/**
 * ε_t over the tangential velocity at the present normal one, and what was measured of the material.
 * @param {HTMLElement} element
 */
export function mountSphereCut(element) {
  const plot = createPlot(find(".plot", element), sphereCutFigure);
  const stage = find(".plot-stage", element);
  const key = byTestId("measured-key", element);

  return {
    /**
     * @param {ShownVelocities} cut of one normal velocity
     * @param {import("../../state/impact.js").Material} material
     * @param {{velocity: number, epsilon: number} | null} here the present impact
     * @param {boolean} dragging
     */
    show({ map, view: { tangential, scale } }, material, here, dragging) {
      const normal = map.normal_velocity_m_s[0];
      const subject = {
        curves: {
          epsilon_t: map.epsilon_t.map((row) => row[0]),
          coulomb: map.coulomb.map((row) => row[0]),
        },
        tangential,
        scale,
        // Measured at another normal velocity, a point stands at the same angle.
        measured: (material.measured?.points ?? []).map((point) => ({
          share: tangential.toShare(
            normal * (point.tangential_velocity_m_s / point.normal_velocity_m_s),
          ),
          epsilon_t: point.epsilon_t,
        })),
        here: here && {
          share: tangential.toShare(here.velocity),
          velocity: `g_t = ${significant(here.velocity)} m/s`,
          epsilon_t: here.epsilon,
        },
      };
      plot.show(subject, dragging);
      key.hidden = !material.measured;
    },

    /** @param {string} reason */
    showReason: (reason) => showReason(stage, reason),
  };
}

/**
 * The ε_t of the present impact by the law that is shown: the spring's as answered, Coulomb's read off
 * its curve.
 * @param {import("../../api/answers.js").Scaling} scaling
 * @param {ShownVelocities | null} cut
 * @param {string} law
 */
export function epsilonBy(scaling, cut, law) {
  if (law !== "coulomb" || !cut) {
    return scaling.epsilon_t;
  }
  const curve = cut.map.coulomb.map((row) => row[0]);
  return valueAt(curve, clamp(cut.view.tangential.toShare(scaling.tangential_velocity_m_s)));
}
