// @ts-check

/** What this page reads of the server's answers: types only. */

/**
 * What this page reads of an answer of `/collision`.
 * @typedef {object} CollisionAnswer
 * @property {Episode[]} episodes
 * @property {import("../state/parameters.js").Collision & {psi: number | null}} parameters
 * @property {number} epsilon_t
 * @property {number} epsilon_n
 * @property {number | null} switches
 * @property {number | null} reversals
 * @property {number} contact_duration
 * @property {{initial: number, final: number, dissipated: number}} energy
 * @property {{coulomb: number}} estimates
 * @property {string} summary
 * @property {string} convention
 * @property {boolean} limit
 * @property {string} method
 * @property {number} error_bound
 * @property {number | null} milliseconds the server's own computing time
 */

/** @typedef {Pick<CollisionAnswer, "epsilon_t" | "method" | "error_bound" | "milliseconds">} Answer */

/**
 * What this page reads of an answer of `/trace`, its columns among it.
 * @typedef {CollisionAnswer & Columns & {switch_times: Float64Array}} Trace
 * @typedef {Record<"time" | "compression" | "normal_force" | "tangential_force_over_mu" | "tangential_velocity" | "spring_elongation" | "tangential_energy", Float64Array>} Columns
 */

/** @typedef {{regime: "sliding" | "sticking", start: number, end: number, direction: number}} Episode */

/**
 * @typedef {object} MapGrid
 * @property {Float64Array} kappa
 * @property {Float64Array} gt_over_gn
 * @property {Float64Array[]} epsilon_t rows of constant g_t/g_n
 * @property {Int32Array[]} switches
 */

/**
 * What is asked of `/cut`, and its columns; a number that does not exist is NaN.
 * @typedef {{kappa: number, muOverAlpha: number, view: import("../state/map-view.js").MapView, count: number}} CutWish
 * @typedef {{switches: Int32Array | Float64Array} & Record<"values" | "epsilon_t" | "coulomb" | "stiff_bound" | "stiff_asymptote", Float64Array>} Cut
 */

/**
 * What this page reads of `/scaling`.
 * @typedef {object} Scaling
 * @property {number} kappa
 * @property {number} mu_over_alpha
 * @property {number} gt_over_gn
 * @property {number} damping
 * @property {number | null} psi
 * @property {number} alpha
 * @property {number} effective_mass_kg
 * @property {number} tangential_stiffness_n_per_m
 * @property {number} normal_velocity_m_s
 * @property {number} tangential_velocity_m_s
 * @property {number} contact_duration_s
 * @property {number} maximum_compression_m
 * @property {number} maximum_normal_force_n
 * @property {number} epsilon_n
 * @property {number | null} epsilon_t
 * @property {number | null} switches
 * @property {{code: string, text: string}[]} warnings
 */

/** @typedef {{normal_velocity_m_s: Float64Array, tangential_velocity_m_s: Float64Array} & Record<"epsilon_t" | "coulomb", Float64Array[]>} VelocityMap */

/**
 * A collision in time steps.
 * @typedef {object} Stepped
 * @property {number} epsilon_t
 * @property {number} error_bound
 * @property {Float64Array} method_time
 * @property {Float64Array} method_tangential_force_over_mu
 */

/**
 * What this page reads of `/tradeoff` and of `/steps`.
 * @typedef {{scene: string, measured_at: string, machine: string, rows: import("../figures/tradeoff-figure.js").Row[], can_be_measured_anew: boolean}} Tradeoff
 * @typedef {{id: string, scene: string, state: "running" | "done" | "cancelled" | "failed", progress: number, result: Omit<Tradeoff, "can_be_measured_anew"> | null}} Run
 * @typedef {object} StepsAnswer
 * @property {number} stability_limit
 * @property {Record<string, {p95: number | null, worst: number | null}>} needed
 * @property {{steps_max: number, velocity_verlet: {error_p95: number | null, error_max: number | null}}} rule
 */

/** @typedef {import("../state/parameters.js").Collision & {id: string, title: string, alpha: number, source: string, link: string, caption: string}} Preset */

export {};
