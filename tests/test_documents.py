"""The documents stay true: their commands run, their links lead somewhere."""

import json
import re
import shlex
import subprocess
import sys
import urllib.parse
from pathlib import Path

import numpy as np
import pytest
import yaml

from restitution.mechanics.collision import TOO_STIFF, collide
from restitution.studies.accuracy.report import tradeoff_report
from restitution.studies.accuracy.tradeoff import load_tradeoff

ROOT = Path(__file__).parents[1]
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?")
README = (ROOT / "README.md").read_text()
DOCUMENTS = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "CHANGELOG.md",
    ROOT / "SECURITY.md",
    *sorted((ROOT / "docs").glob("*.md")),
]


def test_python_example_runs_as_it_stands():
    (example,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    names: dict = {}
    exec(example, names)  # noqa: S102 - the example is ours
    import restitution  # noqa: PLC0415 - as the example does

    result = restitution.epsilon_t(kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358)
    assert f"{float(result):.5f}"[:6] in example
    assert names["trace"]["time"].size == 408


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    """The folder in which the walk was run, and what was said there."""
    folder = tmp_path_factory.mktemp("walk")
    script = Path(__file__).with_name("walk.py")
    done = subprocess.run(
        [sys.executable, "-W", "error", script, folder], capture_output=True, text=True, check=False
    )
    return folder, done


@pytest.mark.verify
def test_walk_through_the_python_api_runs_as_it_stands(walk):
    _, done = walk
    assert (done.returncode, done.stderr) == (0, ""), done.stdout + done.stderr
    assert int(done.stdout.split()[0]) > 60


def shape_and_numbers(picture: Path) -> tuple[str, np.ndarray]:
    """Return a picture without its numbers and pixels, and the numbers."""
    text = re.sub(r"base64,[^\"]*", "", picture.read_text())
    return re.sub(NUMBER, "", text), np.array(re.findall(NUMBER, text), float)


@pytest.mark.verify
def test_pictures_of_the_walk_are_those_that_it_draws(walk):
    folder, _ = walk
    drawn = sorted(folder.iterdir())
    text = (ROOT / "docs" / "python-walk.md").read_text()
    shown = [ROOT / "docs" / name for name in re.findall(r"!\[[^]]+\]\((pictures/[^)]+)\)", text)]
    assert [picture.name for picture in drawn] == sorted(picture.name for picture in shown)
    assert sorted(shown) == sorted((ROOT / "docs" / "pictures").iterdir())
    for picture in shown:
        assert picture.stat().st_size < 60_000, picture
        (shape, numbers), (again, others) = map(shape_and_numbers, (picture, folder / picture.name))
        assert shape == again, picture
        # hundredths of a point, as other processors round otherwise
        np.testing.assert_allclose(numbers, others, atol=0.01, err_msg=picture.name)


@pytest.mark.parametrize(("damping", "slope"), [(0.0, "4e-15"), (0.1, "1.3e-14"), (3.0, "1.3e-14")])
def test_errors_are_bounded_as_the_readme_says(damping, slope):
    assert f"{slope} (1 + √κ)" in README
    random = np.random.default_rng(15)
    kappa, psi = 10.0 ** random.uniform(-10, 8, 2000), 10.0 ** random.uniform(-10, 1, 2000)
    found = collide(kappa, psi, damping, 300.0)
    followed = found.switches != TOO_STIFF
    assert followed.mean() > 0.9
    bound = float(slope) * (1.0 + np.sqrt(kappa))
    assert np.all(found.error_bound[followed] <= bound[followed])


def test_citation_names_the_paper():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    (paper,) = citation["references"]
    assert paper["doi"] in (ROOT / "docs" / "references.md").read_text()


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda p: p.name)
def test_links_to_headings_and_elsewhere_are_well_formed(document):
    text = document.read_text()
    for name, heading in re.findall(r"\]\(([^):#]*)#([^)]+)\)", text):
        target = document.parent / name if name else document
        found = re.findall(r"^#+ (.*)$", target.read_text(), re.MULTILINE)
        anchors = {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in found}
        assert heading in anchors, (name, heading)
    # nothing here reaches the network: an address elsewhere must at least be one
    for address in re.findall(r"\]\((https?://[^)]*)\)", text):
        assert urllib.parse.urlsplit(address).hostname, address


@pytest.mark.parametrize("command", re.findall(r"^    (curl .*)$", README, re.MULTILINE))
def test_curl_example_answers(command, server):
    words = shlex.split(command.replace("http://127.0.0.1:8000", server))
    done = subprocess.run([*words, "--silent", "--fail"], capture_output=True, check=True)
    if "format=csv" in command:
        assert done.stdout.startswith(b"time,compression")
    else:
        assert "epsilon_t" in json.loads(done.stdout)


def test_make_targets_of_the_readme_exist():
    makefile = (ROOT / "Makefile").read_text()
    named = set(re.findall(r"(?:^    |`)make ([a-z-]+)", README, re.MULTILINE))
    assert {"serve", "test", "check", "bench", "verify", "help"} <= named
    for target in named:
        assert re.search(rf"^{target}:", makefile, re.MULTILINE), target


def test_calls_of_the_readme_are_those_of_the_service(server):
    import urllib.request  # noqa: PLC0415 - only here

    with urllib.request.urlopen(f"{server}/openapi.json") as answer:
        paths = {p.removeprefix("/api/v1") for p in json.load(answer)["paths"] if "/api/" in p}
    (sentence,) = re.findall(r"^Calls: (.*?)\. Each", README, re.MULTILINE | re.DOTALL)
    assert set(re.findall(r"`(/[\w/{}]+)`", sentence)) == paths


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda p: p.name)
def test_links_within_the_project_lead_somewhere(document):
    for target in re.findall(r"\]\((?!https?://)([^)#]+)", document.read_text()):
        assert (document.parent / target).exists(), target


def test_report_on_speed_and_accuracy_is_that_of_the_stored_measurement():
    # as `make tradeoff` writes it
    report = (ROOT / "docs" / "speed-and-accuracy.md").read_text()
    assert report == tradeoff_report(load_tradeoff())


def test_guide_is_refused_with_a_dead_link_a_lost_document_or_a_name_without_words(tmp_path):
    docs, site = tmp_path / "docs", tmp_path / "site"
    docs.mkdir()
    site.mkdir()
    (docs / "index.md").write_text("# A\n\n## B\n\n* [Reference](reference.md)\n")
    (docs / "lost.md").write_text("# Lost\n\n[nowhere](nowhere.md), [neither](index.md#neither)\n")
    (docs / "reference.md").write_text(
        "# R\n\n```{eval-rst}\n.. currentmodule:: restitution\n\n"
        ".. autoclass:: restitution.studies.accuracy.tradeoff.WantedError\n```\n"
    )
    script = ROOT / "deploy" / "make_guide.py"
    done = subprocess.run(
        [sys.executable, script, site, docs], capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    for complaint in [
        "lost.md: WARNING: document isn't included in any toctree",
        "target not found: 'nowhere.md'",
        "'neither'",
        "restitution.trace is not in docs/reference.md",
        "WantedError.needed is explained nowhere",
    ]:
        assert complaint in done.stderr, done.stderr
    # what was there stays
    assert set(tmp_path.iterdir()) == {docs, site}
    assert list(site.iterdir()) == []


def test_no_document_names_a_place_on_a_machine():
    for document in DOCUMENTS:
        found = re.search(r"(?<![\w.])/(home|root|work|Users)/", document.read_text())
        assert not found, (document.name, found)
