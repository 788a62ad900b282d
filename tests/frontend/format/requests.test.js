import assert from "node:assert/strict";
import { test } from "node:test";

import {
  addressOf,
  curlOf,
  fileName,
  pythonOf,
  serverOf,
} from "../../../frontend/format/requests.js";

const SERVER = "https://example.org/bounce/";
const REQUEST = { call: "trace", query: { kappa: "63", quantities: "time,normal_force" } };

test("addressOf is the API's address with every parameter, commas left readable", () => {
  const address = "api/v1/trace?kappa=63&quantities=time,normal_force";
  assert.equal(addressOf(REQUEST), address);
  assert.equal(curlOf(REQUEST, SERVER), `curl "${SERVER}${address}"`);
});

test("serverOf is where the page is, below whatever path of a proxy", () => {
  assert.equal(serverOf("https://example.org/?kappa=63"), "https://example.org/");
  assert.equal(serverOf("https://example.org/bounce/?scene=lesson#laws"), SERVER);
});

test("pythonOf writes numbers as numbers and words as words", () => {
  const program = pythonOf(
    { call: "map", query: { kappa_min: "1e-7", kappa_scale: "log" } },
    SERVER,
  );
  assert.match(program, /^ {4}"kappa_min": 1e-7,$/m);
  assert.match(program, /^ {4}"kappa_scale": "log",$/m);
  assert.match(program, /urlopen\("https:\/\/example\.org\/bounce\/api\/v1\/map\?" \+ urlencode/);
});

test("what is posted is written out for the shell and for Python", () => {
  const request = { call: "scaling", query: {}, body: { friction_coefficient: 0.4 } };
  assert.equal(
    curlOf(request, SERVER),
    `curl "${SERVER}api/v1/scaling" -H "Content-Type: application/json" -d '{"friction_coefficient":0.4}'`,
  );
  assert.match(pythonOf(request, SERVER), /"friction_coefficient": 0\.4/);
});

test("fileName holds the parameters and nothing that a file system refuses", () => {
  assert.equal(
    fileName("force", { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1e-7 }, "csv"),
    "restitution-force-kappa-63-mu_over_alpha-1.4-gt_over_gn-1e-7.csv",
  );
  assert.equal(fileName("a/b", {}, "svg"), "restitution-ab.svg");
});
