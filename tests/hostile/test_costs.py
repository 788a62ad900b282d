"""What a request will cost is known before it is done, over the whole range of every parameter.

Requests are drawn at random, some with nonsense beside what is allowed; their work is counted.
What is refused has done none; what is computed on the event loop is small, and so is what is
written there; all else stays within the limits of a request.
"""

import json
import math
from random import Random
from typing import Any

import pytest

from restitution.methods.options import Options
from service import Service

Drawn = dict[str, Any]

METHODS = ("auto", "exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode")


def by_decades(random: Random, low: float, high: float) -> float:
    return 10.0 ** random.uniform(math.log10(low), math.log10(high))


def value(random: Random) -> float:
    """An ordinary one, a large or small one, or one from anywhere in the range of doubles."""
    ends = random.choice([(1e-3, 1e5), (1e-3, 1e5), (1e-9, 1e12), (1e-300, 1e300)])
    return by_decades(random, *ends)


def count(random: Random, low: int, high: int) -> int:
    return min(high, int(by_decades(random, low, high + 1)))


def options(random: Random) -> Drawn:
    every = {
        "method": random.choice(METHODS),
        "damping": by_decades(random, *random.choice([(1e-6, 10.0), (1e-300, 1e30)])),
        "tolerance": by_decades(random, 1e-12, 0.1),
        "steps": count(random, 2, 200_000),
        "integrator": random.choice(["velocity_verlet", "symplectic_euler", "forward_euler"]),
        "phase": random.random(),
        "rtol": by_decades(random, 1e-13, 1e-3),
    }
    found = {name: chosen for name, chosen in every.items() if random.random() < 0.4}
    if "damping" not in found and random.random() < 0.3:
        found["normal_restitution"] = random.choice([random.random(), by_decades(random, 1e-50, 1)])
    return found


def quantities(random: Random) -> Drawn:
    return {"quantities": random.choice(["epsilon_t", "error", "epsilon_t,switches,error"])}


def axis(random: Random, name: str, most: int) -> Drawn:
    low, high = sorted([value(random), value(random)])
    return {
        f"{name}_min": low,
        f"{name}_max": high,
        f"{name}_count": count(random, 2, most),
        f"{name}_scale": random.choice(["linear", "log"]),
    }


def one(random: Random) -> Drawn:
    found = {name: value(random) for name in ("kappa", "mu_over_alpha", "gt_over_gn")}
    if random.random() < 0.3:
        found["episode_limit"] = count(random, 1, 10_000)
    return found | options(random)


def trace(random: Random) -> Drawn:
    return one(random) | {"samples": count(random, 2, 20_000)}


def cut(random: Random) -> Drawn:
    along, other = random.sample(["kappa", "gt_over_gn"], 2)
    low, high = sorted([value(random), value(random)])
    return {
        "along": along,
        other: value(random),
        "mu_over_alpha": value(random),
        "minimum": low,
        "maximum": high,
        "count": count(random, 2, 100_000),
        "scale": random.choice(["linear", "log"]),
    } | (options(random) | quantities(random))


def grid(random: Random) -> Drawn:
    axes = axis(random, "kappa", 2000) | axis(random, "gt_over_gn", 2000)
    return {"mu_over_alpha": value(random)} | axes | options(random) | quantities(random)


def table(random: Random) -> Drawn:
    found = axis(random, "kappa", 2000) | axis(random, "psi", 2000)
    if random.random() < 0.4:
        found |= {"damping_max": by_decades(random, 1e-6, 1e30)}
        found |= {"damping_count": count(random, 2, 200)}
    elif random.random() < 0.4:
        found["damping"] = by_decades(random, 1e-6, 1e3)
    return found


def steps(random: Random) -> Drawn:
    found: Drawn = {"error": by_decades(random, 1e-8, 0.5)}
    if random.random() < 0.5:
        return found | {"region": random.choice(["figure4", "solids", "stiff", "damped"])}
    return found | {name: value(random) for name in ("kappa", "mu_over_alpha", "gt_over_gn")}


def listed(random: Random) -> Drawn:
    size = count(random, 1, 30_000)
    found: Drawn = {
        name: [value(random) for _ in range(size)] if random.random() < 0.6 else value(random)
        for name in ("kappa", "mu_over_alpha", "gt_over_gn")
    }
    if random.random() < 0.3:
        found["damping"] = [by_decades(random, 1e-300, 10.0) for _ in range(size)]
    elif random.random() < 0.3:
        found["normal_restitution"] = [random.random() for _ in range(size)]
    way = options(random)
    if found.keys() & {"damping", "normal_restitution"}:
        way = {name: v for name, v in way.items() if name not in ("damping", "normal_restitution")}
    return way | found


