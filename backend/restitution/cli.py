"""The command line: the service, one impact of real spheres, tables for other codes."""

import contextlib
import json
import math
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, get_args

import click
from click.core import ParameterSource

from restitution import __version__
from restitution.api.one_file import NAME, one_file
from restitution.api.page import compress_page
from restitution.api.serving import (
    address_of,
    listeners,
    serve_alone,
    serve_in_workers,
    unix_listener,
)
from restitution.api.settings import (
    PREFIX,
    Settings,
    SettingsError,
    settings_of_environment,
    strangers,
)
from restitution.api.warm import warm as warm_kernels
from restitution.api.warm import warm_rest
from restitution.bounds import annotations
from restitution.commands.collide import collide
from restitution.commands.terminal import Program, say_json
from restitution.studies.accuracy.report import tradeoff_report
from restitution.studies.accuracy.scenes import SCENES, SceneName
from restitution.studies.accuracy.tradeoff import (
    STORED,
    load_tradeoff,
    store_tradeoff,
    study_tradeoff,
)
from restitution.studies.collision.axis import Scale
from restitution.studies.spheres.walton import study_walton
from restitution.studies.tables.export import study_table_as_wanted
from restitution.studies.tables.grid import Sign, TableGrid
from restitution.studies.tables.largest_error import BASES, ErrorBasis
from restitution.wire.formats import CsvOptions, Decimal, Header, Separator, in_one_piece
from restitution.wire.queries import TableFormat, TableQuery
from restitution.wire.reading import read_query
from restitution.wire.results import table_result


@click.group(cls=Program)
@click.version_option(__version__, prog_name="restitution", message="%(prog)s %(version)s")
def main() -> None:
    """Exact collisions of spinning, frictional spheres."""


@main.command()
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8000,
    show_default=True,
    help="Port to listen on; 0 for any that is free.",
)
@click.option("--uds", metavar="PATH", help="Unix socket to listen on instead.")
@click.option(
    "--root-path",
    metavar="PATH",
    help="Path at which a proxy shows the service and which it cuts off, as /restitution.",
)
@click.option(
    "--forwarded-allow-ips",
    metavar="ADDRESSES",
    help="Proxies whose X-Forwarded-Prefix is believed; * for all.  [default: this machine]",
)
def serve(
    host: str, port: int, uds: str | None, root_path: str | None, forwarded_allow_ips: str | None
) -> None:
    """Serve the page and the API."""
    # workers have them from there
    for name, value in (("root_path", root_path), ("forwarded_allow_ips", forwarded_allow_ips)):
        if value is not None:
            os.environ[f"{PREFIX}{name.upper()}"] = value
    settings = _settings()
    for name in strangers():
        click.echo(f"{name} is no setting of the server and does nothing", err=True)
    sockets = [unix_listener(uds)] if uds else listeners(host, port)
    where = uds or f"http://{address_of(host, sockets[0].getsockname()[1])}"
    click.echo(f"serving {where}")
    if settings.workers == 1:
        serve_alone(sockets)
        return
    with contextlib.ExitStack() as until_the_end:
        # where the processes add up their counts
        try:
            folder = until_the_end.enter_context(tempfile.TemporaryDirectory())
            os.environ["PROMETHEUS_MULTIPROC_DIR"] = folder
        except OSError as error:
            click.echo(f"/metrics counts for each worker by itself: {error}", err=True)
        serve_in_workers(sockets, settings.workers)


class _Refusal(click.ClickException):
    """Of what was asked for, as click's own of wrong options, without a word on usage."""

    exit_code = 2


def _settings() -> Settings:
    try:
        return settings_of_environment()
    except SettingsError as wrong:
        raise _Refusal(str(wrong)) from wrong


@main.command()
def warm() -> None:
    """Compile the kernels, compress plotly.js and build the table into the cache."""
    folder = _settings().frontend_directory
    warm_kernels()
    compress_page(folder)
    warm_rest()


@main.command()
def openapi() -> None:
    """Write the OpenAPI document of the service, for generators of clients."""
    # of all commands this one alone needs the whole service
    from restitution.api.app import create_app  # noqa: PLC0415

    text = json.dumps(create_app(_settings()).openapi(), ensure_ascii=False, indent=1)
    say_json(text.encode())


