"""The command line: serve the page, compile the kernels ahead of time, measure the methods."""

from pathlib import Path

import click
import uvicorn

from restitution.api.app import create_app
from restitution.api.page import compress_plotly
from restitution.api.warm import warm as warm_kernels
from restitution.api.warm import warm_table
from restitution.studies.report import tradeoff_report
from restitution.studies.scenes import SCENES
from restitution.studies.tradeoff import STORED, load_tradeoff, store_tradeoff, study_tradeoff


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


@main.command()
@click.option(
    "--scene", "scenes", type=click.Choice(list(SCENES)), multiple=True, help="All by default."
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    default=STORED,
    help="JSON to renew; that of the package by default.",
)
@click.option(
    "--report",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Markdown to write about all that it holds then.",
)
def tradeoff(scenes: tuple[str, ...], out: Path, report: Path | None) -> None:
    """Measure cost and error of every method on the collisions of a scene."""
    for scene in scenes or SCENES:
        with click.progressbar(length=1000, label=f"{scene:10}") as bar:
            for progress, measurement in study_tradeoff(scene):
                bar.update(round(1000 * progress) - bar.pos)
                finished = measurement
        store_tradeoff(finished, out)
    if report:
        report.write_text(tradeoff_report(load_tradeoff(out)))
