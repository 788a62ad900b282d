"""What the page shows, its fields take: units, powers, marks of thousands; in doubt it asks."""

import urllib.parse

import pytest
from explorer import collision_of, settle, text, visit
from playwright.sync_api import Page, expect
from rest import eventually, rest
from test_access import objections
from test_layout import FAULTS

from cases import every_day

pytestmark = pytest.mark.browser


def query_of(page: Page) -> dict[str, str]:
    return dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(page.url).query))


def has_in_address(page: Page, **wanted: str) -> None:
    assert query_of(page).items() >= wanted.items()


def typed_in(shown: str) -> str:
    """Return a stiffness as an address has it, of one that the page shows in MN/m."""
    number, unit = shown.split()
    assert unit == "MN/m"
    return str(round(float(number) * 1e6))


@pytest.mark.parametrize(
    ("name", "written", "value"),
    every_day(
        [("tangential_stiffness_n_per_m", "1.000 × 10¹² N/m", "1000000000000")],
        of=[
            ("radius_m", "20 mm", "0.02"),
            ("youngs_modulus_pa", "380\u202fGPa", "380000000000"),
            ("tangential_stiffness_n_per_m", "1.000 × 10¹² N/m", "1000000000000"),
            ("normal_velocity_m_s", "36 km/h", "10"),
            ("dissipative_constant_s", "12 µs", "0.000012"),
        ],
    ),
)
def test_a_unit_of_the_field_s_dimension_is_converted(
    used_tab: Page, name: str, written: str, value: str
):
    visit(used_tab, "/?scene=spheres&material=glass-on-glass")
    field = used_tab.get_by_test_id(f"{name.replace('_', '-')}-field")
    field.fill(written)
    field.press("Tab")
    eventually(lambda: has_in_address(used_tab, **{name: value}), used_tab)
    assert float(field.input_value()) == float(value)


@pytest.mark.verify
def test_a_unit_of_another_dimension_is_refused_in_words(used_tab: Page, server: str):
    visit(used_tab, "/?scene=spheres&material=glass-on-glass")
    settle(used_tab, server)
    field = used_tab.get_by_test_id("radius-m-field")
    before = field.input_value()
    field.fill("380 GPa")
    field.press("Tab")
    expect(used_tab.get_by_test_id("radius-m-problem")).to_have_text(
        "GPa is a pressure; the radius takes m, mm, cm, µm"
    )
    assert field.input_value() == before
    assert "radius_m" not in query_of(used_tab)


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("-5", "κ must be a number greater than 0"),
        ("−5 × 10⁻⁴", "κ must be a number greater than 0"),
        ("> 99.9 %", "“> 99.9 %” is a bound, not a value; κ takes one number"),
        ("±10⁻¹⁴", "“±10⁻¹⁴” is how far a value may be off, not the value; κ takes one number"),
    ],
)
def test_what_is_wrong_is_still_said_when_the_field_is_left(
    used_tab: Page, server: str, written: str, said: str
):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    field = used_tab.get_by_test_id("kappa-field")
    problem = used_tab.get_by_test_id("kappa-problem")
    field.fill(written)
    field.press("Tab")
    settle(used_tab, server)
    expect(problem).to_have_text(said)
    expect(field).to_have_value("20")
    field.fill("21")
    expect(problem).to_be_empty()


@pytest.mark.verify
def test_the_second_body_is_named_where_it_refuses(used_tab: Page):
    visit(used_tab, "/?scene=spheres&material=glass-on-glass&second=sphere&radius_2_m=0.03")
    field = used_tab.get_by_test_id("radius-2-m-field")
    field.fill("380 GPa")
    field.press("Tab")
    expect(used_tab.get_by_test_id("radius-2-m-problem")).to_have_text(
        "GPa is a pressure; the second radius takes m, mm, cm, µm"
    )


@pytest.mark.verify
def test_what_is_shown_is_taken(used_tab: Page, server: str):
    visit(used_tab, "/?scene=spheres&material=glass-on-glass")
    settle(used_tab, server)
    shown = used_tab.get_by_test_id("impact-result")
    values = dict(
        zip(
            shown.locator("dt").all_inner_texts(),
            shown.locator("dd").all_inner_texts(),
            strict=True,
        )
    )
    stiffness = values["kt"]
    field = used_tab.get_by_test_id("tangential-stiffness-n-per-m-field")
    field.fill(stiffness)
    field.press("Enter")
    name = "tangential_stiffness_n_per_m"
    eventually(lambda: has_in_address(used_tab, **{name: typed_in(stiffness)}), used_tab)
    rest(used_tab)
    again = dict(
        zip(
            shown.locator("dt").all_inner_texts(),
            shown.locator("dd").all_inner_texts(),
            strict=True,
        )
    )
    assert again["kt"] == stiffness


