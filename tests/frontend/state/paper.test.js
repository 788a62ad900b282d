import assert from "node:assert/strict";
import { test } from "node:test";

import { countOf, grouped, labelOf } from "../../../frontend/state/paper.js";

const one = (id, kind, section, verdict) => ({
  id,
  kind,
  section,
  verdict,
  printed: "",
  computed: "",
  evidence: "",
  link: "?",
});
const STATEMENTS = [
  one("claim-b", "claim", "4.1", "fails"),
  one("equation-10", "equation", "2", "holds"),
  one("equation-9", "equation", "2", "corrected"),
  one("claim-a", "claim", "2", "holds"),
];
const ALL = { paper_verdict: "all", paper_kind: "all" };

test("grouped puts sections in the paper's order, kinds within them, and leaves out what is empty", () => {
  const found = grouped(STATEMENTS, ALL).map(({ id, kinds }) => [
    id,
    kinds.map((kind) => [kind.title, kind.statements.map((each) => each.id)]),
  ]);
  assert.deepEqual(found, [
    [
      "2",
      [
        ["Equations", ["equation-10", "equation-9"]],
        ["Claims", ["claim-a"]],
      ],
    ],
    ["4.1", [["Claims", ["claim-b"]]]],
  ]);
});

test("grouped loses no statement and cuts down to a verdict and a kind", () => {
  const ids = (wanted) =>
    grouped(STATEMENTS, { ...ALL, ...wanted }).flatMap(({ kinds }) =>
      kinds.flatMap(({ statements }) => statements.map(({ id }) => id)),
    );
  assert.equal(ids({}).length, STATEMENTS.length);
  assert.deepEqual(ids({ paper_verdict: "holds" }), ["equation-10", "claim-a"]);
  assert.deepEqual(ids({ paper_verdict: "holds", paper_kind: "claim" }), ["claim-a"]);
  assert.deepEqual(ids({ paper_kind: "figure" }), []);
});

test("countOf says how many there are of each verdict, and how many corrections in all", () => {
  const paper = { items: STATEMENTS, definitions: ["claim-a"], corrections: [{}] };
  assert.equal(
    countOf(paper),
    "2 hold, 1 of them as definitions; 1 hold with a correction, 1 different ones in all; 1 do not.",
  );
});

test("labelOf takes the paper's numbers, and ours where it has none", () => {
  const labels = STATEMENTS.map((each) => labelOf(each, STATEMENTS));
  assert.deepEqual(labels, ["Claim 1", "Eq. 10", "Eq. 9", "Claim 2"]);
});
