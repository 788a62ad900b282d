"""Other words for a page than its server gives it, those of the page and those that come later."""

import json
import re
from collections.abc import Callable

from playwright.sync_api import Page, Route


def changed(texts: dict, change: Callable[[str], str]) -> dict:
    return {
        key: changed(value, change) if isinstance(value, dict) else change(value)
        for key, value in texts.items()
    }


def change_words(page: Page, change: Callable[[dict], dict]) -> None:
    """Let texts, by their sections, reach a page as `change` makes them."""

    def answer_page(route: Route) -> None:
        response = route.fetch()
        words = re.compile(r'(<script type="application/json" id="words">)(.*?)(</script>)')
        [(_, given, _)] = words.findall(response.text())
        found = json.loads(given)
        told = json.dumps(found | {"texts": change(found["texts"])}).replace("<", "\\u003c")
        body = words.sub(lambda match: match[1] + told + match[3], response.text())
        route.fulfill(response=response, body=body)

    def answer_later(route: Route) -> None:
        response = route.fetch()
        route.fulfill(response=response, json=change(response.json()))

    page.route(re.compile(r"/\?"), answer_page)
    page.route("**/words/*", answer_later)
