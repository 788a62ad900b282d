import assert from "node:assert/strict";
import { test } from "node:test";

import { textsOfMaterial } from "../../../frontend/format/materials.js";
import { warningInWords } from "../../../frontend/scenes/spheres/warnings.js";

const OBLIQUE = { angle_rad: 0.00312, epsilon_n_change: 0.0161 };

test("warningInWords says a warning with its numbers, in the words of the page", () => {
  const values = { over_mindlin: 2483.7, mindlin_n_per_m: 4.03e8 };
  const { text, language } = warningInWords({ code: "tangential_stiffness", text: "", values });
  assert.match(text, /^the tangential stiffness is 2480 times .* 4\.03\u202f×\u202f10⁸ N\/m$/);
  assert.equal(language, "");
});

test("warningInWords says a share in percent, as the server does", () => {
  const { text } = warningInWords({ code: "compression", text: "", values: { share: 0.059499 } });
  assert.match(text, /^the bodies are compressed by 5\.95\s%/);
});

test("warningInWords says by what a turning normal would move, as the server has it", () => {
  const said = (values) =>
    warningInWords({ code: "oblique", text: "", values: { ...OBLIQUE, ...values } }).text;
  assert.match(said({ epsilon_t_change: 0.5 }), /by 0\.0031 rad .* move ε_t by up to 0\.5$/);
  assert.match(said({ tangential_velocity_m_s: 0.003 }), /velocity of up to 0\.003 m\/s$/);
});

test("warningInWords says more than the largest number of what is beyond it", () => {
  const values = { pressure_pa: null, over_yield_stress: 3 };
  const { text } = warningInWords({ code: "plastic_flow", text: "", values });
  assert.match(text, /reaches > 1\.8\u202f×\u202f10³⁰⁸ Pa, 3 times/);
});

test("what the page has no words for is as the server has it, in English", () => {
  assert.deepEqual(warningInWords({ code: "new", text: "it melts", values: {} }), {
    text: "it melts",
    language: "en",
  });
  const material = { id: "new", title: "Ice", notes: "cold" };
  assert.deepEqual(textsOfMaterial(material), { name: "Ice", notes: "cold", language: "en" });
  const known = textsOfMaterial({ ...material, id: "alumina-on-glass" });
  assert.equal(known.name, "Alumina on glass");
  assert.equal(known.language, "");
});
