"""The wheel, installed far from the checkout: page, service, command line, metadata."""

import os
import re
import subprocess
import sys
import tomllib
import urllib.parse
import urllib.request
from email import message_from_string
from pathlib import Path
from zipfile import ZipFile

import pytest
from packaging.metadata import Metadata

import restitution
from restitution.api.one_file import one_file
from servers import free_port, kill_with_children, wait_until_ready

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    options = ["--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", str(folder)]
    subprocess.run([*pip, "wheel", *options, ROOT], check=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """Run a command with the package of the wheel, in a folder with nothing else."""
    folder = tmp_path_factory.mktemp("installed")
    with ZipFile(wheel) as archive:
        archive.extractall(folder / "site")
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()

    def command(*words: str) -> dict:
        return {
            "args": [sys.executable, "-m", "restitution", *words],
            "cwd": elsewhere,
            "env": os.environ | {"PYTHONPATH": str(folder / "site")},
        }

    return command


def test_page_and_reference_pages_are_served(installed, tmp_path):
    port, log = free_port(), tmp_path / "log"
    command = installed("serve", "--port", str(port))
    with (
        log.open("wb") as output,
        subprocess.Popen(**command, stdout=output, stderr=subprocess.STDOUT) as process,
    ):
        try:
            wait_until_ready(f"http://127.0.0.1:{port}", process, log)

            def get(path: str) -> bytes:
                address = urllib.parse.urljoin(f"http://127.0.0.1:{port}/", path)
                with urllib.request.urlopen(address) as answer:
                    return answer.read()

            for page, least in (("", 50), ("docs", 2), ("redoc", 1)):
                text = get(page).decode()
                files = re.findall(r'(?:src|href)="(?!data:|https?:)([^"#]+)"', text)
                assert len(files) >= least, page
                # the guide is there only if it was made before the wheel
                for path in set(files) - {"guide/"}:
                    assert get(path), path
            assert b"epsilon_t" in get("api/v1/collision?kappa=63&mu_over_alpha=1&gt_over_gn=1")
        finally:
            kill_with_children(process)


def test_version_is_the_same_everywhere(installed, wheel):
    assert wheel.name == f"restitution-{restitution.__version__}-py3-none-any.whl"
    done = subprocess.run(**installed("--version"), check=True, capture_output=True, text=True)
    assert done.stdout == f"restitution {restitution.__version__}\n"


@pytest.fixture(scope="module")
def metadata(wheel):
    with ZipFile(wheel) as archive:
        (name,) = (each for each in archive.namelist() if each.endswith(".dist-info/METADATA"))
        return archive.read(name).decode()


def test_metadata_is_valid_and_says_what_a_registry_shows(metadata):
    found = Metadata.from_email(metadata, validate=True)
    assert found.license_expression == PROJECT["license"]
    assert set(found.license_files) >= {"LICENSE", "frontend/fonts/inter.LICENSE"}
    assert found.summary
    assert found.keywords
    assert {"cluster", "notebook", "peers"} == set(found.provides_extra)


def test_description_has_no_link_into_the_tree(metadata):
    text = message_from_string(metadata).get_payload()
    assert "How do spinning, frictional spheres bounce?" in text
    links = re.findall(r"\]\(([^)]*)\)", text)
    assert links
    assert all(link.startswith("https://doi.org/") for link in links), links


def test_licence_files_are_all_that_the_tree_has(metadata):
    there = {str(path.relative_to(ROOT)) for path in (ROOT / "frontend").rglob("*LICENSE*")}
    named = set(re.findall(r"^License-File: (.*)$", metadata, re.MULTILINE))
    assert named == there | {"LICENSE"}


def test_wheel_has_every_file_of_package_and_page_and_no_other(wheel):
    with ZipFile(wheel) as archive:
        found = {name for name in archive.namelist() if ".dist-info/" not in name}
    places = {
        ROOT / "backend": "",
        ROOT / "frontend": "restitution/frontend/",
        # if `make docs` has made it
        ROOT / "build" / "guide": "restitution/guide/",
    }
    assert found == {
        place + str(path.relative_to(folder))
        for folder, place in places.items()
        for path in folder.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }


def test_page_as_one_file_is_that_of_the_checkout(installed):
    written = subprocess.run(**installed("page", "--out", "-"), check=True, capture_output=True)
    assert written.stdout.decode() == one_file(ROOT / "frontend")
    assert written.stderr == b""
