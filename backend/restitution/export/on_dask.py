"""Large tables computed by Dask: chunks of a Zarr store, on this machine's cores or a cluster."""

import contextlib
import itertools
import logging
from collections.abc import Iterator
from pathlib import Path

from distributed import Client, KilledWorker, LocalCluster, as_completed

from restitution.errors import ParameterError, RestitutionError
from restitution.export.zarr_store import Index, missing_chunks, open_store, write_chunk
from restitution.studies.tables.cost import refuse_stiff
from restitution.studies.tables.export import tabulated
from restitution.studies.tables.grid import Sign, TableGrid

AHEAD = 3
"""Chunks for each thread that the scheduler knows of: one in work, others to go on with."""

MEMORY = "1GiB"
"""Of a worker on this machine; programs take a quarter of it, a chunk a tenth."""

KEEP_OUT = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"
"""For workers: a terminal sends Ctrl-C to them, too, but closing them is for the program."""

NOT_OUTSIDE = "127.0.0.1:0"


def compute_table(
    path: Path,
    grid: TableGrid,
    sign: Sign,
    *,
    scheduler: str | None = None,
    workers: int | None = None,
) -> Iterator[tuple[int, int]]:
    """Fill the store at `path`, made if need be, yielding the chunks that are there, and of all.

    Chunks that are there are not computed again, so that this continues what was stopped. When all
    of them are there, `zarr_store.finish` states the error.

    Parameters
    ----------
    path : Path
        Of the store; on a cluster a path that every worker has.
    grid : TableGrid
        Where the entries are.
    sign : ``"paper"`` or ``"reversed"``
        Convention of the entries.
    scheduler : str, optional
        Address of a Dask scheduler; workers of this machine otherwise.
    workers : int, optional
        Their number, one for each core by default.

    Raises
    ------
    ParameterError
        If the store holds another table, or an axis is wrong.
    CostError
        If collisions have too many switches to be followed.
    RestitutionError
        If workers die of a chunk again and again, are of another version, or there is no scheduler.
    """
    path = path.absolute()
    refuse_stiff(grid.nodes())
    open_store(path, grid, sign)
    missing, total = missing_chunks(path)
    yield total - len(missing), total
    if missing:
        if scheduler is None:
            # compiled once, before several processes would do it at the same time
            tabulated(grid.nodes().part(*[slice(2)] * 3), sign)
        with _client(scheduler, workers) as client:
            for done, _ in enumerate(_written(client, path, missing), total - len(missing) + 1):
                yield done, total


@contextlib.contextmanager
def _client(scheduler: str | None, workers: int | None) -> Iterator[Client]:
    if scheduler is not None:
        try:
            client = Client(scheduler, set_as_default=False)
        except (OSError, ValueError) as error:
            raise RestitutionError(f"no Dask scheduler answers at {scheduler}: {error}") from error
        with client:
            yield client
        return
    with (
        local_cluster(workers) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        yield client


def local_cluster(workers: int | None = None) -> LocalCluster:
    """Return so many worker processes of one thread on this machine, by default one for each core.

    Nothing of it can be reached from outside: without addresses its web pages would be open to all.
    """
    return LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        memory_limit=MEMORY,
        dashboard_address=NOT_OUTSIDE,
        worker_dashboard_address=NOT_OUTSIDE,
        silence_logs=logging.ERROR,
        preload=KEEP_OUT,
    )


def _written(client: Client, path: Path, missing: list[Index]) -> Iterator[None]:
    """Have chunks written, yielding after each; those of a worker that dies are given to others."""
    waiting = iter(missing)
    running = as_completed(loop=client.loop)

    def submit() -> None:
        # a cluster may grow meanwhile
        room = AHEAD * max(1, sum(client.nthreads().values())) - running.count()
        for index in itertools.islice(waiting, max(0, room)):
            running.add(client.submit(write_chunk, str(path), index, pure=False))

    submit()
    for future in running:
        try:
            future.result()
        except KilledWorker as error:
            raise RestitutionError(
                f"workers died of one chunk again and again, perhaps for lack of memory: {error}"
            ) from error
        except (ParameterError, OSError) as error:
            raise RestitutionError(
                f"a worker could not write to {path}, which must be a path that every worker has: "
                f"{error}"
            ) from error
        submit()
        yield