def _in_a_folder(_: click.Context, __: click.Parameter, path: Path | None) -> Path | None:
    """Refuse a file that cannot be made, before the work that it is for."""
    if path and not path.parent.is_dir():
        raise click.BadParameter(f"there is no folder {path.parent}")
    return path


def _that_can_be_made(
    context: click.Context, parameter: click.Parameter, out: BinaryIO
) -> BinaryIO:
    """Refuse the same of a file that is opened when it is written to, and a folder."""
    # a stream of a test has no name
    path = Path(getattr(out, "name", "-"))
    _in_a_folder(context, parameter, path)
    if path.is_dir():
        raise click.BadParameter(f"{path} is a folder")
    return out


def _positive(_: click.Context, __: click.Parameter, number: float) -> float:
    if not 0 < number < math.inf:
        raise click.BadParameter(f"it must be finite and > 0, got {number:g}")
    return number


@main.command()
@click.option(
    "--out",
    type=click.File("wb"),
    default=NAME,
    show_default=True,
    callback=_that_can_be_made,
    help="HTML to write; - for standard output.",
)
def page(out: BinaryIO) -> None:
    """Write the page as one file that needs no server and no network."""
    out.write(one_file(_settings().frontend_directory).encode())


@main.command()
@click.option(
    "--scene", "scenes", type=click.Choice(list(SCENES)), multiple=True, help="All by default."
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    default=STORED,
    callback=_in_a_folder,
    help="JSON to renew; that of the package by default.",
)
@click.option(
    "--report",
    type=click.Path(dir_okay=False, path_type=Path),
    callback=_in_a_folder,
    help="Markdown to write about all that it holds then.",
)
def tradeoff(scenes: tuple[SceneName, ...], out: Path, report: Path | None) -> None:
    """Measure cost and error of every method on the collisions of a scene."""
    for scene in scenes or SCENES:
        with click.progressbar(length=1000, label=f"{scene:10}") as bar:
            for progress, measurement in study_tradeoff(scene):
                bar.update(round(1000 * progress) - bar.pos)
                finished = measurement
        store_tradeoff(finished, out)
    if report:
        report.write_text(tradeoff_report(load_tradeoff(out)), "utf-8")


main.add_command(collide)


@main.command(context_settings={"ignore_unknown_options": True})
@click.argument("beta_0", type=float)
def walton(beta_0: float) -> None:
    """Find the smallest κ whose undamped collisions have a β₀ of Walton's model."""
    study = study_walton(beta_0)
    others = ", ".join(f"{kappa:.8g}" for kappa in study.others)
    click.echo(f"kappa      {study.kappa:.16g}\nothers     {others}, …\n{study.convention}")


ENDS, COUNT = click.Tuple([str, str]), "Entries along it, unless --error is given."
SCALE = click.Choice(get_args(Scale))


