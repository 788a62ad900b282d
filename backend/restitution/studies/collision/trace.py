"""The forces and velocities of one collision over time."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import numpy.typing as npt
from annotated_types import Ge, Le

from restitution.bounds import allowed, chosen
from restitution.bounds import values as members
from restitution.errors import CostError
from restitution.mechanics.collision import MOST_SWITCHES as FOLLOWED_SWITCHES
from restitution.mechanics.collision import expected_switch_counts
from restitution.mechanics.contact import contact_duration, normal_curves
from restitution.mechanics.curves import instants, tangential_columns
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.motion import Motion
from restitution.mechanics.scaled_velocity import WEAKEST
from restitution.mechanics.stepping import stepped_course
from restitution.methods.options import Options, refuse_damping
from restitution.studies.collision.one import CollisionStudy, followed_motion, study_collision
from restitution.studies.collision.parameters import CONVENTION, CollisionParameters
from restitution.studies.tabular import Table, Tabular

COLUMNS = (
    "time",
    "compression",
    "compression_rate",
    "normal_force",
    "tangential_force_over_mu",
    "tangential_velocity",
    "spring_elongation",
    "regime",
    "tangential_energy",
)

Samples = Annotated[int, Ge(2), Le(20_000)]

MOST_SWITCHES = 20_000
"""A trace with more switches than this has no picture."""

MOST_STEPS = 20_000
"""Steps of ``timestep`` that are shown: of more, every second, third, … and the last."""


@dataclass(frozen=True)
class TraceStudy(Tabular):
    """A collision over time.

    Attributes
    ----------
    collision : CollisionStudy
        The collision itself.
    columns : dict of str to ndarray, shape (samples + switches,)
        Those asked for of `trace`, in scaled units.
    switch_times : ndarray, shape (switches,)
        Instants of the switches; each is also among the samples.
    method_columns : dict of str to ndarray
        For ``timestep`` what it takes the collision for, at the touch and its own steps, so with a
        length of its own: `method_time`, `method_tangential_force_over_mu`,
        `method_tangential_velocity`. Empty for other methods.
    time : ndarray, shape (samples + switches,)
        Instants of the columns, whether or not they are asked for as one.

    Examples
    --------
    >>> found = study_trace(CollisionParameters(63.0, 1.4, 1.358), samples=5)
    >>> found["regime"][-1], found.to_pandas().shape
    (np.int8(1), (13, 8))
    """

    collision: CollisionStudy
    columns: dict[str, FloatArray | npt.NDArray[np.int8]]
    switch_times: FloatArray
    method_columns: dict[str, FloatArray]
    time: FloatArray

    def __getitem__(self, column: str) -> FloatArray | npt.NDArray[np.int8]:
        """Return one of the columns."""
        return self.columns[column]

    def table(self) -> Table:
        """Return the columns over time, without those of the method's own steps."""
        columns = {name: values for name, values in self.columns.items() if name != "time"}
        given = members(self.collision.parameters) | {"epsilon_t": self.collision.epsilon_t}
        return Table(
            {"time": self.time},
            columns,
            {name: np.array(value) for name, value in given.items()},
            {"convention": CONVENTION},
        )


def study_trace(
    parameters: CollisionParameters,
    options: Options | None = None,
    samples: int = 400,
    columns: Collection[str] = COLUMNS,
    episode_limit: int = 200,
) -> TraceStudy:
    """Return a collision at uniform instants, merged with those of its switches.

    Parameters
    ----------
    parameters : CollisionParameters
        κ, μ/α, g_t/g_n, η.
    options : Options, optional
        Method and tolerance of ε_t; the columns are exact, those of ``timestep`` stand beside them.
    samples : int, optional
        Uniform instants from 0 to t_c, 2 to 20,000.
    columns : collection of str, optional
        Of `COLUMNS`; only these are computed.

    Raises
    ------
    ParameterError
        If a method is asked for that is made for η = 0 alone.
    CostError
        If the collision is too stiff or switches more often than `MOST_SWITCHES`.
    """
    samples = allowed("samples", samples, Samples)
    asked = chosen("columns", columns, COLUMNS)
    options, eta = options or Options(), parameters.damping
    # before its contact is prepared
    refuse_damping(options.method, eta)
    one = np.array([parameters.kappa]), np.array([parameters.psi])
    expected = float(expected_switch_counts(*one, eta)[0])
    if expected > FOLLOWED_SWITCHES:
        raise _too_many(f"about {expected:.1e}")
    collision = study_collision(parameters, options, episode_limit=episode_limit)
    path = followed_motion(parameters)
    switch_times = path.start[1:] if path else np.empty(0)
    if switch_times.size > MOST_SWITCHES:
        raise _too_many(f"{switch_times.size:,}")
    time = instants(contact_duration(eta), samples, switch_times)
    wanted = dict.fromkeys(c for c in COLUMNS if c in asked)
    compression, rate, cap = normal_curves(time, eta)
    values: dict[str, FloatArray | npt.NDArray[np.int8]] = {
        "time": time,
        "compression": compression,
        "compression_rate": rate,
        "normal_force": cap,
    }
    if not wanted.keys() <= values.keys():
        values |= _tangential(parameters, path, time, cap)
    own = _stepped(parameters, options) if collision.method == "timestep" else {}
    shown = {name: values[name] for name in wanted}
    return TraceStudy(collision, shown, switch_times, own, time)


def _too_many(switches: str) -> CostError:
    return CostError(
        f"this collision has {switches} switches; a trace shows at most {MOST_SWITCHES:,}. "
        "Ask for a softer one, or for /collision"
    )


def _stepped(parameters: CollisionParameters, options: Options) -> dict[str, FloatArray]:
    """Return the columns of a collision in time steps, named and signed as the exact ones."""
    psi = min(parameters.psi, np.finfo(float).max)
    time, force, velocity = stepped_course(
        parameters.kappa,
        psi,
        options.steps,
        options.integrator,
        options.phase,
        parameters.damping,
    )
    shown = np.arange(0, time.size, -(-time.size // MOST_STEPS))
    shown[-1] = time.size - 1
    time, force, velocity = time[shown], force[shown], velocity[shown]
    # a collision weaker than the one that was followed has proportionally weaker forces
    force = force * min(1.0, psi / max(psi, WEAKEST))
    with np.errstate(over="ignore"):
        velocity = parameters.gt_over_gn * (velocity / velocity[0])
    return {
        "method_time": time,
        "method_tangential_force_over_mu": 0.0 - force,
        "method_tangential_velocity": velocity,
    }


def _tangential(
    parameters: CollisionParameters, path: Motion | None, time: FloatArray, cap: FloatArray
) -> dict[str, FloatArray | npt.NDArray[np.int8]]:
    """Return the tangential columns at the instants `time` (N,), `cap` being x^{3/2} there."""
    columns, regime = tangential_columns(
        path,
        parameters.kappa,
        parameters.mu_over_alpha,
        parameters.gt_over_gn,
        parameters.damping,
        time,
        cap,
    )
    velocity, elongation, force, energy = columns
    return {
        "tangential_velocity": velocity,
        "spring_elongation": elongation,
        "tangential_force_over_mu": force,
        "regime": regime,
        "tangential_energy": energy,
    }
