"""The stored measurements as a document."""

from collections.abc import Iterable, Sequence
from typing import Any

from restitution.studies.accuracy.scenes import SCENES, SceneName

WANTED = 1e-3
"""Largest error for which the cheapest route is looked up."""

INTRODUCTION = """\
# Speed and accuracy

What each way to ε_t costs and how far it is off, measured on five regions of collisions. `make
tradeoff` measures anew, stores the result in the package and writes this page from it; the
service has the same rows at `/api/v1/tradeoff`.

**How.** Time is that of all threads' CPU, for one collision, the median of five repeats (of `ode`
one, of single collisions). `auto`, `exact`, `coulomb`, `pragmatic`, `stiff` and `table` get all
collisions at once. `timestep` is timed one collision at a time, as a code pays it whose contacts
begin when they like; many that begin at once share their normal motion and cost thirty times
less. `exact` and `auto` do without damping a thousand collisions together, whenever these begin:
one by itself costs about ten times as much. The contacts of `timestep` begin at eight instants
within a step. Errors are |ε_t − exact| plus the guaranteed bound on the exact value, which is all
that `exact` itself has. *Wrong sign*: share of collisions with ε_t of the opposite sign; 0 has
none. *Wrong switches*: share with another number of switches, of those that are certain; a dash
where none are counted. *Refused*: share that the method does not answer; the other figures are
about the rest.

The damped contacts share seven η (0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.5); the normal motion of
each is prepared once and not timed. `stiff` and `table` are made for η = 0 and take no part here.

`symplectic_euler` gives the numbers of `velocity_verlet`: no force acts before or after the
contact, so that half a kick more or less at its ends is none. `ode` with `spring` has no events
located: `held` has the cap as a case in its equations, `free` is Eq. 23 of the paper as printed,
in which the force is capped and the spring is not: it converges, to another answer.
"""

COLUMNS = (
    "method",
    "options",
    "µs",
    "error, median",
    "p95",
    "largest",
    "wrong sign",
    "wrong switches",
    "refused",
)

PEER = """
`lammps` is another program, LAMMPS with `pair_style granular`, on the same collisions: 400 pairs,
those of one η at once, one thread, contacts that begin anywhere within a step
(`tests/bench/peers.py`). Its steps are those of `timestep` with velocity Verlet, with which it
agrees to 3e-6 from the same instant on, damped or not; its time is that of a whole code, with
neighbour lists, three dimensions and a history for each contact.
"""

NO_PEER = """
No other program took part: without the extra `peers` (LAMMPS) only our own methods are measured.
"""

ROUTES = """\
## The cheapest route to ε_t within 1e-3

The cheapest row of each scene whose largest error is at most 1e-3 and that refuses no collision,
beside the common rule of fifty steps of velocity Verlet, and what Verlet takes for the same.

"""

MANY = """
**A billion collisions** of Fig. 4, drawn at random, took 60 s on two shared cores (103 s of CPU,
`collide` of two million at a time, November 2026), with one η 117 s. What bounds them is
arithmetic: every core adds its share, in this process or as a worker of Dask (`restitution table
--store`), until what comes out, 21 bytes of each, is more than a disk or a network takes in.
"""

ROUTE_COLUMNS = (
    "scene",
    "cheapest",
    "µs",
    "largest error",
    "Verlet, 50 steps: µs",
    "largest error",
    "times faster",
    "times closer",
    "Verlet within 1e-3: steps",
    "µs",
)


STEPS = """
## Steps per contact for a wanted error

The number of steps from which on every one that was tried keeps the error: for 95 % of 1,024
contacts (128 collisions of the scene, each from eight instants within a step), and for all of
them; a larger sample, as below, may have worse ones. Tried were the rungs of a ladder by factors of
√2, up to 65,536, and numbers up to twice the answer: each of them as far as 512, some of larger
ones. `/api/v1/steps` measures it for any error, region or single collision, and says what it tried.
Velocity Verlet and symplectic Euler are one here.

"""

STEPS_COLUMNS = (
    "scene",
    "error",
    "Verlet: 95 %",
    "all",
    "forward Euler: 95 %",
    "all",
)

RULE = """
The rule N = 50 √κ, each collision with its own N, and the errors that it leaves with Verlet:

"""

