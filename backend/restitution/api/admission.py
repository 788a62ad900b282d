"""When a request is computed: at once or in a thread, how many at a time, and which not at all.

A line that grows makes everybody wait and in the end nobody is served in time. So both lines are
short, and who finds them full is told at once (503) when to come again.
"""

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from fastapi import Request

from restitution.api.metrics import REFUSED, WAITING
from restitution.interruption import interruptible

Answer = TypeVar("Answer")

RETRY_AFTER = 1
"""Seconds after which a refused client may ask again; the lines are empty long before."""


MOST_HELD = 100 * 2**20
"""Bytes of bodies that are held together: two of the largest, and many small ones."""


ENDING = "the server is being stopped"


class SaturatedError(Exception):
    """A request cannot be answered in time, by this server or just now."""


class Admission:
    """Two lines before the processor.

    Parameters
    ----------
    most_quick : int
        Requests of under some milliseconds that may wait for their turn on the event loop. They
        take about 0.3 ms each, and longer ones pass through the same loop three times: of 300
        browsers that drag, 40 let one in a hundred wait for 0.11 s
        (`make load PARTS=class`).
    most_long : int
        Longer ones that are computed at the same time, each in a thread.
    most_waiting : int
        Longer ones that may wait for a thread.
    """

    def __init__(self, most_quick: int, most_long: int, most_waiting: int) -> None:
        self._most_quick, self._most_admitted = most_quick, most_long + most_waiting
        self._quick = self._admitted = self._held = 0
        self._is_ending = False
        # Its threads take the next computation themselves. A limiter on the event loop would hand
        # each over in a turn of the loop, which under load takes as long as a line of quick ones.
        self._threads = ThreadPoolExecutor(most_long, "computing")

    def hold(self, size: int) -> None:
        """Count `size` bytes of a body as held; `SaturatedError` if there are too many."""
        if self._held + size > MOST_HELD:
            raise saturated()
        self._held += size

    def release(self, size: int) -> None:
        """Count `size` bytes as held no longer."""
        self._held -= size

    def end(self) -> None:
        """Begin no further long computations, as the server ends: those that wait are told so."""
        self._is_ending = True
        self._threads.shutdown(wait=False, cancel_futures=True)

    async def quickly(self, work: Callable[[], Answer]) -> Answer:
        """Return what `work` gives, computed here: a thread would cost as much as the work."""
        if self._quick >= self._most_quick:
            raise saturated()
        self._quick += 1
        try:
            # everybody who has arrived is counted before anybody is served
            await asyncio.sleep(0)
            return work()
        finally:
            self._quick -= 1

    async def in_thread(self, request: Request, work: Callable[[], Answer]) -> Answer:
        """Return what `work` gives, computed in a thread; it is called off if the client leaves.

        Raises
        ------
        SaturatedError
            If too many wait already.
            Also if the server ends before it is done.
        InterruptionError
            If the client left.
        """
        if self._is_ending:
            raise SaturatedError(ENDING)
        if self._admitted >= self._most_admitted:
            raise saturated()
        stop = threading.Event()
        watch = asyncio.create_task(_watch(request, stop))
        self._admitted += 1
        WAITING.inc()
        try:
            loop = asyncio.get_running_loop()
            return await loop.run_in_executor(self._threads, _work, work, stop)
        except asyncio.CancelledError as ended:
            raise SaturatedError(ENDING) from ended
        finally:
            stop.set()
            self._admitted -= 1
            WAITING.dec()
            watch.cancel()


def admission_of(request: Request) -> Admission:
    """Return the admission of the service that got a request."""
    admission: Admission = request.app.state.admission
    return admission


def saturated() -> SaturatedError:
    """Return, counted, that more is asked for than can be answered."""
    REFUSED.labels("saturated").inc()
    return SaturatedError("more requests are under way than can be answered in time")


def _work(work: Callable[[], Answer], stop: threading.Event) -> Answer:
    with interruptible(stop):
        return work()


async def _watch(request: Request, stop: threading.Event) -> None:
    """Set `stop` when the client hangs up."""
    while (await request.receive())["type"] != "http.disconnect":
        pass
    stop.set()
