// @ts-check

/**
 * The colours and the type of the page, as a figure needs them.
 * @typedef {object} Theme
 * @property {boolean} dark
 * @property {number} unit CSS pixels to one pixel of the design, more than one on a very large screen
 * @property {number} words how much larger than usual those in a picture are
 * @property {string} sans
 * @property {string} paper
 * @property {string} ink
 * @property {string} inkSoft
 * @property {string} rule
 * @property {string} ruleStrong
 * @property {string} grid
 * @property {string} sliding
 * @property {string} slidingBack
 * @property {string} sticking
 * @property {string} many sliding and sticking by turns, too quickly to be told apart
 * @property {string} onRegime text on the four colours before
 * @property {string} slidingShade
 * @property {string} slidingBackShade
 * @property {string} manyShade
 * @property {string} normalForce
 * @property {string} tangentialForce
 * @property {string} velocity
 * @property {string} negative ε_t on an axis that has no room below zero
 * @property {string} pinA of the collision that is pinned as A
 * @property {string} pinB
 * @property {string} pinC
 * @property {string} methodTable
 * @property {string} methodSteps
 * @property {string} methodEuler
 * @property {string} methodOde
 * @property {string} methodPeer
 */

/** Which custom property of the style sheet each of them is. */
export const THEME_PROPERTIES = {
  sans: "--sans",
  paper: "--paper",
  ink: "--ink",
  inkSoft: "--ink-soft",
  rule: "--rule",
  ruleStrong: "--rule-strong",
  grid: "--grid",
  sliding: "--sliding",
  slidingBack: "--sliding-back",
  sticking: "--sticking",
  many: "--many",
  onRegime: "--on-regime",
  slidingShade: "--sliding-shade",
  slidingBackShade: "--sliding-back-shade",
  manyShade: "--many-shade",
  normalForce: "--normal-force",
  tangentialForce: "--tangential-force",
  velocity: "--velocity",
  negative: "--negative",
  pinA: "--pin-a",
  pinB: "--pin-b",
  pinC: "--pin-c",
  methodTable: "--method-table",
  methodSteps: "--method-steps",
  methodEuler: "--method-euler",
  methodOde: "--method-ode",
  methodPeer: "--method-peer",
};
