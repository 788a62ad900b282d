// @ts-check

/**
 * The kernels of the backend's `mechanics` where the hand is: kernel.wasm, made by `make kernel`.
 *
 * What a call returns is the server's answer but for the last digits of the browser's own sine and
 * power. It is null where the server is to be asked: beyond what is followed, and beyond what there
 * is room for here. Nothing of physics is written here.
 */

/**
 * What the module says of itself: sizes in bytes, memory in pages of 64 KiB.
 * @typedef {{
 *   contact: number, free: number, labels: number, lanes: number, most_switches: number,
 *   pages: number, stack: number,
 * }} About
 */

/**
 * The functions of the module by their names; each returns its status, 0 for success.
 * @typedef {Record<string, (...given: number[]) => number>} Entries
 */

/**
 * @typedef {object} Contact
 * @property {number} duration t_c
 * @property {number} normalRestitution ε_n
 * @property {number} largestForce
 */

/**
 * @typedef {object} Outcome
 * @property {number} epsilonT
 * @property {number} switches
 * @property {boolean} isCertain false where rounding decides about a switch
 * @property {number} errorBound
 * @property {number} expectedSwitches
 */

/**
 * @typedef {object} Outcomes
 * @property {Float64Array} epsilonT
 * @property {Int32Array} switches -1 where a collision is too stiff to be followed
 * @property {Uint8Array} isCertain
 * @property {Float64Array} errorBound
 */

/**
 * A collision over time, scaled as `studies.collision.trace`; velocity, elongation and energy over
 * u(0), u(0) and u(0)².
 * @typedef {object} Trace
 * @property {number} epsilonT
 * @property {number} switches
 * @property {boolean} isCertain
 * @property {number} errorBound
 * @property {number} reversals
 * @property {{kappa: number, psi: number}} sensitivity
 * @property {number} contactDuration
 * @property {Float64Array} starts of the episodes
 * @property {Int8Array} directions of their sliding, 0 where they stick
 * @property {Float64Array} time
 * @property {Float64Array} compression
 * @property {Float64Array} compressionRate
 * @property {Float64Array} normalForce
 * @property {Float64Array} tangentialVelocity
 * @property {Float64Array} springElongation
 * @property {Float64Array} tangentialForce with the sign of the elongation, over μ
 * @property {Float64Array} tangentialEnergy
 * @property {Int8Array} regime
 */

/** Collisions of a list that are computed at a time; they don't depend on each other. */
const PART = 8192;

export const MOST_SAMPLES = 2048;

/** More episodes than these have no trace here. */
const ROOM = 2048;

const CURVES = 7;

/** Numbers that a call leaves beside its arrays. */
const SUMMARY = 8;

/**
 * What a module says of itself.
 * @param {WebAssembly.Module} module
 * @returns {About}
 */
export function aboutModule(module) {
  const [section] = WebAssembly.Module.customSections(module, "restitution");
  return JSON.parse(new TextDecoder().decode(section));
}

/**
 * The memory that a module works in and what else it takes, for `WebAssembly.instantiate`.
 * @param {About} about
 */
export function importsOf({ pages, stack }) {
  const memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
  const stackPointer = new WebAssembly.Global({ value: "i32", mutable: true }, stack);
  const { sin, cos, pow, atan2, hypot, exp, log, cbrt } = Math;
  return {
    env: {
      ...{ __linear_memory: memory, __stack_pointer: stackPointer },
      ...{ sin, cos, pow, atan2, hypot, exp, log, cbrt },
    },
  };
}

/**
 * The calls of a compiled kernel.wasm.
 * @param {WebAssembly.Module} module
 */
