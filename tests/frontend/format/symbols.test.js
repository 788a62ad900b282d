import assert from "node:assert/strict";
import { test } from "node:test";

import { splitSymbols } from "../../../frontend/format/symbols.js";

/** The text with its symbols in braces. */
function marked(text) {
  return splitSymbols(text)
    .map(({ plain, letter, index }) => plain ?? `{${letter}${index ? ` ${index}` : ""}}`)
    .join("");
}

test("splitSymbols finds letters with an index and Greek letters", () => {
  assert.equal(
    marked("ε_t is the limit; κ = (π/t_c)² and g_t/g_n, ψ = 0.97 at t = 1"),
    "{ε t} is the limit; {κ} = (π/{t c})² and {g t}/{g n}, {ψ} = 0.97 at {t} = 1",
  );
});

test("splitSymbols leaves words, names and numbers alone", () => {
  for (const text of ["", "kappa_min = 3", "Müller & Pöschel, 10⁻⁶ m", "snake_case", "5 µm"]) {
    assert.equal(marked(text), text);
  }
});

test("splitSymbols loses nothing of a text", () => {
  const text = "its κ = 18 is taken as ακ, with μ = 0.4, α = 2/7; k_t = 10¹² N/m <b>x</b>";
  assert.equal(
    marked(text)
      .replaceAll(/[{}]/g, "")
      .replaceAll(/\b([kg]) t/g, "$1_t"),
    text,
  );
});

test("splitSymbols sets indices and powers in braces", () => {
  assert.deepEqual(splitSymbols("m_{eff}g_n κ^{−5/4}, 10^{12}, F_n^{max}, R_iΩ_i"), [
    { letter: "m", index: "eff" },
    { letter: "g", index: "n" },
    { plain: " " },
    { letter: "κ", index: "" },
    { power: "−5/4" },
    { plain: ", 10" },
    { power: "12" },
    { plain: ", " },
    { letter: "F", index: "n" },
    { power: "max" },
    { plain: ", " },
    { letter: "R", index: "i" },
    { letter: "Ω", index: "i" },
  ]);
});