@main.command()
@click.option("--kappa", type=ENDS, metavar="MIN MAX", help="0.1 70 by default.")
@click.option("--kappa-count", help=COUNT)
@click.option("--kappa-scale", type=SCALE, help="linear by default, log with --error.")
@click.option("--psi", type=ENDS, metavar="MIN MAX", help="0.01 4 by default.")
@click.option("--psi-count", help=COUNT)
@click.option("--psi-scale", type=SCALE, help="As of κ.")
@click.option(
    "--damping",
    type=ENDS,
    metavar="MIN MAX",
    help="η as a third axis, or the same number twice for all entries; 0 0 by default.",
)
@click.option("--normal-restitution", help="ε_n of all entries, in place of --damping.")
@click.option("--damping-count", help=COUNT)
@click.option("--damping-scale", type=SCALE, help="linear by default.")
@click.option("--error", help="Largest error of interpolation wanted.")
@click.option("--sign", type=click.Choice(get_args(Sign)), help="paper by default.")
@click.option("--format", type=click.Choice(get_args(TableFormat)), help="csv by default.")
@click.option(
    "--separator", type=click.Choice(get_args(Separator)), help="Of csv; comma by default."
)
@click.option("--decimal", type=click.Choice(get_args(Decimal)), help="Of csv; point by default.")
@click.option(
    "--header",
    type=click.Choice(get_args(Header)),
    help="What csv begins with: units is a line of units and convention before the names.",
)
@click.option(
    "--seconds",
    type=float,
    default=60.0,
    callback=_positive,
    help="Time of one core that it may take.",
)
@click.option(
    "--out",
    type=click.File("wb"),
    default="-",
    callback=_that_can_be_made,
    help="Standard output by default.",
)
@click.option(
    "--store",
    type=click.Path(file_okay=False, path_type=Path),
    help="Zarr store for a large table, computed on Dask (extra `cluster`); continued if there.",
)
@click.option("--scheduler", help="Address of a Dask scheduler; this machine's cores by default.")
@click.option("--workers", type=click.IntRange(1), help="Processes on this machine, for --store.")
@click.pass_context
def table(
    context: click.Context,
    /,
    seconds: float,
    out: BinaryIO,
    store: Path | None,
    scheduler: str | None,
    workers: int | None,
    **given: str | tuple[str, str] | None,
) -> None:
    """Write ε_t over κ and ψ, or κ, ψ and η, for another code, with its error of interpolation."""
    query = read_query(TableQuery, list(_as_query(given)))
    if store:
        idle = ("error", "format", "out", "seconds", *annotations(CsvOptions))
        _refuse_given(context, idle, "--store")
        grid = TableGrid(*query.axes, query.third)
        _large_table(store, grid, query.sign, scheduler, workers)
        return
    _refuse_given(context, ("scheduler", "workers"), "a table without --store")
    found = study_table_as_wanted(
        query.error, *query.axes, query.sign, query.third, seconds=seconds
    )
    out.write(in_one_piece(table_result(found), query.format, query))
    counts = " × ".join(str(count) for count in reversed(found.shape))
    _say_error(f"{counts} entries", found.largest_error, found.error_basis)


def _as_query(given: dict[str, str | tuple[str, str] | None]) -> Iterator[tuple[str, str]]:
    """Yield the options of a table as the parameters of ``GET /table``."""
    for name, value in given.items():
        if isinstance(value, str):
            yield name, value
        elif name == "damping" and value and value[0] == value[1]:
            yield name, value[0]
        elif value:
            yield f"{name}_min", value[0]
            yield f"{name}_max", value[1]


def _refuse_given(context: click.Context, names: tuple[str, ...], beside: str) -> None:
    """Raise if one of the options was given that are of no use `beside` others."""
    for option in context.command.params:
        if (
            option.name in names
            and context.get_parameter_source(option.name) is not ParameterSource.DEFAULT
        ):
            raise click.UsageError(f"{option.opts[0]} is of no use with {beside}: leave it out")


def _large_table(
    store: Path, grid: TableGrid, sign: Sign, scheduler: str | None, workers: int | None
) -> None:
    """Compute a table on Dask, with progress on standard error."""
    if scheduler and workers:
        raise click.UsageError("--workers is of no use with --scheduler: leave it out")
    try:
        from restitution.export.on_dask import compute_table  # noqa: PLC0415 - of an extra
        from restitution.export.zarr_store import finish  # noqa: PLC0415 - of an extra
    except ImportError as missing:
        raise click.ClickException(
            f"large tables take Dask and Zarr (there is no {missing.name}): "
            "pip install 'restitution[cluster]'"
        ) from missing
    done, total = 0, 0
    try:
        progress = compute_table(store, grid, sign, scheduler=scheduler, workers=workers)
        done, total = next(progress)
        if done:
            click.echo(f"{done} of {total} chunks are in {store} already", err=True)
        with click.progressbar(length=total, label="chunks", file=sys.stderr, show_pos=True) as bar:
            bar.update(done)
            for done, _ in progress:
                bar.update(1)
                # a log gets lines instead of the bar
                if not sys.stderr.isatty():
                    click.echo(f"{done} of {total} chunks", err=True)
        largest = finish(store)
    except OSError as refused:
        raise click.ClickException(str(refused)) from refused
    except KeyboardInterrupt as stopped:
        raise click.ClickException(
            f"stopped with {done} of {total} chunks in {store}; the same command goes on from there"
        ) from stopped
    counts = " × ".join(f"{count:,}" for count in reversed(grid.shape))
    _say_error(f"{counts} entries in {store}", largest.stated, largest.basis)


def _say_error(entries: str, largest_error: float, basis: ErrorBasis) -> None:
    """Write on standard error how good a table is."""
    click.echo(f"{entries}, error at most {largest_error:.3g} ({basis}: {BASES[basis]})", err=True)
