// @ts-check

import { logScale, powerScale, stepAbove } from "./scales.js";

/**
 * An impact of real spheres: the bodies of a material, and what is set of them by hand; null is what
 * the material says.
 * @typedef {{material: string, inertia: string | null} & Record<ImpactKey, number | null>} Impact
 * @typedef {"radius_m" | "youngs_modulus_pa" | "friction_coefficient" | "tangential_stiffness_n_per_m" | "dissipative_constant_s" | "normal_velocity_m_s" | "tangential_velocity_m_s"} ImpactKey
 */

/**
 * What can be set by hand, in SI units.
 * @typedef {Omit<import("./parameters.js").Parameter, "key" | "initial"> & {key: ImpactKey}} ImpactParameter
 */

/** How the mass of a sphere is spread. */
export const INERTIAS = ["solid", "hollow"];

const positive = (/** @type {number} */ value) => value > 0;
const notNegative = (/** @type {number} */ value) => value >= 0;

/** @type {ImpactParameter[]} */
export const IMPACT_PARAMETERS = [
  {
    key: "normal_velocity_m_s",
    name: "normal velocity, m/s",
    unit: "m/s",
    admits: positive,
    requirement: "a velocity greater than 0, in m/s",
    scale: logScale(0.01, 100),
    ticks: [0.01, 0.1, 1, 10, 100],
  },
  {
    key: "tangential_velocity_m_s",
    name: "tangential velocity, m/s",
    unit: "m/s",
    admits: notNegative,
    requirement: "a velocity, 0 or greater, in m/s",
    scale: logScale(0.01, 100),
    ticks: [0.01, 0.1, 1, 10, 100],
  },
  {
    key: "radius_m",
    name: "radius, m",
    unit: "m",
    admits: positive,
    requirement: "a length greater than 0, in m",
    scale: logScale(1e-5, 1),
    ticks: [1e-5, 1e-4, 1e-3, 0.01, 0.1, 1],
  },
  {
    key: "youngs_modulus_pa",
    name: "Young’s modulus, Pa",
    unit: "Pa",
    admits: positive,
    requirement: "a modulus greater than 0, in Pa",
    scale: logScale(1e5, 1e12),
    ticks: [1e6, 1e8, 1e10, 1e12],
  },
  {
    key: "friction_coefficient",
    name: "friction",
    admits: notNegative,
    requirement: "a number, 0 or greater",
    scale: powerScale(0, 1, 1),
    ticks: [0, 0.25, 0.5, 0.75, 1],
  },
  {
    key: "tangential_stiffness_n_per_m",
    name: "tangential stiffness, N/m",
    unit: "N/m",
    admits: positive,
    requirement: "a stiffness greater than 0, in N/m",
    scale: logScale(1e3, 1e13),
    ticks: [1e3, 1e5, 1e7, 1e9, 1e11, 1e13],
  },
  {
    key: "dissipative_constant_s",
    name: "dissipative constant, s",
    unit: "s",
    admits: notNegative,
    requirement: "a time, 0 or greater, in s",
    scale: powerScale(0, 1e-4, 0.25),
    ticks: [0, 1e-7, 1e-6, 1e-5, 1e-4],
  },
];

/**
 * A material as `/materials` has it: a body of `/scaling` with a name.
 * @typedef {{id: string, title: string, source: string, notes: string, body_1: Record<string, any>, body_2: Record<string, any>, friction_coefficient: number, tangential_stiffness_n_per_m: number | "mindlin", dissipative_constant_s: number, impact: {normal_velocity_m_s: number, tangential_velocity_m_s: number}, measured?: {convention: string, points: MeasuredPoint[]}}} Material
 * @typedef {{normal_velocity_m_s: number, tangential_velocity_m_s: number, epsilon_t: number}} MeasuredPoint
 */

/** Nothing set by hand. @param {string} material @returns {Impact} */
export function impactOf(material) {
  const nothing = IMPACT_PARAMETERS.map(({ key }) => [key, null]);
  return { ...Object.fromEntries(nothing), inertia: null, material };
}

/**
 * What holds of each parameter: what is set by hand, or else the material's; null for Mindlin's stiffness.
 * @param {Material} material
 * @param {Impact} impact
 * @returns {Record<ImpactKey, number | null>}
 */
export function valuesOf(material, impact) {
  const { body_1: body, tangential_stiffness_n_per_m: stiffness } = material;
  return {
    normal_velocity_m_s: impact.normal_velocity_m_s ?? material.impact.normal_velocity_m_s,
    tangential_velocity_m_s:
      impact.tangential_velocity_m_s ?? material.impact.tangential_velocity_m_s,
    radius_m: impact.radius_m ?? body.radius_m,
    youngs_modulus_pa: impact.youngs_modulus_pa ?? body.youngs_modulus_pa,
    friction_coefficient: impact.friction_coefficient ?? material.friction_coefficient,
    tangential_stiffness_n_per_m:
      impact.tangential_stiffness_n_per_m ?? (stiffness === "mindlin" ? null : stiffness),
    dissipative_constant_s: impact.dissipative_constant_s ?? material.dissipative_constant_s,
  };
}

/**
 * The body of `/scaling` without its impact. A sphere of the same kind shares what is set by hand; a wall
 * keeps its own.
 * @param {Material} material
 * @param {Impact} impact
 */
export function contactBody(material, impact) {
  const { radius_m, youngs_modulus_pa, inertia } = impact;
  const byHand = Object.fromEntries(
    Object.entries({ radius_m, youngs_modulus_pa, inertia }).filter(([, value]) => value !== null),
  );
  const values = valuesOf(material, impact);
  return {
    body_1: { ...material.body_1, ...byHand },
    body_2: material.body_2.wall ? material.body_2 : { ...material.body_2, ...byHand },
    friction_coefficient: values.friction_coefficient,
    tangential_stiffness_n_per_m: values.tangential_stiffness_n_per_m ?? "mindlin",
    dissipative_constant_s: values.dissipative_constant_s,
  };
}

/**
 * The axes of the map of velocities, from rest to the next of 1, 2, 5, 10 … above each.
 * @param {{normal_velocity_m_s: number | null, tangential_velocity_m_s: number | null}} values
 */
export function velocityView({ normal_velocity_m_s: normal, tangential_velocity_m_s: tangential }) {
  const most = stepAbove(1.1 * Math.max(normal ?? 1, tangential ?? 0, 1e-6));
  return { normal: powerScale(most / 200, most, 1), tangential: powerScale(0, most, 1), most };
}
