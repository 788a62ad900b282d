/**
 * What this page reads of the server's answers. Their shapes are the server's, as its document says
 * (`openapi.d.ts`); what is said here is what the page has made of them: arrays decoded, times added.
 */

import type { components } from "./openapi.js";

type Schemas = components["schemas"];

/** Of `/collision`, what the page reads of it. */
export type CollisionAnswer = Pick<
  Schemas["Collision"],
  | "epsilon_t"
  | "epsilon_n"
  | "switches"
  | "switches_certain"
  | "reversals"
  | "contact_duration"
  | "first_episode_share"
  | "limit"
  | "method"
  | "error_bound"
> & {
  parameters: import("../state/parameters.js").Collision & { psi: number | null };
  episodes: Episode[];
  energy: Pick<Schemas["Energy"], "dissipated_share">;
  estimates: Pick<Schemas["Estimates"], "coulomb">;
  /** The server's own computing time, NaN if it does not tell; null of what the page has computed itself. */
  milliseconds: number | null;
};

export type Answer = Pick<CollisionAnswer, "epsilon_t" | "method" | "error_bound" | "milliseconds">;

/** Of `/trace`, its columns among it; what is followed from switch to switch has been counted. */
export type Trace = CollisionAnswer &
  Columns & { switch_times: Float64Array; switches: number; reversals: number };

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

export type Episode = Schemas["Episode"];

export type MapGrid = {
  kappa: Float64Array;
  gt_over_gn: Float64Array;
  /** Rows of constant g_t/g_n. */
  epsilon_t: Float64Array[];
  /** NaN, and so no integers, where they were not counted. */
  switches: (Int32Array | Float64Array)[];
};

/** Columns of `/cut`; a number that does not exist is NaN. */
export type Cut = { switches: Int32Array | Float64Array } & Record<
  "values" | "epsilon_t" | "coulomb" | "stiff_bound" | "stiff_asymptote",
  Float64Array
>;

/** Of `/bounce`, what the page reads of it. */
export type Bounces = Pick<
  Schemas["BounceStudy"],
  "mass_share" | "centre_change" | "spin_change"
> & { second: Omit<Schemas["Bounce"], "error_bound"> | null };

export type Scaling = Schemas["Scaling"];
export type CodesAnswer = Schemas["CodesStudy"];

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

export type Row = Schemas["Row"];
export type Tradeoff = Schemas["Tradeoff"];
export type Run = Schemas["Run"];
export type StepsAnswer = Schemas["Steps"];
export type Preset = Schemas["Preset"];
