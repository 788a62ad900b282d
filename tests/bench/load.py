"""A real server under load: throughput, a class that drags, soak, footprint.

    make load [PARTS="throughput class fairness proxy soak"]

prints JSON. The generator runs on the same machine; its own CPU time is reported.
"""

import asyncio
import json
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import uvloop
from fairness import fairness
from measured import Connection, connect, cpu, resident, service
from proxy import nginx
from stored import COLLISION, TRACE

FRAME = 1.0 / 60.0
"""A page asks once for each frame that it draws, and never twice at a time."""

MAP = (
    "/api/v1/map?mu_over_alpha={}&kappa_count=120&gt_over_gn_count=80&tolerance=4e-3"
    "&encoding=base64"
)
WHOLE_MAP = (
    "/api/v1/map?mu_over_alpha={}&kappa_min=0.1&kappa_max=70&kappa_count=240&gt_over_gn_min=0.01"
    "&gt_over_gn_max=4&gt_over_gn_count=180&encoding=base64"
)
CUT = (
    "/api/v1/cut?along=gt_over_gn&mu_over_alpha={}&kappa={}&minimum=0.01&maximum=4&count=800"
    "&quantities=epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote&encoding=base64"
)
DRAGGED = "/api/v1/trace?kappa={}&mu_over_alpha={}&gt_over_gn={}&encoding=base64"


async def closed_loop(port: int, path: str, seconds: float, clients: int = 32) -> int:
    """Return how many requests were answered to clients that ask as fast as they can."""
    end = time.perf_counter() + seconds
    count = 0

    async def client() -> None:
        nonlocal count
        connection = await connect(port)
        while time.perf_counter() < end:
            connection = await connect(port, connection)
            assert await connection.get(path) == 200
            count += 1

    await asyncio.gather(*(client() for _ in range(clients)))
    return count


def rate(port: int, pid: int, path: str, seconds: float = 4.0) -> tuple[float, float]:
    """Return requests per second and per second of server CPU."""
    before, begin = cpu(pid), time.perf_counter()
    count = uvloop.run(closed_loop(port, path, seconds))
    return count / (time.perf_counter() - begin), count / (cpu(pid) - before)


def throughput(rounds: int = 3) -> dict:
    """Return requests per second, and ratios to stored bytes of the same length."""
    paths = {
        "collision": COLLISION,
        "stored collision": "/api/v1/stored/collision",
        "trace": TRACE,
        "stored trace": "/api/v1/stored/trace",
    }
    found: dict = {}
    for workers in (1, 2):
        with service(workers=workers) as (port, pid):
            rates = {name: [] for name in paths}
            for _ in range(rounds):
                for name, path in paths.items():
                    rates[name].append(rate(port, pid, path))
        found[workers] = {
            name: {
                "per_second": round(statistics.median(r for r, _ in rounds_of)),
                "per_cpu_second": round(statistics.median(c for _, c in rounds_of)),
            }
            for name, rounds_of in rates.items()
        }
    for name in ("collision", "trace"):
        one, two = found[1], found[2]
        for unit in ("per_second", "per_cpu_second"):
            found[f"{name} over stored, {unit}"] = round(
                one[name][unit] / one[f"stored {name}"][unit], 3
            )
            found[f"{name}, two workers over one, {unit}"] = round(
                two[name][unit] / one[name][unit], 3
            )
    return found


