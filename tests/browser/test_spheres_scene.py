"""The scene of real spheres: in SI units, answered by the API, linked to all the rest."""

import urllib.parse
from pathlib import Path

import pytest
from explorer import (
    body_of,
    collision_of,
    materials,
    number,
    post,
    settle,
    text,
    trace_of,
)
from playwright.sync_api import Page, expect
from rest import eventually

pytestmark = pytest.mark.browser


def shows(page: Page, answer: dict) -> None:
    """The strip, the table of the impact and the address agree with an answer of `/scaling`."""
    assert number(text(page, "epsilon-t")) == float(f"{answer['epsilon_t']:.4g}")
    # what the page carries over has twelve digits, and no hidden ones
    for name, value in collision_of(page).items():
        assert value == float(f"{answer[name]:.12g}")
    terms = page.get_by_test_id("impact-result").locator("dt").all_inner_texts()
    values = page.get_by_test_id("impact-result").locator("dd").all_inner_texts()
    shown = dict(zip(terms, values, strict=True))
    assert number(shown["κ"]) == pytest.approx(answer["kappa"], rel=5e-4)
    assert number(shown["εt of the spring"]) == float(f"{answer['epsilon_t']:.4g}")


def test_a_material_is_shown_as_the_api_answers(page: Page, server: str):
    page.goto("/?scene=spheres&material=alumina-on-glass")
    material = materials(server)["alumina-on-glass"]
    answer = post(server, "scaling", body_of(material))
    eventually(lambda: shows(page, answer), page)
    settle(page, server)

    def measured_are_there() -> None:
        points = trace_of(page, "sphere-cut")[2]
        wanted = [p["epsilon_t"] for p in material["measured"]["points"]]
        assert set(points["y"]) <= set(wanted)
        assert len(points["y"]) >= 6

    eventually(measured_are_there, page)


@pytest.mark.verify
def test_a_velocity_set_by_hand_moves_everything(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel")
    field = page.get_by_test_id("normal-velocity-m-s-field")
    expect(field).to_have_value("20")
    field.fill("1")
    field.press("Enter")
    answer = post(server, "scaling", body_of(materials(server)["steel"], normal_velocity_m_s=1.0))
    eventually(lambda: shows(page, answer), page)
    assert answer["kappa"] == pytest.approx(37204, rel=1e-4)
    assert "normal_velocity_m_s=1" in page.url


@pytest.mark.verify
def test_the_crosshair_sets_both_velocities(page: Page, server: str):
    page.goto("/?scene=spheres&material=alumina-on-glass")
    crosshair = page.get_by_test_id("velocity-crosshair")
    expect(crosshair).to_have_attribute("data-placed", "")
    box = crosshair.bounding_box()
    page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])

    def moved() -> None:
        query = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
        for name in ("normal_velocity_m_s", "tangential_velocity_m_s"):
            assert name in query
            assert float(query[name][0]) == pytest.approx(2.5, abs=0.05)

    eventually(moved, page)
    settle(page, server)


def test_the_map_of_velocities_is_that_of_the_api(page: Page, server: str):
    page.goto("/?scene=spheres&material=glass-on-glass&velocity_law=coulomb")

    def cells_agree() -> None:
        cells = page.get_by_test_id("velocities").evaluate(
            "plot => plot.data?.[0].z.map((row) => [...row]) ?? []"
        )
        assert len(cells) > 60
        body = body_of(materials(server)["glass-on-glass"])
        impact = body.pop("impact")
        assert max(impact.values()) == 1.0
        most = 2.0
        axes = {
            "normal_velocity_m_s": {"min": most / 200, "max": most, "count": len(cells[0])},
            "tangential_velocity_m_s": {"min": 0.0, "max": most, "count": len(cells)},
        }
        answer = post(server, "scaling/map", body | axes | {"quantities": ["coulomb"]})
        # told in a word: in CI pytest would list what differs in thousands of cells
        is_answer = cells == answer["coulomb"]
        assert is_answer

    eventually(cells_agree, page)


@pytest.mark.verify
def test_a_file_of_what_was_posted_can_be_had(page: Page, tmp_path: Path):
    page.goto("/?scene=spheres")
    expect(page.get_by_test_id("impact-result")).to_contain_text("µs")
    page.get_by_test_id("menu-impact").click()
    with page.expect_download() as download:
        page.locator("#menu-impact").get_by_text("CSV", exact=True).click()
    saved = tmp_path / "impact.csv"
    download.value.save_as(saved)
    assert "kappa" in saved.read_text().splitlines()[0]
    page.locator("#menu-impact").get_by_text("API request").click()
    expect(page.locator("pre").first).to_contain_text("-d '{")