RULE_COLUMNS = ("scene", "steps", "error, median", "p95", "largest")


def _line(cells: Iterable[str]) -> str:
    return f"| {' | '.join(cells)} |\n"


def _header(columns: Sequence[str]) -> str:
    return _line(columns) + _line(["---"] * len(columns))


def _number(value: float | None) -> str:
    return "–" if value is None else f"{float(f'{value:.2g}'):g}"


def _count(value: float) -> str:
    return f"{value:,.0f}" if value < 1e6 else _number(value)


def _share(value: float | None) -> str:
    return "–" if value is None else "0" if value == 0.0 else f"{_number(100.0 * value)} %"


def _options(row: dict[str, Any]) -> str:
    return ", ".join(
        str(value) if isinstance(value, str) else f"{name} {value:g}"
        for name, value in row["options"].items()
    )


def _row(row: dict[str, Any]) -> str:
    cells = [
        f"`{row['method']}`",
        _options(row),
        _number(row["microseconds_per_collision"]),
        *(_number(row[f"error_{name}"]) for name in ("median", "p95", "max")),
        *(_share(row[name]) for name in ("wrong_sign", "wrong_switches", "unanswered")),
    ]
    return _line(cells)


def _route(scene: str, rows: list[dict[str, Any]]) -> str:
    verlet = {"integrator": "velocity_verlet", "steps": 50}
    common = next(row for row in rows if row["options"] == verlet)
    good = [row for row in rows if row["unanswered"] == 0.0 and row["error_max"] <= WANTED]
    if not good:
        return _line([scene, "none", *["–"] * 8])
    best = min(good, key=lambda row: float(row["microseconds_per_collision"]))
    stepped = [row for row in good if row["options"].get("integrator") == "velocity_verlet"]
    fair = min(stepped, key=lambda row: int(row["options"]["steps"]), default=None)
    cells = [
        scene,
        f"`{best['method']}` {_options(best)}".strip(),
        _number(best["microseconds_per_collision"]),
        _number(best["error_max"]),
        _number(common["microseconds_per_collision"]),
        _number(common["error_max"]),
        _number(common["microseconds_per_collision"] / best["microseconds_per_collision"]),
        _number(common["error_max"] / best["error_max"]),
        _count(fair["options"]["steps"]) if fair else "more",
        _number(fair["microseconds_per_collision"] if fair else None),
    ]
    return _line(cells)


def _steps(scene: str, steps: dict[str, Any]) -> str:
    needed = [steps["needed"][name] for name in ("velocity_verlet", "forward_euler")]
    counts = [integrator[part] for integrator in needed for part in ("p95", "worst")]
    cells = ["more" if count is None else f"{count:,}" for count in counts]
    return _line([scene, _number(steps["error"]), *cells])


def _rule(scene: str, steps: dict[str, Any]) -> str:
    spread = steps["rule"]["velocity_verlet"]
    errors = [_number(spread[f"error_{name}"]) for name in ("median", "p95", "max")]
    return _line([scene, "…".join(_count(count) for count in steps["rule_steps"]), *errors])


def tradeoff_report(stored: dict[SceneName, Any]) -> str:
    """Return `stored` (scene → `Measurement` as a dictionary) as Markdown."""
    methods = {row["method"] for kept in stored.values() for row in kept["rows"]}
    text = INTRODUCTION + (PEER if "lammps" in methods else NO_PEER)
    text += "\n" + ROUTES + _header(ROUTE_COLUMNS)
    text += "".join(_route(scene, kept["rows"]) for scene, kept in stored.items())
    text += MANY + STEPS + _header(STEPS_COLUMNS)
    text += "".join(_steps(scene, s) for scene, kept in stored.items() for s in kept["steps"])
    text += RULE + _header(RULE_COLUMNS)
    text += "".join(_rule(scene, kept["steps"][0]) for scene, kept in stored.items())
    for scene, kept in stored.items():
        when = kept["measured_at"][:10]
        text += f"\n## {SCENES[scene].title}\n\n"
        text += f"Measured {when} on {kept['machine']}; model {kept['model_version']}.\n\n"
        text += _header(COLUMNS) + "".join(_row(row) for row in kept["rows"])
    return text
