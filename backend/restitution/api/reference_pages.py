"""Swagger UI at /docs, ReDoc at /redoc, from files of a package: nothing comes from elsewhere."""

import base64
import functools
import hashlib
import re
from importlib.resources import files
from pathlib import Path

from fastapi import FastAPI, Response
from fastapi.openapi.docs import get_redoc_html, get_swagger_ui_html
from fastapi.responses import HTMLResponse
from starlette.staticfiles import StaticFiles

ASSETS = Path(str(files("fastapi_offline").joinpath("static")))
ASSETS_ADDRESS = "/assets/reference"

LOGO = b"https://cdn.redoc.ly/redoc/logo-mini.svg"
"""The only thing that ReDoc asks of a stranger, at the foot of its menu."""

NO_PICTURE = b"data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA="

CACHED = {"Cache-Control": "public, max-age=86400"}


def add_reference_pages(app: FastAPI) -> None:
    """Let `app` show its description for people, at ``/docs`` and ``/redoc``."""
    # relative, for the pages may stand below any path of a proxy
    assets = ASSETS_ADDRESS.removeprefix("/")
    description, icon = "openapi.json", f"{assets}/favicon.png"
    swagger = _page(
        get_swagger_ui_html(
            openapi_url=description,
            title=f"{app.title}: calls to try",
            swagger_js_url=f"{assets}/swagger-ui-bundle.js",
            swagger_css_url=f"{assets}/swagger-ui.css",
            swagger_favicon_url=icon,
            # without it, anywhere but on one's own machine, a validator elsewhere is asked
            swagger_ui_parameters={"validatorUrl": None},
        )
    )
    redoc = _page(
        get_redoc_html(
            openapi_url=description,
            title=f"{app.title}: calls to read",
            redoc_js_url=f"{assets}/redoc.standalone.js",
            redoc_favicon_url=icon,
            with_google_fonts=False,
        ),
        # its search runs in a worker that it makes itself
        "worker-src blob:; ",
    )

    @app.get("/docs", include_in_schema=False)
    def docs() -> Response:
        return swagger

    @app.get("/redoc", include_in_schema=False)
    def redoc_page() -> Response:
        return redoc

    @app.get(f"{ASSETS_ADDRESS}/redoc.standalone.js", include_in_schema=False)
    def redoc_script() -> Response:
        return Response(_redoc_without_logo(), headers=CACHED, media_type="text/javascript")

    app.mount(ASSETS_ADDRESS, StaticFiles(directory=ASSETS), "reference")


def _page(made: HTMLResponse, more: str = "") -> HTMLResponse:
    html = bytes(made.body)
    rules = policy(html, f"{more}form-action 'none'; frame-ancestors 'self'")
    return HTMLResponse(html, headers={"Content-Security-Policy": rules, **CACHED})


def policy(html: bytes, more: str) -> str:
    """Return a policy for a page that allows its own inline scripts and no other."""
    inline = re.findall(rb"<script>(.*?)</script>", html, re.DOTALL)
    hashes = [base64.b64encode(hashlib.sha256(script).digest()).decode() for script in inline]
    scripts = " ".join(["'self'", *(f"'sha256-{digest}'" for digest in hashes)])
    return (
        f"default-src 'none'; script-src {scripts}; style-src 'self' 'unsafe-inline'; "
        f"img-src 'self' data:; connect-src 'self'; base-uri 'none'; {more}"
    )


@functools.cache
def _redoc_without_logo() -> bytes:
    return (ASSETS / "redoc.standalone.js").read_bytes().replace(LOGO, NO_PICTURE)