def bodies(random: Random) -> Drawn:
    return {
        "body_1": {
            "radius_m": by_decades(random, 1e-6, 1.0),
            "youngs_modulus_pa": by_decades(random, 1e5, 1e12),
            "poisson_ratio": 0.3,
            "density_kg_m3": by_decades(random, 1e2, 1e4),
        },
        "body_2": {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25},
        "friction_coefficient": by_decades(random, 1e-3, 3.0),
        "tangential_stiffness_n_per_m": by_decades(random, 1.0, 1e9),
        "dissipative_constant_s": random.choice([0.0, by_decades(random, 1e-9, 1e-4)]),
    }


def impact(random: Random) -> Drawn:
    names = ("normal_velocity_m_s", "tangential_velocity_m_s")
    found = {"impact": {name: by_decades(random, 1e-3, 1e3) for name in names}}
    return bodies(random) | found


def velocities(random: Random) -> Drawn:
    found = bodies(random)
    for name in ("normal_velocity_m_s", "tangential_velocity_m_s"):
        low, high = sorted([by_decades(random, 1e-3, 1e3), by_decades(random, 1e-3, 1e3)])
        found[name] = {
            "min": low,
            "max": high,
            "count": count(random, 2, 3000),
            "scale": random.choice(["linear", "log"]),
        }
    return found | {"tolerance": by_decades(random, 1e-12, 0.1)}


QUERIES = {
    "/collision": one,
    "/trace": trace,
    "/cut": cut,
    "/map": grid,
    "/table": table,
    "/steps": steps,
}
BODIES = {"/collisions": listed, "/scaling": impact, "/scaling/map": velocities}

FEW = {"/table": 4, "/steps": 5, "/map": 8}
"""Requests of calls that take long."""


def ask(service: Service, path: str, random: Random) -> Any:
    """The response to a random request, whose work was within its limits."""
    asked = (QUERIES | BODIES)[path](random)
    if random.random() < 0.1:
        # wrong in one place, dear in the others
        asked[random.choice(sorted(asked))] = random.choice([-1, "many", [], None])
    encoding = random.choice(["plain", "base64"])
    if path in QUERIES:
        send = lambda: service.get(path, **asked, encoding=encoding)  # noqa: E731
    else:
        body = json.dumps(asked).encode()
        send = lambda: service.post(body, path=path, encoding=encoding)  # noqa: E731
    if path == "/table":
        send = lambda: service.get(path, **asked, format="npz")  # noqa: E731
    response = service.affordable(send)
    assert response.status_code in {200, 413, 422}, (response.status_code, asked)
    return response


@pytest.mark.parametrize("path", [*QUERIES, *BODIES])
def test_costs_are_known_before_the_work(service, path):
    random = Random(f"{path} 1")
    statuses = [ask(service, path, random).status_code for _ in range(FEW.get(path, 15))]
    assert 200 in statuses


@pytest.mark.verify
@pytest.mark.parametrize("seed", range(2, 12))
@pytest.mark.parametrize("path", [*QUERIES, *BODIES])
def test_costs_of_many_more_requests_are_known_before_the_work(service, path, seed):
    random = Random(f"{path} {seed}")
    for _ in range(200):
        ask(service, path, random)


STIFF = {"mu_over_alpha": 1.0, "kappa_max": 1e8, "kappa_count": 300, "gt_over_gn_count": 300}
WEAK = STIFF | {"gt_over_gn_max": 1.7, "gt_over_gn_count": 3000}
MUCH = {
    "error beside": STIFF | {"quantities": "epsilon_t,error"},
    "most only looked at": WEAK,
    "looked at twice": WEAK | {"quantities": "epsilon_t", "tolerance": 1e-6},
}


@pytest.mark.verify
@pytest.mark.parametrize("damping", [0.0, 4e-176, 0.1])
@pytest.mark.parametrize("work", MUCH)
def test_limit_holds_for_all_that_is_looked_at_and_followed(service, damping, work):
    response = service.affordable(lambda: service.get("/map", damping=damping, **MUCH[work]))
    assert response.status_code == 200


def test_every_option_is_drawn():
    random = Random(0)
    drawn = {name for _ in range(100) for name in options(random)}
    assert drawn <= {*Options.__dataclass_fields__, "normal_restitution"}
    assert drawn >= {"method", "damping", "normal_restitution", "tolerance", "steps", "phase"}
