"""When a page has done all that it had planned: nothing is under way, nothing is to come."""

from collections.abc import Callable
from typing import TypeVar

from playwright.sync_api import BrowserContext, Error, Frame, Page

import waiting

T = TypeVar("T")

# Runs before the page's own scripts: counts requests whose answers are not read yet, timers, and
# frames asked for; looks for transitions.
COUNT_PENDING = """(() => {
  const direct = {
    fetch: window.fetch,
    setTimeout: window.setTimeout,
    clearTimeout: window.clearTimeout,
    requestAnimationFrame: window.requestAnimationFrame,
    cancelAnimationFrame: window.cancelAnimationFrame,
  };
  let underWay = 0;
  const track = (promise) => {
    underWay += 1;
    return promise.finally(() => { underWay -= 1; });
  };
  window.fetch = async (...request) => {
    const response = await track(direct.fetch.apply(window, request));
    for (const name of ["arrayBuffer", "blob", "json", "text"]) {
      const read = response[name].bind(response);
      response[name] = () => track(read());
    }
    return response;
  };
  const sets = [];
  const count = (begin, end) => {
    const pending = new Set();
    sets.push(pending);
    window[begin] = (task, ...rest) => {
      const id = direct[begin].call(window, (...given) => {
        pending.delete(id);
        return typeof task === "function" ? task(...given) : undefined;
      }, ...rest);
      pending.add(id);
      return id;
    };
    window[end] = (id) => {
      pending.delete(id);
      direct[end].call(window, id);
    };
  };
  count("setTimeout", "clearTimeout");
  count("requestAnimationFrame", "cancelAnimationFrame");
  // A change of colours runs on, from element to element that inherits it.
  const isChanging = () => document.getAnimations().some((one) => one instanceof CSSTransition);
  // A scene that is not in the first view comes as modules and style sheets.
  const isComing = () =>
    document.documentElement.getAttributeNames().some((name) => name.endsWith("-coming"));
  const isResting = () =>
    underWay === 0
    && sets.every((pending) => pending.size === 0)
    && !isChanging()
    && !isComing();
  const frame = () => new Promise((resolve) => {
    direct.requestAnimationFrame.call(window, () => direct.setTimeout.call(window, resolve));
  });
  // What a frame leaves behind, a message or a change of size, shows in the next. A page at work is
  // looked at for some seconds, in one question to the browser.
  window.comesToRest = async () => {
    let still = 0;
    for (let i = 0; i < 200 && still < 4; i += 1) {
      still = document.readyState === "complete" && isResting() ? still + 1 : 0;
      await frame();
    }
    return still === 4;
  };
})();"""

# Runs before the page's own scripts, whose policy does not concern it.
WATCH_SHIFTS = """
window.shifts = [];
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) {
    if (!entry.hadRecentInput) window.shifts.push(entry.value);
  }
}).observe({type: "layout-shift", buffered: true});
"""

LARGEST_LAYOUT_SHIFT = 0.015


def layout_shift(page: Page) -> float:
    """Return how much has moved without an input, where `WATCH_SHIFTS` runs."""
    return sum(page.evaluate("() => window.shifts"))


def count_pending(context: BrowserContext) -> None:
    """Let `rest` know what the pages of a context have before them; their time-outs are minutes."""
    context.set_default_timeout(1000 * waiting.LIMIT_SECONDS)
    context.add_init_script(COUNT_PENDING)


def rest(page: Page | Frame) -> None:
    """Wait until a page has no request, timer or frame before it: what it does, it has done."""

    def rests() -> None:
        assert page.evaluate("() => comesToRest()"), f"{page.url} does not come to rest"

    eventually(rests, page)


def eventually(check: Callable[[], T], page: Page | Frame) -> T:
    """Return what a check returns once it holds; meanwhile the page goes on."""

    def check_document() -> T:
        try:
            return check()
        except Error as error:
            if "Execution context was destroyed" not in error.message:
                raise
            raise AssertionError("another document has come") from error

    return waiting.eventually(check_document, lambda seconds: page.wait_for_timeout(1000 * seconds))