@pytest.mark.verify
@pytest.mark.parametrize(("answer", "value"), [("1000", 1000.0), ("1.000", 1.0)])
def test_a_comma_that_may_part_thousands_is_asked_about_by_keyboard(
    used_tab: Page, server: str, answer: str, value: float
):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    field = used_tab.get_by_test_id("kappa-field")
    problem = used_tab.get_by_test_id("kappa-problem")
    field.fill("")
    # as it is typed: "1,00" is a number on the way there
    field.press_sequentially("1,000")
    expect(problem).to_contain_text("1,000: which is meant?")
    assert problem.get_attribute("role") == "alert"
    settle(used_tab, server)
    assert collision_of(used_tab)["kappa"] == 20.0
    used_tab.keyboard.press("Tab")
    while text_of_focus(used_tab) != answer:
        used_tab.keyboard.press("Tab")
    # by then the field was left, and asks still
    assert field.input_value() == "1,000"
    used_tab.keyboard.press("Enter")
    settle(used_tab, server)
    assert collision_of(used_tab)["kappa"] == value
    expect(problem).to_be_empty()
    expect(field).to_be_focused()


def text_of_focus(page: Page) -> str:
    return page.evaluate("() => document.activeElement.textContent")


@pytest.mark.verify
def test_a_question_goes_when_it_is_not_wanted(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20")
    field = used_tab.get_by_test_id("kappa-field")
    problem = used_tab.get_by_test_id("kappa-problem")
    field.fill("1,000")
    expect(problem.get_by_role("button")).to_have_count(2)
    field.press("Escape")
    expect(problem).to_be_empty()
    assert field.input_value() == "20"
    field.fill("1,000")
    expect(problem.get_by_role("button")).to_have_count(2)
    # another parameter leaves it, the same one otherwise set answers it
    used_tab.get_by_test_id("gt-over-gn-slider").press("ArrowRight")
    settle(used_tab, server)
    expect(problem.get_by_role("button")).to_have_count(2)
    used_tab.get_by_test_id("kappa-slider").press("ArrowRight")
    settle(used_tab, server)
    expect(problem).to_be_empty()
    assert float(field.input_value()) == collision_of(used_tab)["kappa"]


def test_in_german_the_fields_show_and_take_decimal_commas(used_tab: Page, server: str):
    visit(used_tab, "/?scene=lesson&lang=de&step=1&gt_over_gn=1.358")
    settle(used_tab, server)
    field = used_tab.get_by_test_id("gt-over-gn-field")
    expect(field).to_have_value("1,358")
    field.fill("1,359")
    field.press("Enter")
    settle(used_tab, server)
    assert collision_of(used_tab)["gt_over_gn"] == 1.359
    field.fill("1.000")
    buttons = used_tab.get_by_test_id("gt-over-gn-problem").get_by_role("button")
    expect(buttons).to_have_text(["1000", "1,000"])
    buttons.nth(1).click()
    settle(used_tab, server)
    assert collision_of(used_tab)["gt_over_gn"] == 1.0
    visit(used_tab, "/?gt_over_gn=1.358")
    expect(field).to_have_value("1.358")


@pytest.mark.verify
def test_an_address_with_a_decimal_comma_says_what_it_takes(page: Page):
    page.goto("/?kappa=0,5")
    expect(page.get_by_test_id("notice")).to_contain_text(
        "κ must be a number greater than 0, with a decimal point, not “0,5”"
    )
    assert text(page, "kappa-problem") == ""


@pytest.mark.parametrize("width", every_day([320], of=[320, 390, 820, 1280, 1440, 1920]))
def test_what_is_asked_and_refused_keeps_apart_and_is_accessible(used_tab: Page, width: int):
    used_tab.set_viewport_size({"width": width, "height": 900})
    visit(used_tab, "/?scene=spheres&material=glass-on-glass")
    for name, written, said in [
        ("radius-m", "380 GPa", "GPa is a pressure"),
        ("tangential-stiffness-n-per-m", "1,358e9", "which is meant?"),
    ]:
        used_tab.get_by_test_id(f"{name}-field").fill(written)
        used_tab.get_by_test_id(f"{name}-field").press("Tab")
        expect(used_tab.get_by_test_id(f"{name}-problem")).to_contain_text(said)
    rest(used_tab)
    assert used_tab.evaluate(FAULTS) == []
    assert objections(used_tab) == []
    assert used_tab.evaluate("() => document.documentElement.scrollWidth") <= width


def test_without_what_reads_units_plain_numbers_count_and_the_rest_is_refused(
    page: Page, server: str
):
    page.route("**/written.js", lambda route: route.abort())
    page.goto("/?kappa=20")
    settle(page, server)
    field = page.get_by_test_id("kappa-field")
    field.fill("2/7")
    field.press("Enter")
    expect(page.get_by_test_id("kappa-problem")).to_have_text(
        "What reads “2/7” did not arrive; digits are taken"
    )
    field.fill("0,5")
    settle(page, server)
    assert collision_of(page)["kappa"] == 0.5
