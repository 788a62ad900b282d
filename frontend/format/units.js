// @ts-check

import { say } from "./words.js";

/**
 * A unit as a multiple of SI: 10^power × times / per; powers of ten are kept apart, so that 20 mm are
 * 0.02 m and not nearly.
 * @typedef {{dimension: string, power: number, times: number, per: number}} Unit
 */

/** Powers of ten. */
const PREFIXES = new Map(
  Object.entries({
    T: 12,
    G: 9,
    M: 6,
    k: 3,
    h: 2,
    d: -1,
    c: -2,
    m: -3,
    μ: -6,
    u: -6,
    n: -9,
    p: -12,
  }),
);

/**
 * Units by their exponents of metre, kilogram, second and radian, then power of ten, factor and divisor.
 * @type {Map<string, [number[], number?, number?, number?]>}
 */
const PREFIXED = new Map(
  Object.entries({
    m: [[1, 0, 0, 0]],
    g: [[0, 1, 0, 0], -3],
    s: [[0, 0, 1, 0]],
    N: [[1, 1, -2, 0]],
    Pa: [[-1, 1, -2, 0]],
    bar: [[-1, 1, -2, 0], 5],
    J: [[2, 1, -2, 0]],
    W: [[2, 1, -3, 0]],
    Hz: [[0, 0, -1, 0]],
  }),
);

/** The same of those that take no prefix. @type {typeof PREFIXED} */
const UNPREFIXED = new Map(
  Object.entries({
    t: [[0, 1, 0, 0], 3],
    min: [[0, 0, 1, 0], 0, 60],
    h: [[0, 0, 1, 0], 0, 3600],
    in: [[1, 0, 0, 0], -4, 254],
    ft: [[1, 0, 0, 0], -4, 3048],
    mph: [[1, 0, -1, 0], -3, 1609344, 3600],
    kph: [[1, 0, -1, 0], 3, 1, 3600],
    dyn: [[1, 1, -2, 0], -5],
    psi: [[-1, 1, -2, 0], -12, 6894757293168361],
    ksi: [[-1, 1, -2, 0], -9, 6894757293168361],
    rad: [[0, 0, 0, 1]],
    "°": [[0, 0, 0, 1], 0, Math.PI, 180],
    deg: [[0, 0, 0, 1], 0, Math.PI, 180],
    "%": [[0, 0, 0, 0], -2],
    "‰": [[0, 0, 0, 0], -3],
  }),
);

/** What has these exponents, and the units that a field of it names, if any. @type {Record<string, [string, string]>} */
const DIMENSIONS = {
  "0,0,0,0": ["share", ""],
  "1,0,0,0": ["length", "m, mm, cm, µm"],
  "0,1,0,0": ["mass", "kg, g, mg"],
  "0,0,1,0": ["time", "s, ms, µs, ns"],
  "0,0,0,1": ["angle", "°, rad"],
  "1,0,-1,0": ["velocity", "m/s, cm/s, mm/s, km/h"],
  "1,0,-2,0": ["acceleration", "m/s²"],
  "1,1,-2,0": ["force", "N, mN, kN"],
  "-1,1,-2,0": ["pressure", "Pa, kPa, MPa, GPa"],
  "0,1,-2,0": ["stiffness", "N/m, N/mm, kN/m"],
  "-3,1,0,0": ["density", "kg/m³, g/cm³"],
  "2,1,-2,0": ["energy", "J, mJ"],
  "2,1,-3,0": ["power", "W, mW"],
  "0,0,-1,0": ["frequency", "Hz, 1/s"],
  "2,0,0,0": ["area", "m², mm²"],
  "3,0,0,0": ["volume", "m³, mm³"],
  "0,0,-1,1": ["angularVelocity", "rad/s"],
};

/**
 * The unit a text is, in plain signs (N/m, N m^-1, kg*m^-3), or null.
 * @param {string} text
 * @returns {Unit | null}
 */
export function unitOf(text) {
  const exponents = [0, 0, 0, 0];
  const unit = { power: 0, times: 1, per: 1 };
  for (const [i, part] of text.split("/").entries()) {
    const factors = part.trim().split(/ ?\* ?| /);
    for (const [j, factor] of factors.entries()) {
      const [, name, raised] = /^([a-zμ°%‰]+)\^?(-?[1-4])?$/i.exec(factor) ?? [];
      const known = name && simpleUnit(name);
      if (!known) {
        // 1/s, and no unit at all
        if ((factor === "1" && text.includes("/") && i === 0) || text === "") {
          continue;
        }
        return null;
      }
      // Of several after a stroke, as in N/m s, nobody can say which are divided by.
      if (i > 0 && j > 0) {
        return null;
      }
      const times = Number(raised ?? 1) * (i > 0 ? -1 : 1);
      const [own, power, factorOf, per] = known;
      own.forEach((exponent, k) => (exponents[k] += times * exponent));
      unit.power += times * power;
      const [up, down] = times > 0 ? [factorOf, per] : [per, factorOf];
      unit.times *= up ** Math.abs(times);
      unit.per *= down ** Math.abs(times);
    }
  }
  return { dimension: String(exponents), ...unit };
}

/**
 * @param {string} name
 * @returns {[number[], number, number, number] | null}
 */
function simpleUnit(name) {
  const [own, power = 0, times = 1, per = 1] = UNPREFIXED.get(name) ?? PREFIXED.get(name) ?? [];
  if (own) {
    return [own, power, times, per];
  }
  const base = PREFIXED.get(name.slice(1));
  const prefix = PREFIXES.get(name[0]);
  return base && prefix ? [base[0], (base[1] ?? 0) + prefix, 1, 1] : null;
}

/** What a quantity in a unit is: "a pressure". @param {Unit} unit */
export function kindOf({ dimension }) {
  return say(`quantities.${DIMENSIONS[dimension]?.[0] ?? "other"}`);
}

/** Units that a field of such a quantity takes, in words. @param {Unit} unit */
export function takenBy({ dimension }) {
  return DIMENSIONS[dimension][1] || say("quantities.pure");
}
