"""Frames of other pages: panels and sliders that their author chose, and what writes them."""

import html
import re
from pathlib import Path

import pytest
from another_host import another_host
from explorer import Witness, trace_of, visit
from playwright.sync_api import Frame, Page, expect
from rest import eventually, rest
from test_access import objections

pytestmark = pytest.mark.browser


def framed(page: Page, host: str, folder: Path, *addresses: str) -> list[Frame]:
    """Show addresses in sandboxed frames of somebody's page, and wait until they rest."""
    frames = "".join(
        f'<iframe sandbox="allow-scripts" width="720" height="500" src="{html.escape(address)}">'
        "</iframe>"
        for address in addresses
    )
    (folder / "index.html").write_text(f"<!doctype html>{frames}")
    page.goto(host)
    found = [frame for frame in page.frames if frame.parent_frame]
    for frame in found:
        frame.get_by_test_id("embed-caption").get_by_text("=").wait_for()
        rest(frame)
    return found


def caption(frame: Frame) -> str:
    return frame.get_by_test_id("embed-caption").inner_text()


def drag_over_map(page: Page, frame: Frame) -> None:
    box = frame.locator(".map-panel .plot-stage").bounding_box()
    assert box
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    page.mouse.down()
    page.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + 0.3 * box["height"], steps=3)
    page.mouse.up()
    rest(frame)


def test_what_a_frame_offers_moves_all_of_its_panels_and_the_rest_is_locked(
    stranger: Page, server: str, tmp_path: Path
):
    witness = Witness(stranger, server)
    address = f"{server}/?embed=force,map&sliders=kappa&kappa=20"
    with another_host(tmp_path) as host:
        (frame,) = framed(stranger, host, tmp_path, address)
        steps = stranger.evaluate("() => history.length")
        for name in ("force", "map"):
            assert frame.locator(f"[data-panel={name}]").is_visible()
        assert frame.locator(".parameter:visible").count() == 1
        before = trace_of(frame, "force-trace")
        place = frame.locator(".crosshair-ring").first.bounding_box()

        frame.get_by_test_id("kappa-slider").press("PageUp")
        rest(frame)
        kappa = frame.get_by_test_id("kappa-field").input_value()
        assert kappa != "20"
        assert caption(frame).startswith(f"κ = {kappa}, μ/α = 1.4, gt/gn = 1.358:")
        assert trace_of(frame, "force-trace") != before
        assert frame.locator(".crosshair-ring").first.bounding_box() != place

        drag_over_map(stranger, frame)
        assert not caption(frame).startswith(f"κ = {kappa},")
        assert ", μ/α = 1.4, gt/gn = 1.358:" in caption(frame)
        # back to where its author had it begin
        frame.get_by_test_id("kappa-field").fill("20")
        rest(frame)
        assert trace_of(frame, "force-trace") == before
        # the browser's Back is the stranger's around it
        assert stranger.evaluate("() => history.length") == steps
    assert witness.words == []


@pytest.mark.verify
def test_two_frames_on_a_page_leave_each_other_alone_and_a_still_one_stays(
    stranger: Page, server: str, tmp_path: Path
):
    witness = Witness(stranger, server)
    with another_host(tmp_path) as host:
        moved, still = framed(
            stranger,
            host,
            tmp_path,
            f"{server}/?embed=map&kappa=20&theme=dark",
            f"{server}/?embed=map&sliders=none&kappa=30&lang=de",
        )
        before = caption(still)
        drag_over_map(stranger, still)
        # what nobody locked is moved on the map, as ever
        drag_over_map(stranger, moved)
        assert not caption(moved).startswith("κ = 20,")
        assert caption(still) == before
        crosshair = still.get_by_test_id("crosshair")
        assert crosshair.evaluate("(e) => e.inert")
        assert [frame.locator("html").get_attribute("lang") for frame in (moved, still)] == [
            "en",
            "de",
        ]
    assert witness.words == []


@pytest.mark.verify
def test_sliders_of_real_spheres_stand_in_their_order_and_nothing_else_does(
    stranger: Page, server: str, tmp_path: Path
):
    names = ["normal_restitution", "tangential_velocity_m_s"]
    address = f"{server}/?embed=velocities,impact&sliders={','.join(names)}&material=steel"
    with another_host(tmp_path) as host:
        (frame,) = framed(stranger, host, tmp_path, f"{address}&normal_restitution=0.8")
        shown = frame.locator(".parameter:visible")
        hooks = [name.replace("_", "-") for name in names]
        assert shown.evaluate_all("(all) => all.map((e) => e.dataset.parameter)") == hooks
        assert not frame.get_by_test_id("material").is_visible()
        frame.get_by_test_id("normal-restitution-field").fill("0.5")
        rest(frame)
        frame.get_by_test_id("velocity-crosshair").press("ArrowRight")
        rest(frame)
        assert frame.evaluate("() => location.search").count("normal_velocity_m_s") == 0
        assert "normal_restitution=0.5" in frame.evaluate("() => location.search")


