// @ts-check

/** The symbols as markup. They are constants of ours, so they may be set as HTML. */
export const SYMBOLS = {
  kappa: "<var>κ</var>",
  mu_over_alpha: "<var>μ</var>\u2009/\u2009<var>α</var>",
  gt_over_gn: "<var>g</var><sub>t</sub>\u2009/\u2009<var>g</var><sub>n</sub>",
  damping: "<var>η</var>",
  normal_velocity_m_s: "<var>g</var><sub>n</sub>",
  tangential_velocity_m_s: "<var>g</var><sub>t</sub>",
  radius_m: "<var>R</var>",
  youngs_modulus_pa: "<var>Y</var>",
  friction_coefficient: "<var>μ</var>",
  tangential_stiffness_n_per_m: "<var>k</var><sub>t</sub>",
  dissipative_constant_s: "<var>A</var>",
  normal_restitution: "<var>ε</var><sub>n</sub>",
  density_kg_m3: "<var>ρ</var>",
  poisson_ratio: "<var>ν</var>",
  radius_2_m: "<var>R</var><sub>2</sub>",
  density_2_kg_m3: "<var>ρ</var><sub>2</sub>",
  youngs_modulus_2_pa: "<var>Y</var><sub>2</sub>",
  poisson_ratio_2: "<var>ν</var><sub>2</sub>",
  tangential_force_over_mu: "<var>F</var><sub>t</sub>\u2009/\u2009<var>μ</var>",
  normal_force: "<var>F</var><sub>n</sub>",
};

/** The same for Plotly, which knows a few tags only. */
export const PLOT_SYMBOLS = {
  kappa: "<i>κ</i>",
  alpha_kappa: "<i>ακ</i>",
  gt_over_gn: "<i>g</i><sub>t</sub> / <i>g</i><sub>n</sub>",
  psi: "<i>ψ</i>",
  epsilon_t: "<i>ε</i><sub>t</sub>",
  normal_velocity: "<i>g</i><sub>n</sub>, m/s",
  tangential_velocity: "<i>g</i><sub>t</sub>, m/s",
};

/**
 * What a symbol looks like in a text: an index of a letter or in braces, a power in braces, a letter
 * of the paper that stands alone.
 */
const SYMBOL =
  /((?:(?<![A-Za-ce-z])[A-Za-z]|[εψκηξζμγΩ])_(?:[a-z0](?![a-z])|\{[^{}]*\})|\^\{[^{}]*\}|[εψκμανηξζβτγ](?!_)|(?<![A-Za-z])t(?= = ))/;

/**
 * A text in pieces: plain ones, and symbols as a letter with its index, as in ε_t, m_{eff} or κ, or a
 * power, as in ^{−5/4}.
 * @param {string} text
 * @returns {{plain?: string, letter?: string, index?: string, power?: string}[]}
 */
export function splitSymbols(text) {
  return text
    .split(SYMBOL)
    .map((piece, i) => {
      if (i % 2 === 0) {
        return { plain: piece };
      }
      return piece[0] === "^"
        ? { power: piece.slice(2, -1) }
        : { letter: piece[0], index: piece.slice(2).replace(/[{}]/g, "") };
    })
    .filter(({ plain }) => plain !== "");
}

/** The same in letters alone, for a screen reader or a notice. */
export const PLAIN_SYMBOLS = {
  kappa: "κ",
  mu_over_alpha: "μ/α",
  gt_over_gn: "g_t/g_n",
  damping: "η",
  normal_velocity_m_s: "g_n",
  tangential_velocity_m_s: "g_t",
  radius_m: "R",
  youngs_modulus_pa: "Y",
  friction_coefficient: "μ",
  tangential_stiffness_n_per_m: "k_t",
  dissipative_constant_s: "A",
  normal_restitution: "ε_n",
  density_kg_m3: "ρ",
  poisson_ratio: "ν",
  radius_2_m: "R_2",
  density_2_kg_m3: "ρ_2",
  youngs_modulus_2_pa: "Y_2",
  poisson_ratio_2: "ν_2",
};

/** What texts in several languages name a symbol by, and the letters it stands for. */
export const TEXT_SYMBOLS = {
  epsilon_t: "ε_t",
  epsilon_n: "ε_n",
  kappa: PLAIN_SYMBOLS.kappa,
  mu_over_alpha: PLAIN_SYMBOLS.mu_over_alpha,
  gt_over_gn: PLAIN_SYMBOLS.gt_over_gn,
  damping: PLAIN_SYMBOLS.damping,
  psi: "ψ",
  mu: "μ",
  gt: "g_t",
};
