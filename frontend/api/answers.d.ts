/** What this page reads of the server's answers, and what it asks that has a form of its own. */

import type { MapView } from "../state/map-view.js";
import type { Collision } from "../state/parameters.js";
import type { Row } from "../figures/tradeoff-figure.js";

/** Of `/collision`. */
export type CollisionAnswer = {
  episodes: Episode[];
  parameters: Collision & { psi: number | null };
  epsilon_t: number;
  epsilon_n: number;
  switches: number | null;
  reversals: number | null;
  contact_duration: number;
  energy: { initial: number; final: number; dissipated: number };
  estimates: { coulomb: number };
  summary: string;
  convention: string;
  limit: boolean;
  method: string;
  error_bound: number;
  /** The server's own computing time. */
  milliseconds: number | null;
};

export type Answer = Pick<CollisionAnswer, "epsilon_t" | "method" | "error_bound" | "milliseconds">;

/** Of `/trace`, its columns among it. */
export type Trace = CollisionAnswer & Columns & { switch_times: Float64Array };

export type Columns = Record<
  | "time"
  | "compression"
  | "normal_force"
  | "tangential_force_over_mu"
  | "tangential_velocity"
  | "spring_elongation"
  | "tangential_energy",
  Float64Array
>;

export type Episode = {
  regime: "sliding" | "sticking";
  start: number;
  end: number;
  direction: number;
};

export type MapGrid = {
  kappa: Float64Array;
  gt_over_gn: Float64Array;
  /** Rows of constant g_t/g_n. */
  epsilon_t: Float64Array[];
  switches: Int32Array[];
};

/** What is asked of `/cut`. */
export type CutWish = { kappa: number; muOverAlpha: number; view: MapView; count: number };

/** Columns of `/cut`; a number that does not exist is NaN. */
export type Cut = { switches: Int32Array | Float64Array } & Record<
  "values" | "epsilon_t" | "coulomb" | "stiff_bound" | "stiff_asymptote",
  Float64Array
>;

/** Of `/scaling`. */
export type Scaling = {
  kappa: number;
  mu_over_alpha: number;
  gt_over_gn: number;
  damping: number;
  psi: number | null;
  alpha: number;
  effective_mass_kg: number;
  tangential_stiffness_n_per_m: number;
  normal_velocity_m_s: number;
  tangential_velocity_m_s: number;
  contact_duration_s: number;
  maximum_compression_m: number;
  maximum_normal_force_n: number;
  epsilon_n: number;
  epsilon_t: number | null;
  switches: number | null;
  warnings: { code: string; text: string }[];
};

/** Of `/scaling/map`. */
export type VelocityMap = {
  normal_velocity_m_s: Float64Array;
  tangential_velocity_m_s: Float64Array;
} & Record<"epsilon_t" | "coulomb", Float64Array[]>;

/** A collision in time steps. */
export type Stepped = {
  epsilon_t: number;
  error_bound: number;
  method_time: Float64Array;
  method_tangential_force_over_mu: Float64Array;
};

/** Of `/tradeoff`. */
export type Tradeoff = {
  scene: string;
  measured_at: string;
  machine: string;
  rows: Row[];
  can_be_measured_anew: boolean;
};

/** Of `/tradeoff/runs`. */
export type Run = {
  id: string;
  scene: string;
  state: "running" | "done" | "cancelled" | "failed";
  progress: number;
  result: Omit<Tradeoff, "can_be_measured_anew"> | null;
};

/** Of `/steps`. */
export type StepsAnswer = {
  stability_limit: number;
  needed: Record<string, { p95: number | null; worst: number | null }>;
  rule: {
    steps_max: number;
    velocity_verlet: { error_p95: number | null; error_max: number | null };
  };
};

/** Of `/presets`. */
export type Preset = Collision & {
  id: string;
  title: string;
  alpha: number;
  source: string;
  link: string;
  caption: string;
};
