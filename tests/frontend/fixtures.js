/** A theme of plain words, in which a test can find a colour again. */
export const THEME = {
  dark: false,
  unit: 1,
  words: 1,
  sans: "sans",
  paper: "paper",
  ink: "ink",
  inkSoft: "ink soft",
  rule: "rule",
  ruleStrong: "rule strong",
  grid: "grid",
  sliding: "forward solid",
  slidingBack: "backward solid",
  sticking: "sticking solid",
  many: "many solid",
  onRegime: "on regime",
  slidingShade: "forward shade",
  slidingBackShade: "backward shade",
  manyShade: "many shade",
  normalForce: "normal",
  tangentialForce: "tangential",
  velocity: "velocity",
  negative: "negative",
  pinA: "pin A",
  pinB: "pin B",
  pinC: "pin C",
  methodTable: "table",
  methodSteps: "steps",
  methodEuler: "euler",
  methodOde: "ode",
  methodPeer: "peer",
};

export const SIZE = { width: 600, height: 400 };

/** A made-up trace: slides, sticks, slides back; the velocity changes its sign once. */
export function makeTrace(changes = {}) {
  return {
    time: Float64Array.of(0, 1, 2, 3),
    normal_force: Float64Array.of(0, 1, 1, 0),
    tangential_force_over_mu: Float64Array.of(0, -1, 0.5, 0),
    tangential_velocity: Float64Array.of(1.2, 0.4, -0.4, -0.5),
    tangential_energy: Float64Array.of(0.72, 0.3, 0.2, 0.125),
    switch_times: Float64Array.of(1, 2),
    episodes: [
      { regime: "sliding", start: 0, end: 1, direction: 1 },
      { regime: "sticking", start: 1, end: 2, direction: 0 },
      { regime: "sliding", start: 2, end: 3, direction: -1 },
    ],
    contact_duration: 3,
    reversals: 1,
    ...changes,
  };
}
