// @ts-check

import { say } from "../format/words.js";
import { between, notNegative as notNegativeNumber, number } from "./requirements.js";
import { linearScale, logScale, powerScale, stepAbove } from "./scales.js";

/**
 * An impact of real spheres: the bodies of a material, and what is set of them by hand; null is what
 * the material says.
 * @typedef {{material: string, inertia: string | null, second: string | null} & Record<ImpactKey, number | null>} Impact
 * @typedef {"radius_m" | "youngs_modulus_pa" | "friction_coefficient" | "tangential_stiffness_n_per_m" | "dissipative_constant_s" | "normal_velocity_m_s" | "tangential_velocity_m_s" | "normal_restitution" | "density_kg_m3" | "poisson_ratio" | "radius_2_m" | "density_2_kg_m3" | "youngs_modulus_2_pa" | "poisson_ratio_2"} ImpactKey
 */

/**
 * What can be set by hand, in SI units.
 * @typedef {Omit<import("./parameters.js").Parameter, "key" | "initial"> & {key: ImpactKey, folded?: boolean}} ImpactParameter `folded` away until it is wanted
 */

/** How the mass of a sphere is spread. */
export const INERTIAS = ["solid", "hollow"];

/** What the second body is. */
export const SECONDS = ["sphere", "wall"];

/** What is set of the second body alone, and what it is of a body. */
const OF_SECOND = {
  radius_2_m: "radius_m",
  density_2_kg_m3: "density_kg_m3",
  youngs_modulus_2_pa: "youngs_modulus_pa",
  poisson_ratio_2: "poisson_ratio",
};

const positive = (/** @type {number} */ value) => value > 0;
const notNegative = (/** @type {number} */ value) => value >= 0;

/** @type {ImpactParameter[]} */
const FIRST = [
  {
    key: "normal_velocity_m_s",
    unit: "m/s",
    admits: positive,
    requirement: () => say("requirements.velocity", { unit: "m/s" }),
    scale: logScale(0.01, 100),
    ticks: [0.01, 0.1, 1, 10, 100],
  },
  {
    key: "tangential_velocity_m_s",
    unit: "m/s",
    admits: notNegative,
    requirement: () => say("requirements.velocityOrNone", { unit: "m/s" }),
    scale: logScale(0.01, 100),
    ticks: [0.01, 0.1, 1, 10, 100],
  },
  {
    key: "radius_m",
    unit: "m",
    admits: positive,
    requirement: () => say("requirements.length", { unit: "m" }),
    scale: logScale(1e-5, 1),
    ticks: [1e-5, 1e-4, 1e-3, 0.01, 0.1, 1],
  },
  {
    key: "youngs_modulus_pa",
    unit: "Pa",
    admits: positive,
    requirement: () => say("requirements.modulus", { unit: "Pa" }),
    scale: logScale(1e5, 1e12),
    ticks: [1e6, 1e8, 1e10, 1e12],
  },
  {
    key: "friction_coefficient",
    admits: notNegative,
    requirement: notNegativeNumber,
    scale: powerScale(0, 1, 1),
    ticks: [0, 0.25, 0.5, 0.75, 1],
  },
  {
    key: "tangential_stiffness_n_per_m",
    unit: "N/m",
    admits: positive,
    requirement: () => say("requirements.stiffness", { unit: "N/m" }),
    scale: logScale(1e3, 1e13),
    ticks: [1e3, 1e5, 1e7, 1e9, 1e11, 1e13],
  },
  {
    key: "dissipative_constant_s",
    unit: "s",
    admits: notNegative,
    requirement: () => say("requirements.timeOrNone", { unit: "s" }),
    scale: powerScale(0, 1e-4, 0.25),
    ticks: [0, 1e-7, 1e-6, 1e-5, 1e-4],
  },
];

/** @type {ImpactParameter[]} */
export const IMPACT_PARAMETERS = [
  ...FIRST,
  {
    key: "normal_restitution",
    // The service finds the damping down to there.
    admits: (value) => value >= 1.5e-50 && value <= 1,
    requirement: between(1.5e-50, 1),
    scale: powerScale(0.01, 1, 1),
    ticks: [0.01, 0.5, 1],
    folded: true,
  },
  density("density_kg_m3"),
  poissonRatio("poisson_ratio"),
  ofSecond("radius_m", "radius_2_m"),
  density("density_2_kg_m3"),
  ofSecond("youngs_modulus_pa", "youngs_modulus_2_pa"),
  poissonRatio("poisson_ratio_2"),
];