def source_of(page: Page) -> str:
    return page.locator(".builder iframe").get_attribute("src") or ""


def frame_text(page: Page) -> str:
    return page.locator("[data-testid=embedding-frame] pre").inner_text()


def preview_of(page: Page) -> Frame:
    """The frame that is previewed, once it has told its size."""
    frame = page.locator(".builder iframe").element_handle().content_frame()
    assert frame
    frame.get_by_test_id("embed-caption").get_by_text("=").wait_for()
    rest(frame)
    rest(page)
    return frame


def test_the_builder_shows_what_it_writes(tab: Page):
    tab.set_viewport_size({"width": 1280, "height": 720})
    visit(tab, "/?kappa=20")
    rest(tab)
    tab.get_by_test_id("menu-map").click()
    tab.locator("#menu-map .to-embed").click()
    builder = tab.get_by_test_id("builder")
    for value in ("force", "gt_over_gn"):
        builder.locator(f"input[value={value}]").check()
    builder.get_by_label("Language").select_option("de")
    builder.get_by_label("Colours").select_option("dark")
    frame = preview_of(tab)
    source = source_of(tab)
    assert source.endswith("&theme=dark&lang=de&embed=force,map&sliders=gt_over_gn")
    assert "?kappa=20&" in source
    assert caption(frame).startswith("κ = 20,")
    height_field = builder.get_by_role("spinbutton", name="Height")
    height = height_field.input_value()
    # so high that nothing scrolls in it
    assert frame.evaluate("() => document.documentElement.scrollHeight") == int(height)
    assert frame_text(tab) == (
        f'<iframe src="{html.escape(source)}" title="Restitution · Kraft, Karte" width="720" '
        f'height="{height}" style="border: 0; max-width: 100%" loading="lazy"></iframe>'
    )
    tab.evaluate("() => document.addEventListener('copy', () => { window.copied = true; })")
    builder.get_by_role("button", name="Copy Frame").click()
    expect(builder.get_by_role("button", name="Frame (HTML) is copied")).to_be_visible()
    # a height of one's own stays, until that which fits is wanted again
    height_field.fill("600")
    builder.locator("input[value=map]").uncheck()
    preview_of(tab)
    assert 'height="600"' in frame_text(tab)
    builder.get_by_role("button", name="The height that fits").click()
    assert 'height="600"' not in frame_text(tab)
    builder.locator("input[value=force]").uncheck()
    expect(builder.get_by_role("alert")).to_have_text("Choose one picture at least.")
    tab.keyboard.press("Escape")
    expect(builder).to_be_hidden()
    expect(tab.get_by_test_id("menu-map")).to_be_focused()
    # taken away on the event of closing, which comes after the dialog is hidden
    expect(tab.locator(".builder iframe")).to_have_count(0)


@pytest.mark.verify
@pytest.mark.parametrize(
    ("width", "scheme"),
    [(390, "dark"), (1280, "light"), (1440, "dark")],
)
def test_axe_finds_nothing_to_object_to_in_the_builder_nor_in_what_it_shows(
    tab: Page, width: int, scheme: str
):
    tab.set_viewport_size({"width": width, "height": 844})
    tab.emulate_media(color_scheme=scheme)
    tab.get_by_test_id("menu-contact").click()
    tab.locator("#menu-contact .to-embed").click()
    for value in ("result", "kappa", "spin_share"):
        tab.locator(f".builder input[value={value}]").check()
    frame = preview_of(tab)
    assert tab.evaluate("() => document.documentElement.scrollWidth") <= width
    assert objections(tab) == []
    assert frame.locator(".spin-share").is_visible()
    assert objections(frame) == []


@pytest.mark.verify
@pytest.mark.parametrize("width", [320, 600, 960])
@pytest.mark.parametrize("panels", ["contact", "result,force,map,cut", "map,velocity"])
def test_what_fits_has_nothing_to_scroll(tab: Page, width: int, panels: str):
    tab.set_viewport_size({"width": 1440, "height": 900})
    tab.get_by_test_id("embed").click()
    builder = tab.get_by_test_id("builder")
    for box in builder.locator("fieldset").first.locator("input").all():
        box.set_checked(box.input_value() in panels.split(","))
    for value in ("kappa", "mu_over_alpha", "damping"):
        builder.locator(f"input[value={value}]").check()
    # the language with the longest words
    builder.get_by_label("Language").select_option("fr")
    builder.get_by_label("Width").fill(str(width))
    builder.get_by_label("Width").press("Tab")
    frame = preview_of(tab)

    def assert_fits() -> None:
        sizes = frame.evaluate(
            "() => [document.documentElement.scrollHeight, innerHeight, innerWidth]"
        )
        assert sizes[0] == sizes[1]
        assert sizes[2] == width
        assert re.search(rf'width="{width}" height="{sizes[1]}"', frame_text(tab))

    eventually(assert_fits, tab)
