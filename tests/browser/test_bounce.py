"""The bounce: its numbers are those of real bodies, its picture follows the hand."""

import json
import math
import random
import re

import pytest
from explorer import Witness, ask, number, post, settle, texts, visit
from lesson import LANGUAGES, LOCALES
from playwright.sync_api import Page, Route, expect
from rest import eventually, rest

pytestmark = pytest.mark.browser

NUMBERS = ("angle", "speed", "spin")
BALL = {"radius_m": 0.02, "youngs_modulus_pa": 5e6, "poisson_ratio": 0.45, "mass_kg": 0.04}
WALL = {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25}


def shown(page: Page, i: int) -> dict[str, float]:
    """The numbers of the i-th motion above the picture."""
    found = texts(page, *(f"bounce-{name}-{i}" for name in NUMBERS))
    return {name: number(found[f"bounce-{name}-{i}"].removesuffix("°")) for name in NUMBERS}


def values(motion: dict[str, float]) -> dict[str, float]:
    """What is shown of a motion, exactly."""
    speed = math.hypot(motion["normal_velocity"], motion["centre_velocity"])
    return dict(zip(NUMBERS, (motion["angle_deg"], speed, motion["spin_velocity"]), strict=True))


def shows(page: Page, i: int, motion: dict[str, float]) -> None:
    found, exact = shown(page, i), values(motion)
    for name in NUMBERS:
        assert within_its_digits(found[name], exact[name]), (i, name, found[name], exact[name])


def random_body(chance: random.Random) -> tuple[dict, str, float]:
    """A body of `/scaling`, what its ball bounces off, and the share of spin."""
    partner = chance.choice(["wall", "sphere"])
    share = chance.choice([0.0, 1.0, chance.random()])
    speed, ratio = chance.uniform(0.1, 5.0), 10 ** chance.uniform(-2, 0.7)
    mass_share = 1.0 if partner == "wall" else 0.5
    centre = (1 - share) * ratio * speed * mass_share
    turn = -share * ratio * speed * mass_share / BALL["radius_m"]
    ball = BALL | {"inertia": chance.choice(["solid", "hollow"])}
    velocity = [centre, 0.0, -mass_share * speed]
    impact = {
        "velocity_1_m_s": velocity,
        "velocity_2_m_s": [0, 0, 0] if partner == "wall" else [-centre, 0.0, mass_share * speed],
        "spin_1_rad_s": [0.0, turn, 0.0],
        "spin_2_rad_s": [0, 0, 0] if partner == "wall" else [0.0, turn, 0.0],
        "normal": [0, 0, 1],
    }
    body = {
        "body_1": ball,
        "body_2": WALL if partner == "wall" else ball,
        "friction_coefficient": chance.uniform(0.05, 0.8),
        "tangential_stiffness_n_per_m": "mindlin",
        "dissipative_constant_s": chance.choice([0, 2e-5]),
        "impact": impact,
    }
    return body, partner, share


def motion_of(velocity: list[float], turn: float, speed: float) -> dict[str, float]:
    along, away = velocity[0] / speed, velocity[2] / speed
    return {
        "normal_velocity": away,
        "centre_velocity": along,
        "spin_velocity": BALL["radius_m"] * turn / speed,
        "angle_deg": math.degrees(math.atan2(along, abs(away))),
    }


def within_its_digits(found: float, exact: float) -> bool:
    """Whether a number with four digits is the exact one, rounded."""
    last = 10.0 ** (math.floor(math.log10(abs(exact))) - 3) if exact else 0.0
    # what a ball that comes without spin has for rounding is shown as 0
    return abs(found - exact) <= 0.5 * last + 1e-9


