"""The panel for users of DEM codes: folded until it is wanted, its numbers those of the API."""

import pytest
from explorer import ask, body_of, collision_of, materials, number, post, settle, visit
from playwright.sync_api import Page, expect
from rest import eventually, rest
from test_access import objections

pytestmark = pytest.mark.browser


def inputs_for(page: Page, server: str, material: str = "steel", velocity: float = 20) -> dict:
    """What the API has for the collision of the page and the bodies of a material."""
    body = body_of(materials(server)[material])
    bodies = {name: body[name] for name in ("body_1", "body_2")}
    return post(server, "codes", {**bodies, "normal_velocity_m_s": velocity, **collision_of(page)})


def shows(page: Page, answer: dict) -> None:
    items = page.get_by_test_id("codes-body").locator("li").all()
    assert len(items) == len(answer["codes"])
    for item, each in zip(items, answer["codes"], strict=True):
        assert item.locator("h3").text_content() == f"{each['code']} {each['style']}"
        if each["lines"]:
            assert item.locator("pre").text_content() == "\n".join(each["lines"])
        else:
            assert f"and κ = {each['kappa']:.4g} at any velocity" in item.text_content().replace(
                "\u00a0", " "
            )
        restitution = item.locator(".codes-restitution").text_content()
        if each["epsilon_t"] is None:
            assert restitution.startswith("another")
        else:
            assert number(restitution.removeprefix("εt = ")) == float(f"{each['epsilon_t']:.4g}")


def unfold(page: Page) -> None:
    details = page.get_by_test_id("codes")
    # that of the test before may be
    if details.get_attribute("open") is None:
        details.locator("summary").click()


@pytest.mark.verify
@pytest.mark.own_page
def test_nothing_is_asked_for_codes_until_it_is_wanted(page: Page, server: str):
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/?scene=accuracy&kappa=20")
    settle(page, server)
    rest(page)
    assert not [url for url in asked if url.endswith(("/codes", "/codes.js", "/materials"))]
    unfold(page)
    eventually(lambda: shows(page, inputs_for(page, server)), page)
    assert [url for url in asked if url.endswith("/codes")]


@pytest.mark.own_page
def test_a_part_that_did_not_arrive_comes_when_the_server_answers(page: Page, server: str):
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.route("**/accuracy/codes.js", lambda route: route.abort())
    page.goto("/?scene=accuracy&kappa=20")
    settle(page, server)
    unfold(page)
    expect(page.get_by_test_id("banner")).to_be_visible()
    page.unroute("**/accuracy/codes.js")
    eventually(lambda: shows(page, inputs_for(page, server)), page)
    assert errors == []


@pytest.mark.verify
def test_inputs_follow_the_collision(used_tab: Page, server: str):
    visit(used_tab, "/?scene=accuracy&kappa=20")
    settle(used_tab, server)
    unfold(used_tab)
    eventually(lambda: shows(used_tab, inputs_for(used_tab, server)), used_tab)
    field = used_tab.get_by_test_id("kappa-field")
    field.fill("45.5")
    field.press("Enter")
    eventually(lambda: collision_of(used_tab)["kappa"] == 45.5, used_tab)
    answer = inputs_for(used_tab, server)
    eventually(lambda: shows(used_tab, answer), used_tab)
    steps = ask(server, "steps", error=1e-3, **collision_of(used_tab))["needed"]
    needed = steps["velocity_verlet"]["worst"]
    step = 1e6 * answer["contact_duration_s"] / needed
    body = used_tab.get_by_test_id("codes-body")
    expect(body).to_contain_text(f"{step:.2g}\u202fµs, {needed} a contact, for 10⁻³")
    assert objections(used_tab) == []


def test_bodies_and_velocity_are_those_of_real_spheres(used_tab: Page, server: str):
    """What is told there comes back as it was told."""
    visit(used_tab, "/?scene=spheres&material=steel-mindlin&normal_velocity_m_s=3")
    settle(used_tab, server)
    # its collision is worked out only after its materials are there
    rest(used_tab)
    used_tab.get_by_test_id("scenes").get_by_text("Speed and accuracy").click()
    settle(used_tab, server)
    unfold(used_tab)
    answer = inputs_for(used_tab, server, "steel-mindlin", 3)
    eventually(lambda: shows(used_tab, answer), used_tab)
    steel = body_of(materials(server)["steel-mindlin"], normal_velocity_m_s=3)
    told = post(server, "scaling", steel)
    for name in ("tangential_stiffness_n_per_m", "contact_duration_s", "epsilon_t"):
        assert answer[name] == pytest.approx(told[name], rel=1e-9)
    body = used_tab.get_by_test_id("codes-body")
    expect(body.get_by_role("link", name="Other bodies")).to_have_attribute(
        "href", f"?{used_tab.url.partition('?')[2].replace('scene=accuracy', 'scene=spheres')}"
    )


def test_in_a_frame_it_is_unfolded(used_tab: Page, server: str):
    visit(used_tab, "/?scene=accuracy&embed=codes&damping=0.1")
    settle(used_tab, server)
    laws = used_tab.get_by_test_id("codes-body").locator("li")
    expect(laws.filter(has_text="HertzWithLinearShear(nonLin=0)")).to_contain_text(
        "another damping"
    )
    expect(laws.filter(has_text="gran/hooke/history")).to_contain_text("not with damping")
    expect(laws.first).to_contain_text("εt = ")