/** @param {ImpactKey} key @returns {ImpactParameter} */
function density(key) {
  return {
    key,
    unit: "kg/m³",
    admits: positive,
    requirement: () => say("requirements.density", { unit: "kg/m³" }),
    scale: logScale(10, 2e4),
    ticks: [10, 100, 1e3, 1e4],
    folded: true,
  };
}

/** @param {ImpactKey} key @returns {ImpactParameter} */
function poissonRatio(key) {
  return {
    key,
    admits: (value) => value > -1 && value <= 0.5,
    requirement: () => say("requirements.poissonRatio", { most: number(0.5) }),
    scale: powerScale(0, 0.5, 1),
    ticks: [0, 0.25, 0.5],
    folded: true,
  };
}

/** A parameter of the first body for the second. @param {ImpactKey} like @param {ImpactKey} key */
function ofSecond(like, key) {
  const found = /** @type {ImpactParameter} */ (FIRST.find((parameter) => parameter.key === like));
  return { ...found, key, folded: true };
}

/**
 * A material as `/materials` has it: a body of `/scaling` with a name.
 * @typedef {{id: string, title: string, source: string, notes: string, body_1: Record<string, any>, body_2: Record<string, any>, friction_coefficient: number, tangential_stiffness_n_per_m: number | "mindlin", dissipative_constant_s: number, impact: {normal_velocity_m_s: number, tangential_velocity_m_s: number}, measured?: {convention: string, points: MeasuredPoint[]}}} Material
 * @typedef {{normal_velocity_m_s: number, tangential_velocity_m_s: number, epsilon_t: number}} MeasuredPoint
 */

/** That of an impact, or the first where there is none of its name. @param {Material[]} materials @param {Impact} impact */
export function materialOf(materials, { material }) {
  return materials.find(({ id }) => id === material) ?? materials[0];
}

/** Nothing set by hand. @param {string} material @returns {Impact} */
export function impactOf(material) {
  const nothing = IMPACT_PARAMETERS.map(({ key }) => [key, null]);
  return { ...Object.fromEntries(nothing), inertia: null, second: null, material };
}

/**
 * What holds of each parameter: what is set by hand, or else the material's; null for what the service works
 * out of the others, and for what a wall does not have.
 * @param {Material} material
 * @param {Impact} impact
 * @returns {Record<ImpactKey, number | null>}
 */
export function valuesOf(material, impact) {
  const { tangential_stiffness_n_per_m: stiffness } = material;
  const [first, second] = bodiesOf(material, impact);
  return {
    normal_velocity_m_s: impact.normal_velocity_m_s ?? material.impact.normal_velocity_m_s,
    tangential_velocity_m_s:
      impact.tangential_velocity_m_s ?? material.impact.tangential_velocity_m_s,
    radius_m: first.radius_m,
    youngs_modulus_pa: first.youngs_modulus_pa,
    friction_coefficient: impact.friction_coefficient ?? material.friction_coefficient,
    tangential_stiffness_n_per_m:
      impact.tangential_stiffness_n_per_m ?? (stiffness === "mindlin" ? null : stiffness),
    dissipative_constant_s:
      impact.normal_restitution === null
        ? (impact.dissipative_constant_s ?? material.dissipative_constant_s)
        : null,
    normal_restitution: impact.normal_restitution,
    density_kg_m3: first.density_kg_m3,
    poisson_ratio: first.poisson_ratio,
    radius_2_m: second.radius_m ?? null,
    density_2_kg_m3: second.density_kg_m3 ?? null,
    youngs_modulus_2_pa: second.youngs_modulus_pa,
    poisson_ratio_2: second.poisson_ratio,
  };
}

/**
 * What each parameter is when it is set back: the material's, and of the second body what the first one is.
 * @param {Material} material
 * @param {Impact} impact
 */
