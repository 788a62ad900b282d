"""What a parameter was perhaps meant for that a call does not have: of HTTP, Python or a shell."""

import difflib
import functools
import inspect
import re
from collections.abc import Callable, Collection, Iterable
from typing import ParamSpec, TypeVar

from restitution.errors import UnknownParameterError

Parameters = ParamSpec("Parameters")
Returned = TypeVar("Returned")

MEANT = {
    "normal_restitution": "e_n en epsilon_n eps_n cor cr e epsilon restitution "
    "coefficient_of_restitution restitution_coefficient coefficient_of_normal_restitution",
    "damping": "eta η dissipation viscosity damping_coefficient damping_ratio "
    "dissipative_constant dissipative_constant_s",
    "dissipative_constant_s": "a eta η damping dissipation dissipative_time damping_constant "
    "damping_coefficient viscosity",
    "kappa": "κ k kt k_t stiffness tangential_stiffness tangential_stiffness_n_per_m",
    "mu_over_alpha": "mu μ µ friction friction_coefficient coefficient_of_friction cof mu_alpha",
    "gt_over_gn": "gt g_t gt_gn psi ψ velocity_ratio tangential_velocity angle angle_deg",
    "friction_coefficient": "mu μ µ friction coefficient_of_friction cof mu_over_alpha",
    "tangential_stiffness_n_per_m": "kt k_t k stiffness shear_stiffness kappa",
    "radius_m": "r radius diameter size",
    "mass_kg": "m mass weight",
    "density_kg_m3": "rho ρ density",
    "youngs_modulus_pa": "e y young youngs young_modulus modulus elastic_modulus elasticity",
    "poisson_ratio": "nu ν poisson poissons_ratio",
    "inertia": "j i moment moment_kg_m2 moment_of_inertia hollow solid",
    "yield_stress_pa": "yield yield_strength sigma_y",
    "speed_m_s": "speed v velocity impact_velocity impact_speed",
    "angle_deg": "angle theta θ impact_angle incidence angle_of_incidence",
    "normal_velocity_m_s": "gn g_n vn v_n normal_speed",
    "tangential_velocity_m_s": "gt g_t vt v_t tangential_speed",
    "velocity_1_m_s": "v1 v_1",
    "velocity_2_m_s": "v2 v_2",
    "spin_1_rad_s": "omega ω spin omega_1 omega1 ω1 ω_1 angular_velocity angular_velocity_1",
    "spin_2_rad_s": "omega_2 omega2 ω2 ω_2 angular_velocity_2",
    "at_normal_velocity_m_s": "at reference_velocity at_velocity",
    "body_1": "body sphere sphere_1 particle particle_1",
    "body_2": "sphere_2 particle_2 wall",
    "beta_0": "beta beta0 β β0 β_0",
    "method": "solver algorithm",
    "tolerance": "tol atol accuracy",
    "steps": "n n_steps nsteps",
    "samples": "n points n_samples",
    "count": "n num points",
    "separator": "sep delimiter delim",
    "decimal": "dec decimal_mark decimal_separator decimal_point",
    "minimum": "min low from",
    "maximum": "max high to",
    "region": "scene",
    "scene": "region",
}
"""Our name → what others call it, in the order in which one word is taken for several of ours."""

UNIT = re.compile(
    r"_(?:kg_m3|g_cm3|kg_m2|n_per_m|n_m|m_s|mm_s|cm_s|rad_s|rpm|[kmg]?pa|kg|g|deg|rad|mm|cm|um|µm|m|s)$"
)
"""At the end of a name."""

LONGEST = 40
"""Characters of a name that is looked at: none of ours has more."""


def stem(name: str) -> str:
    """Return a name without its unit."""
    return UNIT.sub("", name)


@functools.cache
def _synonyms() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for ours, words in MEANT.items():
        for word in words.split():
            found.setdefault(word, []).append(ours)
    return found


def neighbour(name: str, known: Iterable[str]) -> str | None:
    """Return which of the `known` names a name was perhaps meant for.

    Known names may be dotted: a name is then compared with their last part.

    Examples
    --------
    >>> neighbour("epsilon_n", ["kappa", "damping", "normal_restitution"])
    'normal_restitution'
    >>> neighbour("Radius", ["body_1.radius_m"]), neighbour("xyz", ["kappa"])
    ('body_1.radius_m', None)
    """
    written = name.strip().lower().replace("-", "_").replace(" ", "_")
    if not 0 < len(written) <= LONGEST:
        return None
    # the first of several of one name
    places = {each.rpartition(".")[2]: each for each in reversed(list(known))}
    same = [last for last in places if last == written]
    synonyms = [last for last in _synonyms().get(written, ()) if last in places]
    of_stem = [last for last in places if stem(last) == stem(written)]
    by_stem = [last for last in _synonyms().get(stem(written), ()) if last in places]
    found = next(iter([*same, *synonyms, *of_stem, *by_stem]), None) or _close(written, places)
    return None if found is None else places[found]


def _close(written: str, known: Iterable[str]) -> str | None:
    """Return the known name that looks most like one, or whose synonym does."""
    words = {word: name for name in known for word in (*MEANT.get(name, "").split(), name)}
    near = difflib.get_close_matches(written, [word for word in words if len(word) > 3], 1, 0.75)
    return words[near[0]] if near else None


def naming_neighbours(
    call: Callable[Parameters, Returned], others: Collection[str] = ()
) -> Callable[Parameters, Returned]:
    """Return a call that says of a keyword which it does not have what was perhaps meant.

    `others` are the names that it takes as ``**``, if it takes any in that way.
    """
    names = [
        name
        for name, each in inspect.signature(call).parameters.items()
        if name != "self" and each.kind is not inspect.Parameter.VAR_KEYWORD
    ]
    known = dict.fromkeys((*names, *others))

    @functools.wraps(call)
    def called(*given: Parameters.args, **named: Parameters.kwargs) -> Returned:
        for name in (name for name in named if name not in known):
            raise UnknownParameterError(name, named[name], neighbour(name, known))
        return call(*given, **named)

    return called
