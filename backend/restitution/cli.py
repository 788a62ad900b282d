"""The command line: serve the page, or compile the kernels ahead of time."""

import click
import uvicorn

from restitution.api.app import create_app
from restitution.api.page import compress_plotly
from restitution.api.warm import warm as warm_kernels
from restitution.api.warm import warm_table


@click.group()
def main() -> None:
    """Exact collisions of spinning, frictional spheres."""


@main.command()
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option("--port", default=8000, show_default=True, help="Port to listen on.")
def serve(host: str, port: int) -> None:
    """Serve the page and the API."""
    click.echo(f"serving http://{host}:{port}")
    uvicorn.run(create_app(), host=host, port=port, log_level="warning")


@main.command()
def warm() -> None:
    """Compile the kernels, compress plotly.js and build the table into the cache."""
    warm_kernels()
    compress_plotly()
    warm_table()