@pytest.mark.parametrize("states", [3, pytest.param(200, marks=pytest.mark.verify)])
def test_angles_and_spins_are_those_of_real_bodies(used_tab: Page, server: str, states: int):
    chance = random.Random(17)
    for _ in range(states):
        body, partner, share = random_body(chance)
        answer = post(server, "scaling", body)
        names = ("kappa", "mu_over_alpha", "gt_over_gn", "damping", "alpha")
        query = "&".join(f"{name}={answer[name]!r}" for name in names)
        visit(used_tab, f"/?{query}&bounce={partner}&spin_share={share!r}")
        settle(used_tab, server)
        speed, impact = answer["normal_velocity_m_s"], body["impact"]
        before = motion_of(impact["velocity_1_m_s"], impact["spin_1_rad_s"][1], speed)
        after = motion_of(
            answer["after"]["velocity_1_m_s"], answer["after"]["spin_1_rad_s"][1], speed
        )

        for i, motion in enumerate((before, after)):
            eventually(lambda i=i, motion=motion: shows(used_tab, i, motion), used_tab)


def at(page: Page, share: float) -> None:
    """Put the clock where one wants it."""
    page.get_by_test_id("bounce-time").fill(str(round(1000 * share)))


def test_second_bounce_is_the_service_s_and_has_its_contact(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=4.5&mu_over_alpha=1.4&gt_over_gn=1.1&damping=0.1&bounce=wall_twice")
    settle(used_tab, server)
    parameters = {"kappa": 4.5, "mu_over_alpha": 1.4, "gt_over_gn": 1.1, "damping": 0.1}
    answer = ask(server, "bounce", **parameters)
    for i, motion in enumerate(answer["motions"]):
        eventually(lambda i=i, motion=motion: shows(used_tab, i, motion), used_tab)
    switches = used_tab.locator(".bounce-ribbon span")
    second = {n: answer["second"][n] for n in parameters}
    both = [ask(server, "collision", **each)["switches"] for each in (parameters, second)]
    expect(switches).to_have_count(sum(both))
    at(used_tab, 0.74)
    expect(used_tab.get_by_test_id("bounce-time")).to_have_attribute(
        "aria-valuetext", re.compile("^in contact")
    )


@pytest.mark.own_page
def test_the_way_out_follows_the_hand_while_the_server_is_silent(page: Page, server: str):
    page.goto("/?kappa=20&mu_over_alpha=1.4&gt_over_gn=1")
    settle(page, server)
    rest(page)
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    page.route(re.compile(r"/api/v1/(trace|collision|bounce)"), hold)
    before = page.locator(".bounce .flight-path").last.get_attribute("d")
    page.get_by_test_id("gt-over-gn-slider").fill("300")
    moved = page.locator(".bounce .flight-path").last
    expect(moved).not_to_have_attribute("d", before or "")
    query = {"kappa": 20, "mu_over_alpha": 1.4, "gt_over_gn": 0.36}
    expected = ask(server, "bounce", **query)["motions"]
    # ε_t read off the map is within some hundredths, the way in is exact
    eventually(lambda: shows(page, 0, expected[0]), page)
    assert shown(page, 1)["angle"] == pytest.approx(expected[1]["angle_deg"], abs=1.5)
    for route in held:
        route.continue_()
    page.unroute_all()
    settle(page, server)
    eventually(lambda: shows(page, 1, expected[1]), page)


def test_nothing_is_asked_for_while_the_body_stays(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20&gt_over_gn=1")
    settle(used_tab, server)
    rest(used_tab)
    witness = Witness(used_tab, server)
    used_tab.get_by_test_id("kappa-slider").press("ArrowRight")
    used_tab.get_by_test_id("spin-share").fill("0.3")
    settle(used_tab, server)
    rest(used_tab)
    assert witness.last("trace") is not None
    assert witness.last("bounce") is None
    used_tab.locator("[name='bounce'][value='sphere']").check()
    rest(used_tab)
    asked = witness.last("bounce")
    assert asked is not None
    assert (asked["partner"], asked["spin_share"]) == ("sphere", "0.3")
    assert "bounce=sphere" in used_tab.url
    assert "spin_share=0.3" in used_tab.url


def test_picture_says_in_words_how_the_ball_comes_and_leaves(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=4.5&mu_over_alpha=1.4&gt_over_gn=1.4")
    settle(used_tab, server)
    picture = used_tab.get_by_test_id("bounce")
    expect(picture).to_have_attribute(
        "aria-label",
        re.compile(
            r"^A ball comes in at 54° without spin, leaves at 4\d° turning forward\. Slides"
        ),
    )
    used_tab.locator("[name='spin_share'][value='1']").check()
    expect(picture).to_have_attribute(
        "aria-label", re.compile("comes in at 0° turning backward, goes back at")
    )


@pytest.mark.verify
def test_three_stills_where_nothing_is_to_move_and_one_view_for_a_hand(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=4.5&gt_over_gn=1.1")
    settle(used_tab, server)
    views = used_tab.locator(".bounce-view")
    at(used_tab, 1)
    expect(views).to_have_count(3)
    at(used_tab, 0.5)
    expect(views).to_have_count(1)
    # the traces show the same instant
    cursor = used_tab.locator(".velocity .time-cursor")
    expect(cursor).to_have_attribute("data-on", "")
    at(used_tab, 0.1)
    expect(cursor).not_to_have_attribute("data-on", "")
    at(used_tab, 1)
    expect(views).to_have_count(3)


# Whether, in each contact that is to be seen, its word is in its chip and apart from what is drawn.
WORDS_APART = """() => [...document.querySelectorAll(".bounce-view .contact:not([hidden])")].map(
  (contact) => {
    const [chip, word, drawn] = ["chip", "word", "enlarged"].map((name) =>
      contact.querySelector(`.contact-${name}`).getBoundingClientRect());
    const isIn = chip.left <= word.left && word.right <= chip.right;
    const isApart = drawn.width === 0 || chip.right < drawn.left || drawn.bottom < chip.top;
    return `${contact.textContent.trim()}: ${isIn && isApart}`;
  })"""


@pytest.mark.verify
@pytest.mark.parametrize("language", LANGUAGES)
def test_the_words_in_the_contact_have_room_on_a_phone(used_tab: Page, server: str, language: str):
    used_tab.set_viewport_size({"width": 390, "height": 844})
    found: list[str] = []
    for gt in (1.1, 4):
        visit(used_tab, f"/?lang={language}&kappa=4.5&gt_over_gn={gt}")
        settle(used_tab, server)
        for share in (1, 0.4, 0.5, 0.6, 0.7):
            at(used_tab, share)
            found += used_tab.evaluate(WORDS_APART)
    back = json.loads((LOCALES / f"{language}.json").read_text("utf-8"))["bounce"]["slidesBack"]
    assert any(back in words for words in found)
    assert [words for words in found if not words.endswith("true")] == []


@pytest.mark.own_page
def test_it_plays_by_itself_until_it_is_stopped(page: Page):
    page.emulate_media(reduced_motion="no-preference")
    page.goto("/?kappa=4.5&gt_over_gn=1.1")
    play = page.get_by_test_id("bounce-play")
    expect(play).to_have_attribute("data-playing", "")
    play.click()
    expect(play).not_to_have_attribute("data-playing", "")


@pytest.mark.verify
@pytest.mark.own_page
def test_it_plays_once_by_itself_and_ends_with_the_whole_way(page: Page):
    page.emulate_media(reduced_motion="no-preference")
    page.goto("/?kappa=4.5&gt_over_gn=1.1")
    play = page.get_by_test_id("bounce-play")
    expect(play).to_have_attribute("data-playing", "")
    expect(play).not_to_have_attribute("data-playing", "")
    expect(page.get_by_test_id("bounce-time")).to_have_value("1000")
    expect(page.locator(".bounce-view")).to_have_count(1)


@pytest.mark.verify
def test_an_address_with_another_ball_is_told(used_tab: Page, server: str):
    visit(used_tab, "/?bounce=floor&spin_share=2")
    settle(used_tab, server)
    expect(used_tab.get_by_test_id("notice")).to_contain_text("bounce must be wall")
    expect(used_tab.get_by_test_id("notice")).to_contain_text(
        "spin_share must be a number from 0 to 1"
    )
