"""What one collision waits while ten clients ask for the dearest that a call admits."""

import asyncio
import json
import statistics
import time

import uvloop
from measured import Connection, connect, service
from stored import COLLISION

CLIENTS = 10
SECONDS = 8.0
PAUSE = 0.02

MILLION = [0.5 + 1e-6 * i for i in range(1_000_000)]
STEEL = {"youngs_modulus_pa": 2.1e11, "poisson_ratio": 0.3, "density_kg_m3": 7850, "radius_m": 0.02}
VELOCITIES = {"min": 0.1, "max": 100, "count": 1000, "scale": "log"}

DEAREST: dict[str, str | tuple[str, object]] = {
    "collision": f"{COLLISION}&method=timestep&steps=120000",
    "collision, ode": (
        "/api/v1/collision?kappa=500&mu_over_alpha=1&gt_over_gn=1&method=ode&rtol=1e-12"
    ),
    "trace": (
        "/api/v1/trace?kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358&samples=20000"
        "&method=timestep&steps=200000"
    ),
    "cut": (
        "/api/v1/cut?along=kappa&minimum=1&maximum=1000&count=100000&mu_over_alpha=1&gt_over_gn=0.9"
        "&method=exact&damping=0.1"
    ),
    "map": (
        "/api/v1/map?mu_over_alpha=1&kappa_min=1&kappa_max=500&kappa_count=1000&gt_over_gn_min=0.01"
        "&gt_over_gn_max=4&gt_over_gn_count=1000&tolerance=1e-10"
    ),
    "table": "/api/v1/table?kappa_min=1&kappa_max=300&kappa_count=500&psi_count=500",
    "steps": "/api/v1/steps?region=damped&error=1e-4",
    "collisions": (
        "/api/v1/collisions",
        {"kappa": MILLION, "mu_over_alpha": 1.4, "gt_over_gn": 1.358},
    ),
    "scaling/map": (
        "/api/v1/scaling/map",
        {
            "body_1": STEEL,
            "body_2": STEEL,
            "friction_coefficient": 0.4,
            "tangential_stiffness_n_per_m": "mindlin",
            "dissipative_constant_s": 1e-6,
            "normal_velocity_m_s": VELOCITIES,
            "tangential_velocity_m_s": VELOCITIES,
        },
    ),
}


async def _besides(port: int, dear: str | tuple[str, object] | None) -> dict[str, object]:
    """Return what a client waits that asks for one collision after another."""
    body = b"" if isinstance(dear, str) or dear is None else json.dumps(dear[1]).encode()
    end = time.perf_counter() + SECONDS
    statuses: dict[int, int] = {}

    async def insist() -> None:
        path = dear if isinstance(dear, str) else dear[0] if dear else ""
        while time.perf_counter() < end:
            connection = await connect(port)
            status = await _status(connection, path, body)
            statuses[status] = statuses.get(status, 0) + 1
            if status == 503:
                await asyncio.sleep(1.0)

    others = [asyncio.create_task(insist()) for _ in range(CLIENTS if dear else 0)]
    waits = []
    connection = await connect(port)
    while time.perf_counter() < end:
        begin = time.perf_counter()
        await connection.get(COLLISION)
        waits.append(time.perf_counter() - begin)
        await asyncio.sleep(PAUSE)
    for other in others:
        other.cancel()
    await asyncio.gather(*others, return_exceptions=True)
    waits.sort()
    return {
        "p50_ms": round(1e3 * statistics.median(waits), 1),
        "p99_ms": round(1e3 * waits[int(0.99 * len(waits))], 1),
        "most_ms": round(1e3 * waits[-1], 1),
        "dear": statuses,
    }


async def _status(connection: Connection, path: str, body: bytes) -> int:
    if not body:
        return await connection.get(path)
    return await connection.post(path, body)


def fairness() -> dict[str, object]:
    """Return the waits beside nothing, and beside the dearest of each call."""
    found: dict[str, object] = {}
    for name, dear in [("nothing", None), *DEAREST.items()]:
        # each with a server of its own: what is left in the line would count for the next
        with service() as (port, _):
            found[name] = uvloop.run(_besides(port, dear))
    return found