def test_warnings_say_where_the_model_is_left(page: Page):
    page.goto("/?scene=spheres&material=steel")
    expect(page.get_by_test_id("impact-warnings")).to_contain_text("Mindlin")


@pytest.mark.verify
def test_mindlins_stiffness_can_be_set_by_hand_and_had_back(page: Page, server: str):
    page.goto("/?scene=spheres&material=alumina-on-glass")
    material = materials(server)["alumina-on-glass"]
    field = page.get_by_test_id("tangential-stiffness-n-per-m-field")
    reset = page.get_by_test_id("tangential-stiffness-n-per-m-reset")
    mindlins = post(server, "scaling", body_of(material))
    eventually(lambda: shows(page, mindlins), page)
    assert float(field.input_value()) == pytest.approx(
        mindlins["tangential_stiffness_n_per_m"], rel=5e-4
    )
    expect(reset).to_be_disabled()
    field.fill("1e8")
    field.press("Enter")
    stiff = post(server, "scaling", body_of(material) | {"tangential_stiffness_n_per_m": 1e8})
    eventually(lambda: shows(page, stiff), page)
    reset.click()
    eventually(lambda: shows(page, mindlins), page)
    assert "tangential_stiffness" not in page.url


@pytest.mark.verify
def test_hollow_spheres_give_the_paper_axis_their_alpha(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel&map_x=alpha_kappa")
    expect(page.get_by_test_id("impact-result")).to_contain_text("2/7")
    page.get_by_test_id("inertia").locator("[value=hollow]").check()
    material = materials(server)["steel"]
    hollow = {name: material[name] | {"inertia": "hollow"} for name in ("body_1", "body_2")}
    answer = post(server, "scaling", body_of(material) | hollow)
    assert answer["alpha"] == pytest.approx(0.4)
    eventually(lambda: shows(page, answer), page)

    def alpha_on_axis(text: str) -> None:
        title = page.get_by_test_id("map").locator(".xtitle")
        assert " ".join(title.text_content().split()) == text

    page.get_by_test_id("scenes").get_by_text("Explorer").click()
    eventually(lambda: alpha_on_axis("ακ with α = 0.4"), page)
    assert "&alpha=0.4" in page.url
    page.reload()
    eventually(lambda: alpha_on_axis("ακ with α = 0.4"), page)
    page.get_by_test_id("alpha-reset").click()
    eventually(lambda: alpha_on_axis("ακ with α = 2/7, solid spheres"), page)
    expect(page.get_by_test_id("alpha-reset")).to_be_hidden()
    assert "alpha=" not in page.url.replace("mu_over_alpha=", "")
    page.go_back()
    eventually(lambda: alpha_on_axis("ακ with α = 0.4"), page)
    page.get_by_test_id("presets").get_by_text("Gear wheel").click()
    eventually(lambda: alpha_on_axis("ακ with α = 2/7, solid spheres"), page)


@pytest.mark.verify
def test_back_from_the_explorer_the_impact_stands_in_the_strip_again(page: Page, server: str):
    page.goto("/?scene=spheres&material=glass-on-glass")
    answer = post(server, "scaling", body_of(materials(server)["glass-on-glass"]))
    eventually(lambda: shows(page, answer), page)
    page.get_by_test_id("scenes").get_by_text("Explorer").click()
    page.get_by_test_id("presets").get_by_text("Gear wheel").click()
    settle(page, server)
    page.get_by_test_id("scenes").get_by_text("Real spheres").click()
    eventually(lambda: shows(page, answer), page)


def test_an_impact_that_is_refused_is_not_shown_as_another(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel")
    answer = post(server, "scaling", body_of(materials(server)["steel"]))
    eventually(lambda: shows(page, answer), page)
    field = page.get_by_test_id("radius-m-field")
    field.fill("1e-300")
    field.press("Enter")
    expect(page.get_by_test_id("impact-refusal")).to_contain_text("Not this one")
    expect(page.get_by_test_id("impact-result")).to_be_hidden()
    expect(page.get_by_test_id("result")).to_have_attribute("data-stale", "")
    field.fill("0.02")
    field.press("Enter")
    eventually(lambda: shows(page, answer), page)
    expect(page.get_by_test_id("impact-refusal")).to_be_empty()


MORE = ("normal-restitution", "density-kg-m3", "poisson-ratio", "radius-2-m", "poisson-ratio-2")


@pytest.mark.verify
def test_the_rest_of_the_bodies_is_folded_away_until_it_is_wanted(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel-mindlin")
    material = materials(server)["steel-mindlin"]
    eventually(lambda: shows(page, post(server, "scaling", body_of(material))), page)
    for name in MORE:
        expect(page.get_by_test_id(f"{name}-field")).to_have_count(0)
    page.get_by_test_id("more-bodies").locator("summary").click()
    for name in MORE:
        expect(page.get_by_test_id(f"{name}-field")).to_be_visible()
    # what follows from the dissipative constant
    expect(page.get_by_test_id("normal-restitution-field")).to_have_value("1")
    expect(page.get_by_test_id("density-kg-m3-field")).to_have_value("7850")
    assert "density" not in page.url
    assert "second" not in page.url


@pytest.mark.verify
def test_a_normal_restitution_stands_in_for_the_dissipative_constant(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel-mindlin&dissipative_constant_s=1e-6")
    material = materials(server)["steel-mindlin"]
    page.get_by_test_id("more-bodies").locator("summary").click()
    field = page.get_by_test_id("normal-restitution-field")
    field.fill("0.9")
    field.press("Enter")
    body = body_of(material)
    del body["dissipative_constant_s"]
    answer = post(server, "scaling", body | {"normal_restitution": 0.9})
    eventually(lambda: shows(page, answer), page)
    assert answer["epsilon_t"] == pytest.approx(0.42297039, abs=5e-9)
    assert "normal_restitution=0.9" in page.url
    assert "dissipative_constant_s" not in page.url
    settle(page, server)
    constant = page.get_by_test_id("dissipative-constant-s-field")
    assert float(constant.input_value()) == pytest.approx(2.314e-6)
    # and it is said of which velocity ε_n is one
    note = page.locator(".parameter-note")
    expect(note).to_have_text("This εn holds at the gn above; when that changes, A follows.")
    velocity = page.get_by_test_id("normal-velocity-m-s-field")
    velocity.fill("2")
    velocity.press("Enter")
    eventually(lambda: float(constant.input_value()) < 2.3e-6, page)
    assert page.get_by_test_id("normal-restitution-field").input_value() == "0.9"
    velocity.fill("1")
    velocity.press("Enter")
    # set by hand again, that holds
    constant.fill("0")
    constant.press("Enter")
    eventually(lambda: shows(page, post(server, "scaling", body_of(material))), page)
    assert "normal_restitution" not in page.url
    expect(note).to_be_hidden()


@pytest.mark.verify
def test_a_frame_tells_its_collision_in_few_digits(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel&embed=impact")
    settle(page, server)
    expect(page.get_by_test_id("embed-caption")).to_contain_text("κ = 11224.9, μ/α = 1.4")


@pytest.mark.verify
def test_a_second_body_of_its_own_is_in_the_address_and_unfolded_there(page: Page, server: str):
    page.goto("/?scene=spheres&material=steel-mindlin&density_kg_m3=2500&radius_2_m=0.01")
    material = materials(server)["steel-mindlin"]
    first = material["body_1"] | {"density_kg_m3": 2500}
    body = body_of(material) | {"body_1": first, "body_2": first | {"radius_m": 0.01}}
    eventually(lambda: shows(page, post(server, "scaling", body)), page)
    expect(page.get_by_test_id("radius-2-m-field")).to_be_visible()
    page.get_by_test_id("second").locator("[value=wall]").check()
    wall = {"wall": True, **{n: first[n] for n in ("youngs_modulus_pa", "poisson_ratio")}}
    eventually(lambda: shows(page, post(server, "scaling", body | {"body_2": wall})), page)
    assert "second=wall" in page.url
    expect(page.get_by_test_id("radius-2-m-field")).to_be_hidden()
    expect(page.get_by_test_id("poisson-ratio-2-field")).to_be_visible()


@pytest.mark.verify
def test_an_address_that_tells_the_damping_twice_is_told_so(page: Page):
    page.goto("/?normal_restitution=0.9&dissipative_constant_s=1e-6")
    expect(page.get_by_test_id("notice")).to_contain_text("ε_n and A tell the same: ε_n is taken")
