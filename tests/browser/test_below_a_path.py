"""The page behind a proxy that shows it below a path, and in the frame of a stranger's page."""

import urllib.parse
from collections.abc import Iterator
from pathlib import Path

import pytest
from another_host import another_host
from example import PROGRAMS, behind
from explorer import Witness, text
from playwright.sync_api import Page
from rest import eventually, rest
from set_up_program import program_of_machine

from cases import every_day

pytestmark = pytest.mark.browser

SCENES = ["", "?scene=spheres", "?scene=accuracy", "?scene=paper", "?scene=lesson&step=2"]
EMBED = "?embed=force"
PAGES = [*SCENES, EMBED, "docs", "redoc"]
FIRST_SEEN = {"", EMBED}
"""Where ε_t stands in the strip."""


@pytest.fixture(
    params=["nginx", *(pytest.param(n, marks=pytest.mark.verify) for n in ("apache", "traefik"))]
)
def base(request: pytest.FixtureRequest, server: str, tmp_path: Path) -> Iterator[str]:
    """Where a proxy shows the server."""
    if not program_of_machine(PROGRAMS[request.param]):
        pytest.skip(f"there is no {request.param}")
    port = urllib.parse.urlsplit(server).port
    assert port
    with behind(request.param, tmp_path / "proxy", port) as address:
        yield f"{address}/"


# every third, or each
@pytest.mark.verify
def test_every_scene_is_there(stranger: Page, base: str):
    witness = Witness(stranger, base)
    bad: list[str] = []
    stranger.on("response", lambda r: r.status >= 400 and bad.append(f"{r.status} {r.url}"))
    for path in PAGES:
        stranger.goto(base + path)
        rest(stranger)
        assert stranger.url.startswith(base), path
        if path in FIRST_SEEN:
            assert text(stranger, "epsilon-t") != "–", path
    assert (witness.words, witness.strangers, bad) == ([], [], [])


def test_what_the_page_gives_away_leads_back_to_it(stranger: Page, base: str):
    stranger.goto(base)
    rest(stranger)
    stranger.get_by_test_id("menu-force").click()
    stranger.locator(":popover-open").get_by_text("API request", exact=True).click()
    assert f"{base}api/v1/trace?" in stranger.get_by_test_id("sheet").inner_text()


@pytest.mark.parametrize("path", every_day([EMBED], of=["", "?scene=paper", EMBED]))
def test_it_works_in_a_frame_that_may_run_scripts_and_nothing_else(
    stranger: Page, base: str, tmp_path: Path, path: str
):
    witness = Witness(stranger, base)

    def assert_told() -> None:
        shown = stranger.frame_locator("iframe").get_by_test_id("epsilon-t").inner_text()
        assert any(character.isdigit() for character in shown), stranger.url

    with another_host(tmp_path) as host:
        frame = f'<iframe sandbox="allow-scripts" width="1200" height="700" src="{base}{path}">'
        (tmp_path / "index.html").write_text(f"<!doctype html>{frame}</iframe>")
        stranger.goto(host)
        stranger.frame_locator("iframe").locator("main").wait_for()
        if path in FIRST_SEEN:
            eventually(assert_told, stranger)
    assert witness.words == []
    assert [url for url in witness.strangers if not url.startswith(host)] == []
