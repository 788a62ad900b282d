"""Who is served at once, who waits, who is sent away; and work that stops when nobody waits."""

import asyncio
import threading

import pytest

from restitution.api.admission import Admission, SaturatedError
from restitution.interruption import InterruptionError, interruptible, pause
from restitution.mechanics.collision import PART, collide
from restitution.methods.ode import integrate
from waiting import LIMIT_SECONDS, eventually
from work import counted


class Client:
    """Stands for a request of which only the end of the connection is read."""

    def __init__(self):
        self.gone = asyncio.Event()

    async def receive(self):
        await self.gone.wait()
        return {"type": "http.disconnect"}


async def outcomes(*tasks):
    found = await asyncio.gather(*tasks, return_exceptions=True)
    return [r if isinstance(r, int) else type(r) for r in found]


def test_quick_requests_beyond_the_line_are_sent_away_before_any_work():
    async def scene():
        admission, worked = Admission(3, 1, 0), []

        def work():
            worked.append(1)
            return 1

        found = await outcomes(*(admission.quickly(work) for _ in range(5)))
        assert found == [1, 1, 1, SaturatedError, SaturatedError]
        assert len(worked) == 3
        # the line is empty again
        assert await admission.quickly(work) == 1

    asyncio.run(scene())


def test_a_line_is_freed_by_work_that_fails():
    async def scene():
        admission = Admission(1, 1, 0)
        for _ in range(3):
            with pytest.raises(ZeroDivisionError):
                await admission.quickly(lambda: 1 // 0)

    asyncio.run(scene())


def test_long_requests_wait_in_a_line_of_bounded_length():
    async def scene():
        admission, go, most = Admission(1, 2, 1), threading.Event(), []
        running, begun = threading.Semaphore(2), threading.Semaphore(0)

        def work():
            most.append(running.acquire(blocking=False))
            begun.release()
            go.wait(LIMIT_SECONDS)
            running.release()
            return 1

        tasks = [asyncio.ensure_future(admission.in_thread(Client(), work)) for _ in range(5)]
        # two are sent away while two are computed, and one waits for its turn
        await asyncio.wait(tasks[3:])
        for _ in range(2):
            await asyncio.to_thread(begun.acquire)
        assert not any(task.done() for task in tasks[:3])
        go.set()
        found = await outcomes(*tasks)
        assert sorted(map(str, found)) == sorted(map(str, [1, 1, 1, *2 * [SaturatedError]]))
        assert all(most), "more than two were computed at a time"

    asyncio.run(scene())


def test_quick_requests_are_answered_while_a_long_one_is_held():
    async def scene():
        admission, go, begun = Admission(1, 1, 0), threading.Event(), threading.Event()

        def held():
            begun.set()
            return go.wait(LIMIT_SECONDS)

        long = asyncio.ensure_future(admission.in_thread(Client(), held))
        await asyncio.to_thread(begun.wait)
        assert [await admission.quickly(lambda: 1) for _ in range(3)] == [1, 1, 1]
        assert not long.done()
        go.set()
        assert await long

    asyncio.run(scene())


def test_work_is_called_off_when_its_client_hangs_up():
    async def scene():
        admission, client, begun = Admission(1, 1, 1), Client(), threading.Event()

        def work():
            begun.set()
            eventually(called_off)

        def called_off():
            pause()
            raise AssertionError("the work goes on")

        task = asyncio.ensure_future(admission.in_thread(client, work))
        await asyncio.to_thread(begun.wait)
        client.gone.set()
        with pytest.raises(InterruptionError):
            await task
        # and the thread is free for the next one
        assert await admission.in_thread(Client(), lambda: 1) == 1

    asyncio.run(scene())


@pytest.mark.parametrize(
    "work",
    [
        lambda: collide(18.0, 0.3),
        lambda: collide(18.0, [0.3] * (2 * PART)),
        lambda: integrate(18.0, 0.3, 1e-6, "events", 10_000, 0.0),
    ],
    ids=["one", "in threads", "general solver"],
)
def test_mechanics_pause_where_they_may_be_called_off(work):
    stop = threading.Event()
    with interruptible(stop):
        work()
        stop.set()
        with pytest.raises(InterruptionError):
            work()
    work()


@pytest.mark.parametrize(
    ("parameters", "line"),
    [
        ({"samples": 2400}, "quick"),
        ({"samples": 2500}, "long"),
        # the instants of its switches are written as its samples are
        ({"samples": 400, "kappa": 1e6, "gt_over_gn": 1.4}, "quick"),
        ({"samples": 400, "kappa": 3e7, "gt_over_gn": 1.4}, "long"),
        ({"samples": 400, "kappa": 3e6, "gt_over_gn": 1.4, "episode_limit": 0}, "quick"),
        ({"samples": 400, "kappa": 3e6, "gt_over_gn": 1.4, "episode_limit": 10_000}, "long"),
        ({"samples": 400, "method": "timestep", "steps": 1000}, "quick"),
        # its steps are written as the samples are
        ({"samples": 400, "method": "timestep", "steps": 130_000}, "long"),
        ({"samples": 400, "steps": 130_000}, "quick"),
    ],
)
def test_a_trace_of_many_instants_does_not_wait_on_the_event_loop(service, parameters, line):
    trace = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
    with counted() as work:
        response = service.get("/trace", **trace | parameters)
    assert response.status_code == 200
    assert work[line] == 1
