"""The service with routes that return stored bytes: what serving costs without computing."""

from fastapi import FastAPI, Response
from starlette.testclient import TestClient

from restitution.api.app import create_app, create_service

COLLISION = "/api/v1/collision?kappa=18&mu_over_alpha=1.4&gt_over_gn=0.4"
TRACE = "/api/v1/trace?kappa=18&mu_over_alpha=1.4&gt_over_gn=0.4&encoding=base64"


def create() -> FastAPI:
    """Return the service with a stored twin of a collision and of a trace."""
    app = create_service()
    client = TestClient(create_app())
    for name, path in (("collision", COLLISION), ("trace", TRACE)):
        body = client.get(path).content

        async def stored(body: bytes = body) -> Response:
            return Response(body, media_type="application/json")

        app.add_api_route(f"/api/v1/stored/{name}", stored, response_model=None)
    return app
