"""The page from Python: its options are those of the address, its server ends with the process."""

import json
import subprocess
import sys
import urllib.parse
import urllib.request
import webbrowser
from pathlib import Path
from types import SimpleNamespace

import pytest

from restitution.api.background import serve_in_background
from restitution.errors import ParameterError, RestitutionError
from restitution.public.explore import STATE, explore

ROOT = Path(__file__).parents[2]

RECORD = """
import { readAddress } from "./frontend/state/address/reading.js";
const asked = new Set();
for (const name of ["get", "has"]) {
  const real = URLSearchParams.prototype[name];
  URLSearchParams.prototype[name] = function (key) {
    asked.add(key);
    return real.call(this, key);
  };
}
readAddress("?inertia=solid");
console.log(JSON.stringify([...asked]));
"""
"""What the page looks for in an address."""

OWN_SERVER = """
import urllib.request, webbrowser
webbrowser.open = print
from restitution.public.explore import explore
first, second = explore(kappa=63), explore(embed="map")
with urllib.request.urlopen(first.url) as page:
    print(page.status, b"<title>" in page.read())
print(first.url.split("?")[0] == second.url.split("?")[0])
"""


@pytest.fixture
def opened(monkeypatch):
    """The addresses that the browser is told to open."""
    urls = []
    monkeypatch.setattr(webbrowser, "open", urls.append)
    return urls


def test_options_are_those_that_the_page_reads_from_its_address():
    node = Path(sys.executable).with_name("node")
    done = subprocess.run(
        [node, "--input-type=module", "--eval", RECORD],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    assert sorted(json.loads(done.stdout)) == sorted(STATE)


def test_state_becomes_the_address_that_the_browser_opens(opened):
    page = explore(server="http://there:1/", kappa=63, gt_over_gn=1e-05, embed="map")
    assert opened == [page.url]
    address = urllib.parse.urlsplit(page.url)
    assert f"{address.scheme}://{address.netloc}{address.path}" == "http://there:1/"
    state = dict(urllib.parse.parse_qsl(address.query))
    assert state == {"kappa": "63", "gt_over_gn": "1e-05", "embed": "map"}


def test_lists_become_the_address_of_a_frame_with_sliders(opened):
    page = explore(server="http://there:1/", embed=["force", "map"], sliders=("kappa",), kappa=20)
    assert page.url == "http://there:1/?embed=force,map&sliders=kappa&kappa=20"
    assert opened == [page.url]


def test_notebook_gets_a_frame_and_no_browser_is_opened(opened, monkeypatch):
    # as in a process that notebooks talk to
    shell = SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    page = explore(server="http://there:1", kappa=63, mu_over_alpha=1.4, height=400)
    assert opened == []
    frame = page._repr_html_()
    assert 'src="http://there:1/?kappa=63&amp;mu_over_alpha=1.4"' in frame
    assert 'height="400"' in frame


def test_terminal_of_ipython_has_the_browser_opened(opened, monkeypatch):
    shells = SimpleNamespace(get_ipython=object)
    monkeypatch.setitem(sys.modules, "IPython", shells)
    explore(server="http://there:1")
    assert opened == ["http://there:1/?"]


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("kapa", "as kappa or alpha"),
        ("embedded", "as embed"),
        ("zzz", "one of kappa, mu_over_alpha, .*"),
    ],
)
def test_option_that_the_page_lacks_is_refused_with_what_may_be_meant(name, meant, opened):
    with pytest.raises(ParameterError, match=f"^{name} must be an option of the page, {meant}"):
        explore(server="http://there:1", **{name: 1})
    assert opened == []


def test_own_server_serves_every_call_and_ends_with_the_process():
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", OWN_SERVER],
        capture_output=True,
        text=True,
        check=True,
    )
    first, second, answer, is_same = done.stdout.splitlines()
    assert first.startswith("http://127.0.0.1:")
    assert first.endswith("/?kappa=63")
    assert second.endswith("/?embed=map")
    assert (answer, is_same) == ("200 True", "True")
    # neither events of the service nor of its end
    assert done.stderr == ""
    with pytest.raises(OSError, match="refused"):
        urllib.request.urlopen(first)


def test_installation_without_a_page_says_so(monkeypatch, tmp_path):
    monkeypatch.setenv("RESTITUTION_FRONTEND_DIRECTORY", str(tmp_path))
    with pytest.raises(RestitutionError, match="FRONTEND_DIRECTORY must be a folder that holds"):
        serve_in_background()
