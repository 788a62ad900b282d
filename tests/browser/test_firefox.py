"""Debian's Firefox walks every scene, drags, shows a panel alone, and prints; also the one file."""

import json
import subprocess
import urllib.parse
from pathlib import Path

import pytest
from explorer import ask, number
from scenes_of_file import OFFERED, SERVED
from set_up_program import program_of_machine

from restitution.api.one_file import one_file
from restitution.api.settings import Settings

FIREFOX = program_of_machine("firefox-esr")

pytestmark = [
    pytest.mark.browser,
    pytest.mark.verify,
    pytest.mark.skipif(not FIREFOX, reason="there is no Firefox: `make verify` installs one"),
]


def run(script: str, *given: str) -> dict:
    command = ["node", str(Path(__file__).with_name(script)), str(FIREFOX), *given]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict = json.loads(done.stdout)
    print(json.dumps(found, ensure_ascii=False))
    return found


def test_firefox_shows_every_scene_and_follows_a_drag(server: str):
    found = run("firefox.js", f"{server}/")
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


def test_firefox_opens_the_one_file_from_a_folder(tmp_path: Path):
    file = tmp_path / "restitution.html"
    file.write_text(one_file(Settings().frontend_directory), "utf-8")
    served = [f"scene={scene}" for scene in SERVED]
    found = run("firefox-file.js", file.as_uri(), *OFFERED.values(), *served)
    assert (found["words"], found["elsewhere"]) == ([], [])
    assert [each["state"] for each in found["seen"] if each["wide"] > 0] == []
    without = {OFFERED["hand-out"], *served}
    assert {each["state"] for each in found["seen"] if each["plots"] == 0} == without
    assert found["told"] == "0,01435"
