import assert from "node:assert/strict";
import { test } from "node:test";

import { sentenceOf } from "../../../frontend/format/sentence.js";
import { learn } from "../../../frontend/format/words.js";
import { wordsOf } from "../locales.js";

const FOLLOWED = { error_bound: 1e-14, limit: false };

/** That English ones are the service's own word for word, the tests in a browser see. @type {[object, RegExp][]} */
const GERMAN = [
  [
    { epsilon_t: 0.0143, switches: 8, reversals: 4, first_episode_share: 0.4912 },
    /^Gleitet 49 % der Stoßdauer, haftet, gleitet und haftet noch 3-mal, kehrt 4-mal um und gleitet bis zum Ende; 1 % der .* bleiben\.$/,
  ],
  [
    { epsilon_t: -0.4, switches: 3, reversals: 1, first_episode_share: 0.004 },
    /^Haftet weniger als 1 % der Stoßdauer, gleitet und haftet noch einmal, kehrt einmal um und gleitet bis zum Ende; 40 % .*, in umgekehrter Richtung\.$/,
  ],
  [
    { epsilon_t: 0.5, switches: 0, reversals: 0, first_episode_share: 1 },
    /^Gleitet während des ganzen Stoßes; 50 %/,
  ],
  [
    { epsilon_t: -1, switches: null, reversals: null, first_episode_share: null },
    /^Die Oberflächen .* Zahnrädern\.$/,
  ],
  [
    { epsilon_t: 0.1, error_bound: 0.0801, switches: null, first_episode_share: null },
    /^Höchstens 19 %/,
  ],
  [
    { epsilon_t: 0.1, error_bound: 1, switches: null, first_episode_share: null },
    /nicht bekannt\.$/,
  ],
  [
    { epsilon_t: 0.7, switches: 0, first_episode_share: 1, limit: true },
    /^Tangential bewegt sich nichts/,
  ],
];

test("sentenceOf tells how a collision goes and what is left, in the language of the page", () => {
  learn(wordsOf("de"));
  for (const [answer, sentence] of GERMAN) {
    assert.match(sentenceOf({ ...FOLLOWED, ...answer }), sentence);
  }
  learn(wordsOf("en"));
});
