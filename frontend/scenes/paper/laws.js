// @ts-check

/** The frictions whose curves fall on one another over ψ, at a κ as of solid spheres. */
const FRICTIONS = [0.5, 1.4, 3.5];
const COLLAPSE = { kappa: 5, lowest: 0.01, highest: 3, count: 600 };

/** Each ψ of the stiff springs that are looked at. */
const STIFF_PSIS = [0.2, 0.5, 1, 1.5, 1.9];

/** What `/cut` is asked for ε_t at the same ψ and several μ/α. */
function collapseQueries() {
  const { kappa, lowest, highest, count } = COLLAPSE;
  return FRICTIONS.map((friction) => ({
    along: "gt_over_gn",
    kappa: String(kappa),
    mu_over_alpha: String(friction),
    minimum: String(lowest * friction),
    maximum: String(highest * friction),
    count: String(count),
    quantities: "epsilon_t",
  }));
}

/** What `/cut` is asked for stiff springs; at μ/α = 1, g_t/g_n is ψ. */
function stiffLawQueries() {
  return STIFF_PSIS.map((psi) => ({
    along: "kappa",
    mu_over_alpha: "1",
    gt_over_gn: String(psi),
    minimum: "2",
    maximum: "1e5",
    count: "300",
    scale: "log",
    quantities: "epsilon_t,stiff_bound,stiff_asymptote",
  }));
}

/** What `/map` is asked for the largest number of switches at each κ. */
function switchLawQuery() {
  return {
    mu_over_alpha: "1",
    kappa_min: "10",
    kappa_max: "1e4",
    kappa_count: "40",
    kappa_scale: "log",
    gt_over_gn_min: "0.02",
    gt_over_gn_max: "1.99",
    gt_over_gn_count: "250",
    quantities: "switches,largest_switches",
  };
}

/**
 * Three results beyond the paper: their data, and what is asked for them.
 * @param {(call: string, query: Record<string, string>) => Promise<Record<string, any>>} columns of an answer of the server
 */
export function createLaws(columns) {
  return {
    load: {
      /** ε_t at the same ψ for several frictions. */
      collapse: () =>
        Promise.all(
          collapseQueries().map(async (query) => {
            const { values, epsilon_t: epsilonT } = await columns("cut", query);
            const muOverAlpha = Number(query.mu_over_alpha);
            const psi = values.map((/** @type {number} */ value) => value / muOverAlpha);
            return { muOverAlpha, gtOverGn: values, psi, epsilonT };
          }),
        ),

      /** ε_t of stiff springs along κ, with what bounds it. */
      stiffLaw: () =>
        Promise.all(
          stiffLawQueries().map(async (query) => {
            const answer = await columns("cut", query);
            return {
              psi: Number(query.gt_over_gn),
              kappa: answer.values,
              epsilonT: answer.epsilon_t,
              bound: answer.stiff_bound,
              asymptote: answer.stiff_asymptote,
            };
          }),
        ),

      /** Numbers of switches at stiff springs, and the law for the largest. */
      async switchLaw() {
        const { kappa, switches, largest_switches } = await columns("map", switchLawQuery());
        return { kappa, switches, largest_switches };
      },
    },
    queries: { collapse: collapseQueries, stiffLaw: stiffLawQueries, switchLaw: switchLawQuery },
  };
}
