import assert from "node:assert/strict";
import { test } from "node:test";

import { learn } from "../../../frontend/format/words.js";
import { textsOf } from "../../../frontend/state/presets.js";
import { wordsOf } from "../locales.js";

const PAPER =
  "Schwager, Becker & Pöschel, Eur. Phys. J. E 27, 107 (2008), doi:10.1140/epje/i2007-10356-3";
const SLIDING = {
  id: "pure-sliding",
  title: "Pure sliding",
  source: `${PAPER}: Sect. 3, Eq. 15; ψ = 2.5`,
  caption: null,
  kappa: 18,
  mu_over_alpha: 1.4,
  gt_over_gn: 3.5,
};
const LETTER = { ...SLIDING, id: "figure-5-f", title: "Fig. 5 f", gt_over_gn: 0.966 };

test("a preset is told by its id in the language of the page, with the work that it is from", (t) => {
  learn(wordsOf("de"));
  t.after(() => learn(wordsOf("en")));
  assert.deepEqual(textsOf(SLIDING), {
    title: "Reines Gleiten",
    caption: "",
    source: `${PAPER}: Abschn. 3, Gl. 15; ψ\u00a0=\u00a02,5`,
    language: "",
  });
  assert.equal(textsOf(LETTER).title, "Abb. 5 f");
  assert.match(textsOf(LETTER).caption, /ψ.=.0,69\.$/);
});

test("the work that a source names is found wherever it stands in it", () => {
  const mindlin = "R. D. Mindlin, J. Appl. Mech. 16, 259 (1949)";
  const source = `Mindlin's stiffness at the largest compression, one material with ν = 0.3; ${mindlin}`;
  const told = textsOf({ ...SLIDING, id: "mindlin", source }).source;
  assert.equal(told.replaceAll("\u00a0", " "), source);
});

test("a preset that the page has no words for is told as the server has it", () => {
  const { title, source, language } = textsOf({ ...SLIDING, id: "of-tomorrow", title: "New" });
  assert.deepEqual([title, source, language], ["New", SLIDING.source, "en"]);
});
