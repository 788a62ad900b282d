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
 *   contact: number, free: number, labels: number, lanes: number, pages: number, stack: number,
 *   mass_shares: Record<"wall" | "sphere", number>, most_switches: number,
 * }} About
 */

/**
 * The functions of the module by their names; each returns its status, 0 for success.
 * @typedef {Record<string, (...given: number[]) => number>} Entries
 */

/**
 * @typedef {object} Outcome
 * @property {number} epsilonT
 * @property {number} switches -1 where it is too stiff to be followed
 * @property {boolean} isCertain false where rounding decides about a switch
 * @property {number} errorBound
 * @property {number} psi
 * @property {number} contactDuration
 * @property {number} epsilonN
 * @property {number} dissipatedShare of the tangential energy
 * @property {number} coulomb ε_t of Coulomb's law
 */

/**
 * @typedef {object} Outcomes
 * @property {Float64Array} epsilonT
 * @property {Int32Array} switches -1 where a collision is too stiff to be followed
 * @property {Uint8Array} isCertain
 * @property {Float64Array} errorBound
 */

/**
 * @typedef {Record<"coulomb" | "stiffBound" | "stiffAsymptote", Float64Array>} SimpleLaws NaN where they say nothing
 */

/**
 * @typedef {object} Course what only a collision that was followed has
 * @property {number} reversals
 * @property {number} firstEpisodeShare
 * @property {Float64Array} starts of the episodes
 * @property {Int8Array} directions of their sliding, 0 where they stick
 */

/**
 * A collision over time, scaled as the service's.
 * @typedef {Outcome & Course & {
 *   time: Float64Array, compression: Float64Array, compressionRate: Float64Array,
 *   normalForce: Float64Array, tangentialVelocity: Float64Array, springElongation: Float64Array,
 *   tangentialForceOverMu: Float64Array, tangentialEnergy: Float64Array, regime: Int8Array,
 * }} Trace
 */

/**
 * What a ball's motion takes from its collision, and the one after its flight.
 * @typedef {object} Bounce
 * @property {number} massShare
 * @property {number} centreChange
 * @property {number} spinChange
 * @property {number} kappa
 * @property {number} gtOverGn
 * @property {number} damping
 */

/** @typedef {Awaited<ReturnType<typeof createKernel>>} Kernel */

/** Collisions of a list that are computed at a time; they don't depend on each other. */
const PART = 8192;

export const MOST_SAMPLES = 2048;

/** More episodes than these have no trace here, nor from the server. */
const ROOM = 20_001;

const COLUMNS = 7;

/** Numbers that a call leaves of a collision's outcome; a trace has two besides. */
const OUTCOME = 9;

