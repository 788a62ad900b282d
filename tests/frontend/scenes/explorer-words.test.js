import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { horizontalName } from "../../../frontend/figures/share-axis.js";
import { mapTable } from "../../../frontend/figures/tables.js";
import { learn } from "../../../frontend/format/words.js";
import { forceFigure } from "../../../frontend/scenes/explorer/force-figure.js";
import { cutTable, forceTable, velocityTable } from "../../../frontend/scenes/explorer/tables.js";
import { velocityFigure } from "../../../frontend/scenes/explorer/velocity-figure.js";
import { whyNotDrawn } from "../../../frontend/state/drawable.js";
import { mapView, rowsOf } from "../../../frontend/state/map-view.js";
import { makeTrace, SIZE, THEME } from "../fixtures.js";
import { LOCALES, wordsOf } from "../locales.js";

const bracketed = (texts) =>
  typeof texts === "string"
    ? `⟦${texts}⟧`
    : Object.fromEntries(Object.entries(texts).map(([key, value]) => [key, bracketed(value)]));

before(() => learn(wordsOf("en", bracketed(LOCALES.en))));
after(() => learn(wordsOf("en")));

/** What of some texts is words and stands in no brackets. */
function unsaid(texts) {
  const left = texts.map((text) => {
    let plain = text.replaceAll(/<[^>]*>/g, "");
    while (plain.includes("⟦")) {
      plain = plain.replaceAll(/⟦[^⟦⟧]*⟧/g, "");
    }
    return plain;
  });
  return left.filter((text) => /\p{L}{3}/u.test(text));
}

/** What a figure writes. */
function textsOf({ data, layout: { xaxis, yaxis } }) {
  const axes = [xaxis, yaxis].flatMap(({ title, ticktext }) => [title?.text ?? "", ...ticktext]);
  return [...data.flatMap(({ text }) => text ?? []), ...axes];
}

const textsOfTable = ({ caption, headings, rows }) => [caption, ...headings, ...rows.flat()];

const COLLISION = { kappa: 2, mu_over_alpha: 1, gt_over_gn: 1, damping: 0 };

test("every word in a picture of the explorer is one of its language's", () => {
  const weak = makeTrace({ tangential_force_over_mu: Float64Array.of(0, -1e-3, 1e-3, 0) });
  const texts = [
    forceFigure(makeTrace(), THEME, SIZE),
    forceFigure(weak, THEME, SIZE),
    velocityFigure(makeTrace(), THEME, SIZE, true),
  ].flatMap(textsOf);
  assert.ok(texts.includes("⟦slides →⟧"));
  assert.deepEqual(unsaid(texts), []);
  const names = [2 / 7, 0.4].map((alpha) => horizontalName({ symbol: "alpha_kappa", alpha }));
  assert.deepEqual(unsaid(names), []);
});

test("every word in a table of the explorer is one of its language's", () => {
  const line = Float64Array.of(1, 2, 3);
  const grid = { kappa: line, gt_over_gn: line, epsilon_t: [line, line, line] };
  const cut = { values: line, epsilon_t: line, switches: line, coulomb: line };
  const views = ["gt_over_gn", "psi"].map((map_y) =>
    mapView(COLLISION, { scale: "linear", map_y }),
  );
  const maps = views.flatMap((view) =>
    ["epsilon_t", "switches"].map((quantity) =>
      mapTable(
        { grid: { ...grid, switches: grid.epsilon_t }, quantity },
        rowsOf(view, COLLISION),
        COLLISION,
      ),
    ),
  );
  const cuts = ["gt_over_gn", "kappa"].map((along) =>
    cutTable(
      {
        cut: { ...cut, stiff_bound: line, stiff_asymptote: line },
        view: views[0],
        along,
        held: 2,
        muOverAlpha: 1,
      },
      COLLISION,
    ),
  );
  const texts = [forceTable(makeTrace()), velocityTable(makeTrace()), ...maps, ...cuts].flatMap(
    textsOfTable,
  );
  assert.ok(texts.includes("⟦⟦sticks⟧, from here⟧"));
  assert.deepEqual(unsaid(texts), []);
});

test("why there is no picture is said in the language of the page", () => {
  assert.deepEqual(unsaid([1, null].map((switches) => whyNotDrawn({ switches }))), []);
});

test("the ribbon writes a long text where its letters have room, and a shorter one where not", () => {
  const ribbonOf = (width) => {
    const episodes = [{ regime: "sliding", start: 0, end: 0, direction: 1 }];
    const size = { ...SIZE, width };
    const { data } = forceFigure(makeTrace({ episodes, switch_times: [] }), THEME, size);
    return data.find(({ name }) => name === "ribbon").text.at(-1);
  };
  const say = (manyTooBrief_other) =>
    learn(wordsOf("en", { regimes: { many_other: "many", manyTooBrief_other } }));
  say("many, too brief to be drawn");
  assert.equal(ribbonOf(600), "many, too brief to be drawn");
  say("W".repeat(200));
  assert.equal(ribbonOf(600), "many");
});
