import assert from "node:assert/strict";
import { test } from "node:test";

import {
  mayBeTooStiffToDraw,
  MOST_SWITCHES_DRAWN,
  whyNotDrawn,
} from "../../../frontend/state/drawable.js";

test("mayBeTooStiffToDraw lets nothing through that may switch too often", () => {
  const CONTACT_DURATION = 3.2180654597;
  for (let kappa = 1; kappa < 1e12; kappa *= 1.1) {
    const most = (Math.sqrt(kappa) * CONTACT_DURATION) / Math.PI + 2;
    assert.ok(mayBeTooStiffToDraw({ kappa }) || most <= MOST_SWITCHES_DRAWN, String(kappa));
  }
  assert.ok(!mayBeTooStiffToDraw({ kappa: 1e8 }));
});

test("whyNotDrawn counts where there is a count", () => {
  assert.match(whyNotDrawn({ switches: 30_000 }), /30000 times/);
  assert.match(whyNotDrawn({ switches: null }), /too stiff/);
});
