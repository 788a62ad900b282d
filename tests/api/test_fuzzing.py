"""The whole OpenAPI document, fuzzed by schemathesis with every check on a real server.

The checks: no 5xx; statuses, content types, headers and bodies as described; what the description
excludes is refused, what it allows is answered; other methods are 405 with `Allow`; see
schemathesis.toml for what counts as expected and why.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from servers import serving

HERE = Path(__file__).parent
OFF = {
    "POST /api/v1/tradeoff/runs",
    "GET /api/v1/tradeoff/runs/{name}",
    "DELETE /api/v1/tradeoff/runs/{name}",
}
"""Refused unless a setting allows it."""

NESTED = {"POST /api/v1/scaling", "POST /api/v1/scaling/map", "POST /api/v1/codes"}
"""Five random bodies may all miss what must suit each other; the many more of `make verify` do
not, and examples of both are answered in every run."""


def fuzz(server, folder, cases, *options):
    """Return the report of schemathesis with up to `cases` random ones for each operation."""
    report = folder / "report.json"
    command = [
        Path(sys.executable).with_name("schemathesis"),
        f"--config-file={HERE / 'schemathesis.toml'}",
        "run",
        f"{server}/openapi.json",
        "--checks=all",
        f"--max-examples={cases}",
        "--no-color",
        "--report=json",
        f"--report-json-path={report}",
        *options,
    ]
    # its output is what a failure says
    done = subprocess.run(command, cwd=HERE.parents[1], capture_output=True, text=True, check=False)
    assert report.exists(), done.stdout + done.stderr
    found = json.loads(report.read_text())
    print(f"{found['test_cases']['generated']} cases in {found['running_time']:.0f} s")
    print(f"seed {found['seed']}")
    if done.returncode or found["failures"] or found["errors"] or not found["complete"]:
        pytest.fail(done.stdout[-20_000:])
    assert found["operations"]["tested"] == found["operations"]["total"]
    assert {phase["status"] for phase in found["phases"].values()} <= {"success", "skip"}
    return found


def idle(found, phase):
    """Return the operations of which not one random case got an answer."""
    return {name for name, rates in found["valid_rates"].items() if not rates[phase]["accepted"]}


def test_service_is_as_described(server, tmp_path):
    # the systematic cases take many times as long; `make verify` has them, and our own are in
    # test_nonsense.py and test_hostile_input.py
    phases = "--phases=examples,fuzzing,stateful"
    found = fuzz(server, tmp_path, 5, "--generation-deterministic", phases)
    assert found["test_cases"]["generated"] >= 120
    # fuzzing that is refused at the door would find nothing behind it
    assert idle(found, "fuzzing") <= OFF | NESTED


@pytest.mark.verify
def test_service_is_as_described_in_many_more_cases(tmp_path):
    with serving(tmp_path, tradeoff_runs=True) as running:
        # the only DELETE cancels a run, which goes on to tell how far it got: it is not gone
        found = fuzz(running.url, tmp_path, 600, "--exclude-checks=use_after_free")
    assert {phase["status"] for phase in found["phases"].values()} == {"success"}
    assert found["test_cases"]["generated"] >= 10_000
    assert idle(found, "fuzzing") == set()
    assert "Traceback" not in (tmp_path / "log").read_text()
