"""The guide at /guide: the site that `make docs` makes of docs/, or a page that says so."""

import functools
import os
from collections.abc import Sequence
from pathlib import Path

from fastapi import FastAPI, Response
from fastapi.responses import HTMLResponse, RedirectResponse
from starlette.datastructures import Headers
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

from restitution.api.problems import problem
from restitution.api.reference_pages import policy
from restitution.api.transport import known_tag

PLACES = Path(__file__).parents[1] / "guide", Path(__file__).parents[3] / "build" / "guide"
"""Where it is: in an installed package, else in the checkout."""

ALLOWED = "font-src 'self'; form-action 'self'"
"""Beyond what all such pages need: the page's fonts, and a form to search with.

As the page it may be shown in anybody's frame.
"""

ABSENT = "there is no guide here: `make docs` in the checkout makes it"

ABSENT_PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8" />
<meta name="viewport" content="width=device-width, initial-scale=1" />
<meta name="color-scheme" content="light dark" />
<title>No guide yet</title>
<style>
  body { max-width: 30em; margin: 20vh auto; padding: 0 1.5em; font: 1em/1.6 sans-serif; }
  a { color: inherit; }
</style>
<h1>No guide yet</h1>
<p><code>make docs</code> in the checkout makes it; then reload this page.</p>
<p>Until then its texts can be read in the folder <code>docs</code>.
<a href="../">To the explorer</a></p>
</html>
"""


def add_guide(app: FastAPI, places: Sequence[Path] = PLACES) -> None:
    """Let `app` show the guide, from the first of `places` that there is when it is asked for."""

    @app.get("/guide", include_in_schema=False)
    def guide() -> Response:
        # relative, for it may stand below any path of a proxy
        return RedirectResponse("guide/")

    app.mount("/guide", _Guide(places), "guide")


class _Guide(StaticFiles):
    """Its files, each asked for anew, and answered 304 while it is the same."""

    def __init__(self, places: Sequence[Path]) -> None:
        super().__init__(check_dir=False)
        self._places = places
        self.all_directories = list(places)

    def get_path(self, scope: Scope) -> str:
        """Return the path of a file; the guide begins with its list of documents."""
        path = super().get_path(scope)
        return "index.html" if path == "." else path

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Return a file, or how to get the guide."""
        if any(map(Path.is_dir, self._places)):
            return await super().get_response(path, scope)
        if "text/html" in Headers(scope=scope).get("accept", ""):
            rules = {"Content-Security-Policy": policy(b"", ALLOWED), "Cache-Control": "no-store"}
            response: Response = HTMLResponse(ABSENT_PAGE, 404, rules)
        else:
            response = problem(404, ABSENT)
        response.headers["Vary"] = "Accept"
        return response

    def file_response(
        self,
        full_path: str | os.PathLike[str],
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """Return a file under a policy that allows what the generator put into it."""
        response = super().file_response(full_path, stat_result, scope, status_code)
        rules = _policy_of(str(full_path), stat_result.st_mtime_ns)
        response.headers["Content-Security-Policy"] = rules
        response.headers["Cache-Control"] = "no-cache"
        return response

    def is_not_modified(self, response_headers: Headers, request_headers: Headers) -> bool:
        """Return whether a client has a file already, compressed or not."""
        known = request_headers.get("if-none-match", "")
        return known_tag(response_headers["etag"], known) is not None


@functools.lru_cache(maxsize=256)
def _policy_of(path: str, _changed_at: int) -> str:
    """Return the policy of a file, for which it is read once while it is the same."""
    html = Path(path).read_bytes() if path.endswith(".html") else b""
    return policy(html, ALLOWED)