class Seen:
    """What browsers see of a server."""

    def __init__(self) -> None:
        self.statuses: Counter = Counter()
        self.errors: Counter = Counter()
        self.cache: Counter = Counter()
        self.waits: list[float] = []
        self.begin, self.own = time.perf_counter(), time.process_time()

    async def ask(
        self, port: int, connection: Connection, path: str
    ) -> tuple[Connection, float | None]:
        """Ask once; return the connection to go on with and the wait, None without an answer."""
        connection = await connect(port, connection)
        begin = time.perf_counter()
        try:
            status = await connection.get(path)
        except (OSError, TimeoutError) as error:
            self.errors[type(error).__name__] += 1
            return await connect(port), None
        self.statuses[status] += 1
        if found := re.search(rb"x-cache-status: (\w+)", connection.headers):
            self.cache[found[1].decode()] += 1
        if status != 200:
            # a second of the server, two of nginx
            assert re.search(rb"retry-after: [12]\b", connection.headers), connection.headers
            return connection, None
        self.waits.append(time.perf_counter() - begin)
        return connection, self.waits[-1]

    def told(self, browsers: int) -> dict:
        elapsed = time.perf_counter() - self.begin
        waits = sorted(self.waits)
        return {
            "browsers": browsers,
            "good_per_second": round(self.statuses[200] / elapsed, 1),
            "statuses": dict(self.statuses),
            "errors": dict(self.errors),
            "cache": dict(self.cache),
            "admitted_p50_ms": round(1e3 * waits[len(waits) // 2], 1),
            "admitted_p99_ms": round(1e3 * waits[int(0.99 * len(waits))], 1),
            "generator_cpu": round((time.process_time() - self.own) / elapsed, 2),
        }


async def polite_pause(dice: random.Random) -> None:
    """Wait as the page does that was sent away."""
    await asyncio.sleep(1.0 + dice.random())


async def drag(port: int, browsers: int, seconds: float, seed: int = 1) -> dict:
    """Return what browsers see that drag for `seconds` and have no kernel of their own."""
    end, seen = time.perf_counter() + seconds, Seen()

    async def browser(number: int) -> None:
        dice = random.Random(f"{seed} {number}")
        connection = await connect(port)
        await asyncio.sleep(dice.random() * 0.5)
        while time.perf_counter() < end:
            if dice.random() < 0.05:
                path = MAP.format(round(dice.uniform(0.2, 3), 2))
            else:
                numbers = (dice.uniform(1, 70), dice.uniform(0.2, 3), dice.uniform(0.01, 4))
                path = DRAGGED.format(*(round(n, 3) for n in numbers))
            connection, took = await seen.ask(port, connection, path)
            if took is None:
                await polite_pause(dice)
            else:
                await asyncio.sleep(max(0.0, FRAME - took))

    await asyncio.gather(*(browser(i) for i in range(browsers)))
    return seen.told(browsers)


async def drag_by_kernel(port: int, browsers: int, seconds: float, seed: int = 1) -> dict:
    """Return the same of pages as they are: they ask when the hand rests, a third of them after η.

    A drag takes one to three seconds, and as long passes until the next. What is asked then is the
    trace and, unless g_t/g_n was dragged, the cut and for μ/α and η the whole map.
    """
    end, seen = time.perf_counter() + seconds, Seen()

    async def browser(number: int) -> None:
        dice = random.Random(f"{seed} {number}")
        connection = await connect(port)
        slider = "damping" if number % 3 == 0 else dice.choice(["kappa", "mu", "gt"])
        await asyncio.sleep(4.0 * dice.random())
        while time.perf_counter() < end:
            kappa, mu, gt = (
                round(dice.uniform(*ends), 3) for ends in ((1, 70), (0.2, 3), (0.01, 4))
            )
            damped = f"&damping={dice.uniform(0.001, 1):.4f}" if slider == "damping" else ""
            paths = [DRAGGED.format(kappa, mu, gt)]
            if slider != "gt":
                paths.append(CUT.format(mu, kappa))
            if slider in {"mu", "damping"}:
                paths.append(WHOLE_MAP.format(mu))
            for path in paths:
                connection, took = await seen.ask(port, connection, path + damped)
                if took is None:
                    await polite_pause(dice)
            await asyncio.sleep(dice.uniform(2.0, 6.0))

    await asyncio.gather(*(browser(i) for i in range(browsers)))
    return seen.told(browsers)


def classroom(seconds: float = 60.0) -> dict:
    """Return the capacity and what 300 browsers get of it, first without kernels of their own."""
    found = {}
    with service() as (port, pid):
        # few enough that nobody is sent away: what the server can do
        found["capacity"] = max(
            (uvloop.run(drag(port, n, 8.0)) for n in (24, 48, 96)),
            key=lambda each: each["good_per_second"],
        )
        before = resident(pid)
        spent = cpu(pid)
        found["class"] = uvloop.run(drag(port, 300, seconds))
        found["server_cpu"] = round((cpu(pid) - spent) / seconds, 2)
        spent = cpu(pid)
        found["class, by kernels"] = uvloop.run(drag_by_kernel(port, 300, seconds))
        found["server_cpu, by kernels"] = round((cpu(pid) - spent) / seconds, 2)
        found["resident_mb"] = {"before": before, "after": resident(pid)}
    ratio = found["class"]["good_per_second"] / found["capacity"]["good_per_second"]
    return found | {"goodput_over_capacity": round(ratio, 3)}


def behind_proxy(seconds: float = 60.0) -> dict:
    """Return what 300 browsers get of two servers behind nginx, and what its cache answers."""
    with (
        tempfile.TemporaryDirectory() as folder,
        service() as (first, first_pid),
        service() as (second, second_pid),
        nginx(Path(folder, "nginx"), [first, second]) as proxy,
    ):
        capacity = max(
            uvloop.run(drag(proxy.port, n, 8.0))["good_per_second"] for n in (24, 48, 96, 192)
        )
        before = [*resident(first_pid), *resident(second_pid)]
        found = uvloop.run(drag(proxy.port, 300, seconds, seed=2))
        after = [*resident(first_pid), *resident(second_pid)]
        begin, spent = time.perf_counter(), cpu(first_pid) + cpu(second_pid)
        repeated = uvloop.run(closed_loop(proxy.port, TRACE, 4.0))
        servers = (cpu(first_pid) + cpu(second_pid) - spent) / (time.perf_counter() - begin)
    return {
        "capacity": capacity,
        "class": found,
        "goodput_over_capacity": round(found["good_per_second"] / capacity, 3),
        "resident_mb": {"before": before, "after": after},
        "repeated": {"per_second": round(repeated / 4.0), "servers_cpu": round(servers, 2)},
    }


async def mixed(port: int, count: int, clients: int = 16) -> Counter:
    """Return the statuses of many requests of all kinds."""
    dice = random.Random(2)
    kinds = [
        lambda: DRAGGED.format(dice.uniform(1, 500), dice.uniform(0.2, 3), dice.uniform(0.01, 4)),
        lambda: f"{COLLISION}&damping={dice.uniform(0, 1)}",
        lambda: f"{COLLISION}&method=timestep&steps={dice.randint(4, 5000)}",
        lambda: f"/api/v1/cut?along=kappa&mu_over_alpha={dice.uniform(0.2, 3)}&gt_over_gn=1",
        lambda: MAP.format(dice.uniform(0.2, 3)) + dice.choice(("", "&format=csv", "&format=npz")),
        lambda: f"/api/v1/collision?kappa={dice.choice(('NaN', '1e999', '-1'))}",
        lambda: "/nothing",
        lambda: "/api/v1/presets",
        lambda: "/static/main.js",
    ]
    weights = [40, 20, 5, 10, 5, 5, 5, 5, 5]
    statuses: Counter = Counter()
    left = count

    async def client() -> None:
        nonlocal left
        connection = await connect(port)
        while left > 0:
            left -= 1
            path = dice.choices(kinds, weights)[0]()
            statuses[await connection.get(path)] += 1

    await asyncio.gather(*(client() for _ in range(clients)))
    return statuses


def soak(count: int = 100_000) -> dict:
    """Return how memory grows over many mixed requests, after as many traces warmed it up."""
    with service() as (port, pid):
        started = resident(pid)
        uvloop.run(mixed(port, 10_000))
        before = resident(pid)
        statuses = uvloop.run(mixed(port, count))
        after = resident(pid)
    return {
        "requests": count,
        "statuses": dict(statuses),
        "resident_mb": {"started": started, "after 10,000": before, "after all": after},
        "growth": round(after[0] / before[0] - 1, 4),
    }


PARTS = {
    "throughput": throughput,
    "class": classroom,
    "fairness": fairness,
    "proxy": behind_proxy,
    "soak": soak,
}

if __name__ == "__main__":
    # kernels and table are in the cache then, and a server is warm seconds after its start
    subprocess.run([Path(sys.executable).with_name("restitution"), "warm"], check=True)
    for part in sys.argv[1:] or PARTS:
        print(json.dumps({part: PARTS[part]()}, indent=1), flush=True)
