import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { changeSearch, linkTo, presentSearch } from "../../../frontend/state/address/bar.js";

let refused = false;
const window = { name: "" };
const location = { search: "", href: "" };

beforeEach(() => {
  refused = false;
  window.name = "";
  Object.assign(location, { search: "", href: "file:///stick/restitution.html" });
  const history = {
    replaceState(_, __, search) {
      if (refused) {
        throw new DOMException("no", "SecurityError");
      }
      location.search = search;
    },
  };
  Object.assign(globalThis, { window, location, history });
});

test("the address holds the state", () => {
  changeSearch("replaceState", "?kappa=1");
  assert.equal(presentSearch(), "?kappa=1");
  assert.equal(window.name, "");
  assert.equal(linkTo("?kappa=1"), "file:///stick/restitution.html?kappa=1");
});

test("where the browser lets no address be changed, the name of the window holds it", () => {
  refused = true;
  location.href = "about:srcdoc";
  changeSearch("replaceState", "?lang=de");
  assert.equal(presentSearch(), "?lang=de");
  assert.equal(linkTo("?lang=de"), "?lang=de");
});

test("a name that somebody else gave, or that was given elsewhere, is no address", () => {
  for (const name of ["frame-of-the-course", "restitution:file:///stick/other.html ?lang=de"]) {
    window.name = name;
    location.search = "?kappa=2";
    assert.equal(presentSearch(), "?kappa=2");
  }
});
