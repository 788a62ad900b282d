"""Write pictures of every scene, in every size and both themes, from a server of its own.

`python tests/browser/screenshots.py [FOLDER]`; the folder is screenshots/ unless one is named.
"""

import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from explorer import settle
from playwright.sync_api import Browser, sync_playwright
from rest import count_pending, rest
from set_up_browser import ARGUMENTS, chromium_of_machine

from servers import serving

# A projector of 3840 pixels is looked at from afar: its pixels are counted one by one all the same.
SIZES = {"phone": (390, 844), "desk": (1440, 900), "4k": (3840, 2160)}
THEMES = ("light", "dark")
SCENES = {
    "explorer": "",
    "explorer-figure-5-a": "kappa=63&mu_over_alpha=1.4&gt_over_gn=3.08",
    "explorer-compared": "kappa=30&gt_over_gn=1.2&pins=63,1.4,1.358;4.5,1.4,4;18,0.8,0.9,0.3",
    "explorer-stiff-limit": "kappa=2000&mu_over_alpha=1.4&gt_over_gn=1",
    "explorer-superball": "kappa=0.953&mu_over_alpha=1000&gt_over_gn=1"
    "&spin_share=0.714&bounce=wall_twice",
    "spheres": "scene=spheres",
    "spheres-measured": "scene=spheres&material=alumina-on-glass",
    "lesson": "scene=lesson&step=2&lang=en",
    "lesson-german-notes": "scene=lesson&step=7&lang=de&notes=shown",
    "accuracy": "scene=accuracy",
    "paper": "scene=paper",
    "accuracy-forward-euler": "scene=accuracy&method=timestep&steps=100&integrator=forward_euler",
    "explorer-switches-log": "kappa=100&mu_over_alpha=1&gt_over_gn=0.3&map=switches&scale=log",
}


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "screenshots")
    folder.mkdir(parents=True, exist_ok=True)
    with (
        TemporaryDirectory() as log,
        serving(Path(log)) as server,
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=chromium_of_machine(), args=ARGUMENTS)
        for path in take_all(browser, server.url, folder):
            print(path)
        browser.close()


def take_all(browser: Browser, server: str, folder: Path) -> Iterator[Path]:
    for size, (width, height) in SIZES.items():
        for theme in THEMES:
            context = browser.new_context(
                viewport={"width": width, "height": height},
                color_scheme=theme,
                # what moves is shown at rest
                reduced_motion="reduce",
            )
            count_pending(context)
            page = context.new_page()
            for scene, query in SCENES.items():
                page.goto(f"{server}/?{query}")
                settle(page, server)
                # the map and what else comes after the trace
                rest(page)
                path = folder / f"{scene}-{size}-{theme}.png"
                page.screenshot(path=path)
                yield path
                if size == "phone":
                    whole = folder / f"{scene}-{size}-{theme}-whole.png"
                    page.screenshot(path=whole, full_page=True)
                    yield whole
            context.close()


if __name__ == "__main__":
    main()
