"""Debian's Firefox walks every scene, drags, shows a panel alone, and prints."""

import json
import subprocess
import urllib.parse
from pathlib import Path

import pytest
from explorer import ask, number
from set_up_program import program_of_machine

FIREFOX = program_of_machine("firefox-esr")

pytestmark = [
    pytest.mark.browser,
    pytest.mark.verify,
    pytest.mark.skipif(not FIREFOX, reason="there is no Firefox: `make verify` installs one"),
]


def test_firefox_shows_every_scene_and_follows_a_drag(server: str):
    script = Path(__file__).with_name("firefox.js")
    command = ["node", str(script), str(FIREFOX), f"{server}/"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    print(json.dumps(found, ensure_ascii=False))
    assert (found["words"], found["failed"]) == ([], [])
    # nothing is wider than the window, a phone's included
    assert [each["path"] for each in found["seen"] if each["wide"] > 0] == []
    assert found["wideOnPhone"] <= 0
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(found["dragged"]["address"]).query)
    names = ("kappa", "mu_over_alpha", "gt_over_gn")
    dragged = {name: query[name][0] for name in names}
    assert dragged["kappa"] != "63"
    truth = ask(server, "collision", **dragged)["epsilon_t"]
    assert number(found["dragged"]["told"]) == pytest.approx(truth, rel=1e-3)
    assert min(found["printed"]) > 20_000