export function usualOf(material, impact) {
  const nothing = { ...impactOf(material.id), second: impact.second };
  const unset = Object.keys(OF_SECOND).map((key) => [key, null]);
  const beside = valuesOf(material, { ...impact, ...Object.fromEntries(unset) });
  const { radius_2_m, density_2_kg_m3, youngs_modulus_2_pa, poisson_ratio_2 } = beside;
  const alike = { radius_2_m, density_2_kg_m3, youngs_modulus_2_pa, poisson_ratio_2 };
  // One of the two is set back by the other.
  const told = impact.normal_restitution === null ? {} : { dissipative_constant_s: null };
  return { ...valuesOf(material, nothing), ...alike, ...told };
}

/**
 * What of the parameters the service has worked out of the others.
 * @param {import("../api/answers.js").Scaling | null} scaling
 * @returns {Partial<Record<ImpactKey, number>>}
 */
export function workedOut(scaling) {
  return scaling
    ? {
        tangential_stiffness_n_per_m: scaling.tangential_stiffness_n_per_m,
        dissipative_constant_s: scaling.dissipative_constant_s,
        normal_restitution: scaling.epsilon_n,
      }
    : {};
}

/** What the second body is: as set by hand, or else the material's. @param {Material} material @param {Impact} impact */
export function secondOf(material, impact) {
  return impact.second ?? (material.body_2.wall ? "wall" : "sphere");
}

/** What of an object is there. @param {Record<string, any>} members */
function there(members) {
  return Object.fromEntries(
    Object.entries(members).filter(([, value]) => value !== null && value !== undefined),
  );
}

/**
 * Both bodies. A sphere of the same kind shares what is set by hand, and so does a wall that the material does
 * not have; its own wall keeps its own.
 * @param {Material} material
 * @param {Impact} impact
 * @returns {[Record<string, any>, Record<string, any>]}
 */
function bodiesOf(material, impact) {
  const { radius_m, youngs_modulus_pa, density_kg_m3, poisson_ratio, inertia } = impact;
  const byHand = there({ radius_m, youngs_modulus_pa, density_kg_m3, poisson_ratio, inertia });
  const first = { ...material.body_1, ...byHand };
  const isWall = secondOf(material, impact) === "wall";
  const hasWall = Boolean(material.body_2.wall);
  const like = { ...material.body_2, ...(hasWall ? {} : byHand) };
  const own = Object.entries(OF_SECOND).map(([key, member]) => [
    member,
    impact[/** @type {ImpactKey} */ (key)],
  ]);
  const second = { ...(isWall === hasWall ? like : first), ...there(Object.fromEntries(own)) };
  if (!isWall) {
    return [first, second];
  }
  const { youngs_modulus_pa: modulus, poisson_ratio: ratio } = second;
  const base = hasWall ? like : { wall: true };
  return [first, { ...base, youngs_modulus_pa: modulus, poisson_ratio: ratio }];
}

/**
 * The body of `/scaling` without its impact.
 * @param {Material} material
 * @param {Impact} impact
 */
export function contactBody(material, impact) {
  const [body_1, body_2] = bodiesOf(material, impact);
  const values = valuesOf(material, impact);
  return {
    body_1,
    body_2,
    friction_coefficient: values.friction_coefficient,
    tangential_stiffness_n_per_m: values.tangential_stiffness_n_per_m ?? "mindlin",
    ...(values.normal_restitution === null
      ? { dissipative_constant_s: values.dissipative_constant_s }
      : {
          normal_restitution: values.normal_restitution,
          at_normal_velocity_m_s: values.normal_velocity_m_s,
        }),
  };
}

/** So many times less than the largest is the smallest normal and tangential velocity of a map. */
const DOWN_TO = { normal: 200, tangential: 1e5 };

/**
 * The axes of the map of velocities, to the next of 1, 2, 5, 10 … above both: from rest on, or
 * logarithmic, which shows the small tangential velocities where ε_t swings.
 * @param {{normal_velocity_m_s: number | null, tangential_velocity_m_s: number | null}} values
 * @param {"linear" | "log"} scale
 */
export function velocityView(
  { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential },
  scale,
) {
  const most = stepAbove(1.1 * Math.max(normal ?? 1, tangential ?? 0, 1e-6));
  const make = scale === "log" ? logScale : linearScale;
  return {
    normal: make(most / DOWN_TO.normal, most),
    tangential: make(scale === "log" ? most / DOWN_TO.tangential : 0, most),
    most,
    scale,
  };
}
