// @ts-check

/** The symbols as markup. They are constants of ours, so they may be set as HTML. */
export const SYMBOLS = {
  kappa: "<var>κ</var>",
  mu_over_alpha: "<var>μ</var>\u2009/\u2009<var>α</var>",
  gt_over_gn: "<var>g</var><sub>t</sub>\u2009/\u2009<var>g</var><sub>n</sub>",
  tangential_force_over_mu: "<var>F</var><sub>t</sub>\u2009/\u2009<var>μ</var>",
  normal_force: "<var>F</var><sub>n</sub>",
};

/** The same for Plotly, which knows a few tags only. */
export const PLOT_SYMBOLS = {
  kappa: "<i>κ</i>",
  gt_over_gn: "<i>g</i><sub>t</sub> / <i>g</i><sub>n</sub>",
};

/** The same in letters alone, for a screen reader or a notice. */
export const PLAIN_SYMBOLS = {
  kappa: "κ",
  mu_over_alpha: "μ/α",
  gt_over_gn: "g_t/g_n",
};