/**
 * A collision as the service has it, and many of one μ/α and η.
 * @typedef {{kappa: number, mu_over_alpha: number, gt_over_gn: number, damping: number}} Collision
 * @typedef {{kappa: Float64Array, muOverAlpha: number, gtOverGn: Float64Array, damping: number}} List
 */

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
  const summary = new Float64Array(memory.buffer, reserve(8 * (OUTCOME + 2)), OUTCOME + 2);
  const mostColumns = MOST_SAMPLES + ROOM;
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

  /** @returns {Outcome} that the last call has left */
  function outcome() {
    return {
      epsilonT: summary[0],
      switches: summary[1],
      isCertain: summary[2] === 1,
      errorBound: summary[3],
      psi: summary[4],
      contactDuration: summary[5],
      epsilonN: summary[6],
      dissipatedShare: summary[7],
      coulomb: summary[8],
    };
  }

  /**
   * One collision.
   * @param {Collision} collision
   * @returns {Outcome | null}
   */
  function collision({ kappa, mu_over_alpha: mu, gt_over_gn: gt, damping }) {
    const given = [about.most_switches, kappa, mu, gt, summary.byteOffset];
    return callOver(damping, "collide", ...given) ? outcome() : null;
  }

  /**
   * Copies of numbers in memory, at the beginning of the arrays of a call.
   * @param {Float64Array[]} columns of one length
   */
  function put(columns) {
    top = rest;
    return columns.map((column) => {
      const address = reserve(8 * column.length);
      new Float64Array(memory.buffer, address, column.length).set(column);
      return address;
    });
  }

  /**
   * The collisions of a list, a cut or a map.
   * @param {List} list
   * @param {number} [mostSwitches] collisions of more are not followed
   * @returns {Outcomes | null}
   */
  function collisions(
    { kappa, muOverAlpha, gtOverGn, damping },
    mostSwitches = about.most_switches,
  ) {
    const size = kappa.length;
    const found = {
      epsilonT: new Float64Array(size),
      switches: new Int32Array(size),
      isCertain: new Uint8Array(size),
      errorBound: new Float64Array(size),
    };
    for (let begin = 0; begin < size; begin += PART) {
      const count = Math.min(PART, size - begin);
      const [kappas, tangentials] = put(
        [kappa, gtOverGn].map((all) => all.subarray(begin, begin + count)),
      );
      const made = [
        new Float64Array(memory.buffer, reserve(8 * count), count),
        new Int32Array(memory.buffer, reserve(4 * count), count),
        new Uint8Array(memory.buffer, reserve(count), count),
        new Float64Array(memory.buffer, reserve(8 * count), count),
      ];
      const addresses = made.map((array) => array.byteOffset);
      const given = [mostSwitches, count, kappas, muOverAlpha, tangentials, ...addresses];
      if (!callOver(damping, "collide_in_lanes", ...given, lanes, labels)) {
        return null;
      }
      Object.values(found).forEach((all, i) => all.set(made[i], begin));
    }
    return found;
  }

  /**
   * What simple laws have for the collisions of a list, as short as a cut.
   * @param {List} list of at most `PART` collisions
   * @param {number} epsilonN of all of them
   * @returns {SimpleLaws | null}
   */
  function simpleLaws({ kappa, muOverAlpha, gtOverGn, damping }, epsilonN) {
    const count = kappa.length;
    const [kappas, tangentials] = put([kappa, gtOverGn]);
    const made = [0, 1, 2].map(() => reserve(8 * count));
    const damped = damping > 0 ? 1 : 0;
    const given = [epsilonN, damped, count, kappas, muOverAlpha, tangentials, ...made];
    if (!call("find_simple_laws", ...given)) {
      return null;
    }
    const [coulomb, stiffBound, stiffAsymptote] = made.map((address) => numbers(address, count));
    return { coulomb, stiffBound, stiffAsymptote };
  }

  /** @param {number} address @param {number} count */
  function numbers(address, count) {
    return new Float64Array(memory.buffer, address, count).slice();
  }

  /** @param {number} address @param {number} count */
  function signs(address, count) {
    return new Int8Array(memory.buffer, address, count).slice();
  }

  /**
   * One collision at uniform instants, merged with those of its switches.
   * @param {Collision} collision
   * @param {number} samples 2 to `MOST_SAMPLES`
   * @returns {Trace | null}
   */
  function trace({ kappa, mu_over_alpha: mu, gt_over_gn: gt, damping }, samples) {
    if (samples < 2 || samples > MOST_SAMPLES) {
      return null;
    }
    top = rest;
    const starts = reserve(8 * ROOM);
    const directions = reserve(ROOM);
    const time = reserve(8 * mostColumns);
    const columns = reserve(8 * COLUMNS * mostColumns);
    const regime = reserve(mostColumns);
    const arrays = [starts, directions, time, columns, regime, lanes, labels, summary.byteOffset];
    const given = [about.most_switches, kappa, mu, gt, samples, ROOM];
    if (!callOver(damping, "trace", ...given, ...arrays)) {
      return null;
    }
    const followed = outcome();
    const episodes = followed.switches + 1;
    const size = samples + followed.switches;
    /** @param {number} row */
    const column = (row) => numbers(columns + 8 * row * size, size);
    return {
      ...followed,
      reversals: summary[OUTCOME],
      firstEpisodeShare: summary[OUTCOME + 1],
      starts: numbers(starts, episodes),
      directions: signs(directions, episodes),
      time: numbers(time, size),
      compression: column(0),
      compressionRate: column(1),
      normalForce: column(2),
      tangentialVelocity: column(3),
      springElongation: column(4),
      tangentialForceOverMu: column(5),
      tangentialEnergy: column(6),
      regime: signs(regime, size),
    };
  }

  /**
   * A ball of α that bounces off a wall or an equal sphere.
   * @param {number} alpha
   * @param {"wall" | "sphere"} partner
   * @param {Collision} given
   * @param {Pick<Outcome, "epsilonN" | "epsilonT">} found of that
   * @returns {Bounce}
   */
  function bounce(alpha, partner, given, { epsilonN, epsilonT }) {
    const massShare = about.mass_shares[partner];
    const { kappa: before, gt_over_gn: gt, damping: eta } = given;
    call("bounce", alpha, massShare, before, gt, eta, epsilonN, epsilonT, summary.byteOffset);
    const [centreChange, spinChange, kappa, gtOverGn, damping] = summary;
    return { massShare, centreChange, spinChange, kappa, gtOverGn, damping };
  }

  return { collision, collisions, simpleLaws, trace, bounce };
}
