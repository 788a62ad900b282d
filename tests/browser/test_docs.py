"""The description of the API for people: it shows every call, says nothing, calls nobody."""

import pytest
from explorer import Witness
from playwright.sync_api import Page
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

CALLS = ("/api/v1/collision", "/api/v1/trace", "/api/v1/scaling/map", "/api/v1/table", "/readyz")


@pytest.mark.verify
def test_swagger_shows_every_call_and_tries_one(page: Page, server: str):
    witness = Witness(page, server)
    page.goto("/docs")
    for call in CALLS:
        page.locator(f"[data-path='{call}']").first.wait_for()
    assert page.locator(".errors-wrapper").count() == 0
    first = page.locator("#operations-collisions-collision")
    first.locator(".opblock-summary-control").click()
    first.get_by_role("button", name="Try it out").click()
    # the example stands in the fields
    first.get_by_role("button", name="Execute").click()
    answer = first.locator(".live-responses-table")
    answer.wait_for()
    assert "epsilon_t" in answer.inner_text()
    rest(page)
    witness.assert_silence()
    assert witness.last("collision")["kappa"] == "63"


@pytest.mark.verify
def test_redoc_shows_every_call(page: Page, server: str):
    witness = Witness(page, server)
    page.goto("/redoc")
    page.get_by_role("heading", name="Collisions along one parameter").wait_for()
    page.get_by_role("heading", name="Real bodies over both velocities").wait_for()
    page.get_by_role("textbox").first.fill("friction")
    page.get_by_role("menuitem").first.wait_for()
    rest(page)
    witness.assert_silence()


@pytest.mark.parametrize("path", every_day(["/docs"], of=["/docs", "/redoc"]))
def test_the_policy_stops_a_script_that_found_its_way_in(page: Page, path: str):
    policy = page.goto(path).headers["content-security-policy"]
    scripts = policy.partition("script-src ")[2].partition(";")[0]
    assert "unsafe" not in scripts
    page.evaluate("""() => {
      const script = document.createElement("script");
      script.textContent = "window.broken = true";
      document.body.append(script);
    }""")
    assert page.evaluate("() => window.broken") is None