export async function createKernel(module) {
  const about = aboutModule(module);
  const { env } = importsOf(about);
  const { exports } = await WebAssembly.instantiate(module, { env });
  const entries = /** @type {Entries} */ (/** @type {unknown} */ (exports));
  const { __linear_memory: memory, __stack_pointer: stackPointer } = env;

  const mostSwitches = about.most_switches;
  let top = about.free;
  /** @param {number} bytes */
  const reserve = (bytes) => {
    const address = top;
    top = Math.ceil((top + bytes) / 16) * 16;
    if (top > memory.buffer.byteLength) {
      throw new RangeError(`the kernel has no memory at ${top}`);
    }
    return address;
  };
  const contact = reserve(about.contact);
  const lanes = reserve(about.lanes);
  const labels = reserve(about.labels);
  const summary = new Float64Array(memory.buffer, reserve(8 * SUMMARY), SUMMARY);
  const columns = MOST_SAMPLES + ROOM;
  /** Where the arrays of a call begin. */
  const rest = top;

  /** η of the contact in memory. */
  let prepared = 0;

  /**
   * Whether an entry did what it was asked.
   * @param {string} name
   * @param {number[]} given
   */
  function call(name, ...given) {
    try {
      return entries[name](...given) === 0;
    } catch (error) {
      // a trap leaves the stack where it was, and perhaps half a contact
      stackPointer.value = about.stack;
      prepared = 0;
      throw error;
    }
  }

  /**
   * Whether an entry over the contact of η did what it was asked.
   * @param {number} damping
   * @param {string} name
   * @param {number[]} given
   */
  function callOver(damping, name, ...given) {
    if (damping === 0) {
      return call(name, contact, ...given);
    }
    if (damping !== prepared) {
      prepared = call("prepare_contact", damping, contact) ? damping : 0;
    }
    return prepared === damping && call(`damped_${name}`, contact, ...given);
  }

  /**
   * The contact of η.
   * @param {number} damping
   * @returns {Contact | null}
   */
  function contactOf(damping) {
    if (!callOver(damping, "describe", summary.byteOffset)) {
      return null;
    }
    const [duration, normalRestitution, largestForce] = summary;
    return { duration, normalRestitution, largestForce };
  }

  /**
   * One collision.
   * @param {number} kappa
   * @param {number} psi 0 stands for the limit ψ → 0; infinity gives ε_t = 1
   * @param {number} damping η
   * @returns {Outcome | null}
   */
  function collision(kappa, psi, damping = 0) {
    if (!callOver(damping, "collide", mostSwitches, kappa, psi, summary.byteOffset)) {
      return null;
    }
    const [epsilonT, switches, certain, errorBound, expectedSwitches] = summary;
    return { epsilonT, switches, isCertain: certain === 1, errorBound, expectedSwitches };
  }

  /**
   * The collisions of a list, a cut or a map.
   * @param {ArrayLike<number>} kappa
   * @param {ArrayLike<number>} psi as many
   * @param {number} damping η of all of them
   * @returns {Outcomes | null}
   */
  function collisions(kappa, psi, damping = 0) {
    const [kappas, psis] = [new Float64Array(kappa), new Float64Array(psi)];
    const size = kappas.length;
    const found = {
      epsilonT: new Float64Array(size),
      switches: new Int32Array(size),
      isCertain: new Uint8Array(size),
      errorBound: new Float64Array(size),
    };
    for (let begin = 0; begin < size; begin += PART) {
      const count = Math.min(PART, size - begin);
      top = rest;
      const given = [kappas, psis].map((all) => {
        const part = new Float64Array(memory.buffer, reserve(8 * count), count);
        part.set(all.subarray(begin, begin + count));
        return part;
      });
      const made = [
        new Float64Array(memory.buffer, reserve(8 * count), count),
        new Int32Array(memory.buffer, reserve(4 * count), count),
        new Uint8Array(memory.buffer, reserve(count), count),
        new Float64Array(memory.buffer, reserve(8 * count), count),
      ];
      const addresses = [...given, ...made].map((array) => array.byteOffset);
      if (
        !callOver(damping, "collide_in_lanes", mostSwitches, count, ...addresses, lanes, labels)
      ) {
        return null;
      }
      Object.values(found).forEach((all, i) => all.set(made[i], begin));
    }
    return found;
  }

  /**
   * One collision at uniform instants, merged with those of its switches.
   * @param {number} kappa
   * @param {number} psi
   * @param {number} damping η
   * @param {number} samples 2 to `MOST_SAMPLES`
   * @returns {Trace | null}
   */
  function trace(kappa, psi, damping = 0, samples = 400) {
    if (samples < 2 || samples > MOST_SAMPLES) {
      return null;
    }
    top = rest;
    const starts = reserve(8 * ROOM);
    const directions = reserve(ROOM);
    const time = reserve(8 * columns);
    const curves = reserve(8 * CURVES * columns);
    const regime = reserve(columns);
    const episodes = [starts, directions];
    const arrays = [...episodes, time, curves, regime, lanes, labels, summary.byteOffset];
    if (!callOver(damping, "trace", mostSwitches, kappa, psi, samples, ROOM, ...arrays)) {
      return null;
    }
    const [epsilonT, switches, certain, errorBound, reversals, byKappa, byPsi, contactDuration] =
      summary;
    const size = samples + switches;
    /** @param {number} address @param {number} count */
    const numbers = (address, count) => new Float64Array(memory.buffer, address, count).slice();
    /** @param {number} address @param {number} count */
    const signs = (address, count) => new Int8Array(memory.buffer, address, count).slice();
    const rows = Array.from({ length: CURVES }, (_, row) => numbers(curves + 8 * row * size, size));
    return {
      ...{ epsilonT, switches, isCertain: certain === 1, errorBound, reversals, contactDuration },
      sensitivity: { kappa: byKappa, psi: byPsi },
      starts: numbers(starts, switches + 1),
      directions: signs(directions, switches + 1),
      time: numbers(time, size),
      compression: rows[0],
      compressionRate: rows[1],
      normalForce: rows[2],
      tangentialVelocity: rows[3],
      springElongation: rows[4],
      tangentialForce: rows[5],
      tangentialEnergy: rows[6],
      regime: signs(regime, size),
    };
  }

  return { contactOf, collision, collisions, trace };
}
