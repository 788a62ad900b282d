"""Let more of what is generated to be right be right, where parameters must suit each other.

Without it one query in a hundred of /cut and /steps, and one body in twenty of /scaling, gets as
far as a computation, while queries of /table take up all the time. Loaded by schemathesis.toml.
"""

from typing import Any

import schemathesis
from schemathesis import Case, HookContext

ALONG = {"kappa": "gt_over_gn", "gt_over_gn": "kappa"}


def suit_cut(case: Case) -> None:
    """Give the other parameter of the two, and no range of its own."""
    along = case.query["along"]
    left_out = {along, "minimum", "maximum"}
    case.query = {n: v for n, v in case.query.items() if n not in left_out} | {ALONG[along]: 1.5}


def suit_steps(case: Case) -> None:
    """Ask for a region or for a whole collision."""
    collision = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
    if "region" in case.query:
        case.query = {n: v for n, v in case.query.items() if n not in collision}
    else:
        case.query = collision | case.query


def suit_table(case: Case) -> None:
    """Leave out the error: most are out of reach, which takes five seconds to find out."""
    case.query = {n: v for n, v in case.query.items() if n != "error"}


def suit_bodies(case: Case) -> None:
    """Give spheres either a density or a mass."""
    for name in ("body_1", "body_2"):
        sphere: dict[str, Any] = case.body[name]
        if "radius_m" in sphere and (sphere.get("mass_kg") is None or "density_kg_m3" in sphere):
            sphere |= {"mass_kg": None, "density_kg_m3": 2500.0}


SUIT = {
    # operation → what to do to a right case, and of how many one is left as it is
    "cut": (suit_cut, 2),
    "steps": (suit_steps, 2),
    "table": (suit_table, 16),
    "scaling": (suit_bodies, 2),
    "velocity_map": (suit_bodies, 2),
    "codes": (suit_bodies, 2),
}


@schemathesis.hook
def map_case(_: HookContext, case: Case) -> Case:
    """Change most of the right cases; the others test what is refused."""
    operation = case.operation.definition.raw["operationId"]
    right = case.meta is not None and case.meta.generation.mode.is_positive
    if operation in SUIT and right:
        suit, share = SUIT[operation]
        # by something that varies, and is the same when a case is repeated
        if len(f"{case.query}{case.body}") % share:
            suit(case)
    return case
