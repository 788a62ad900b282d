"""The scene of real spheres: in SI units, answered by the API, linked to all the rest."""

import json
import urllib.parse
import urllib.request
from pathlib import Path

import pytest
from explorer import collision_of, eventually, number, settle, text, trace_of
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser


def post(server: str, call: str, body: dict) -> dict:
    request = urllib.request.Request(
        f"{server}/api/v1/{call}", json.dumps(body).encode(), {"Content-Type": "application/json"}
    )
    with urllib.request.urlopen(request) as answer:
        return json.load(answer)


def materials(server: str) -> dict[str, dict]:
    with urllib.request.urlopen(f"{server}/api/v1/materials") as answer:
        return {item["id"]: item for item in json.load(answer)["items"]}


def body_of(material: dict, **impact: float) -> dict:
    names = ["body_1", "body_2", "friction_coefficient", "tangential_stiffness_n_per_m"]
    chosen = {name: material[name] for name in [*names, "dissipative_constant_s"]}
    return chosen | {"impact": material["impact"] | impact}


def shows(page: Page, answer: dict) -> None:
    """The strip, the table of the impact and the address agree with an answer of `/scaling`."""
    assert number(text(page, "epsilon-t")) == float(f"{answer['epsilon_t']:.4g}")
    assert collision_of(page)["kappa"] == pytest.approx(answer["kappa"], rel=1e-12)
    terms = page.get_by_test_id("impact-result").locator("dt").all_inner_texts()
    values = page.get_by_test_id("impact-result").locator("dd").all_inner_texts()
    shown = dict(zip(terms, values, strict=True))
    assert number(shown["κ"]) == pytest.approx(answer["kappa"], rel=5e-4)
    assert number(shown["εt"]) == float(f"{answer['epsilon_t']:.4g}")


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
        assert cells == answer["coulomb"]

    eventually(cells_agree, page)


def test_a_file_of_what_was_posted_can_be_had(page: Page, tmp_path: Path):
    page.goto("/?scene=spheres")
    expect(page.get_by_test_id("impact-result")).to_contain_text("µs")
    page.get_by_test_id("menu-impact").click()
    with page.expect_download() as download:
        page.locator("#menu-impact").get_by_text("CSV").click()
    saved = tmp_path / "impact.csv"
    download.value.save_as(saved)
    assert "kappa" in saved.read_text().splitlines()[0]
    page.locator("#menu-impact").get_by_text("API request").click()
    expect(page.locator("pre").first).to_contain_text("-d '{")


def test_warnings_say_where_the_model_is_left(page: Page):
    page.goto("/?scene=spheres&material=steel")
    expect(page.get_by_test_id("impact-warnings")).to_contain_text("Mindlin")
