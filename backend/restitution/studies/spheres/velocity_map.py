"""ε_t of real bodies over normal and tangential velocity in m/s: the paper's Figs. 1 and 2."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from restitution.bounds import Misfit, values
from restitution.errors import ParameterError
from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.dampings import refuse_more_dampings
from restitution.studies.collision.many import BatchStudy, study_batch
from restitution.studies.collision.parameters import CONVENTION
from restitution.studies.spheres.contact import (
    SMALLEST,
    Contact,
    friction_over_alpha,
    scales,
    velocity_ratio,
)
from restitution.studies.tabular import Table, Tabular

OF_NORMAL_VELOCITY = (
    "kappa",
    "damping",
    "time_scale_s",
    "length_scale_m",
    "contact_duration_s",
    "maximum_compression_m",
)
"""What depends on the normal velocity alone; as of ``POST /scaling``."""


@dataclass(frozen=True)
class VelocityMap(Tabular):
    """A map over both velocities.

    Attributes
    ----------
    normal_velocity_m_s : ndarray, shape (n,)
    tangential_velocity_m_s : ndarray, shape (k,)
    mu_over_alpha : float
    scales : dict of str to ndarray, shape (n,)
        What depends on the normal velocity alone, as κ and the duration of the contact.
    batch : BatchStudy
        Columns of length k n, the normal velocity fastest.

    Examples
    --------
    >>> import restitution as rs
    >>> steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    >>> found = rs.Contact(steel, steel, 0.4, 1e7).map(Axis(1, 20, 6), Axis(0, 10, 5))
    >>> found.to_xarray().epsilon_t.shape
    (5, 6)
    """

    normal_velocity_m_s: FloatArray
    tangential_velocity_m_s: FloatArray
    mu_over_alpha: float
    scales: dict[str, FloatArray]
    batch: BatchStudy

    def table(self) -> Table:
        """Return the quantities over both velocities."""
        edges = {
            "tangential_velocity_m_s": self.tangential_velocity_m_s,
            "normal_velocity_m_s": self.normal_velocity_m_s,
        }
        return Table(
            edges,
            self.batch.found(tuple(values.size for values in edges.values())),
            self.scales | {"mu_over_alpha": np.array(self.mu_over_alpha)},
            {"convention": CONVENTION},
        )


def one_velocity_missing(given: Mapping[str, Any]) -> Iterator[Misfit]:
    """Yield that a normal restitution holds at one velocity, of which a map has many."""
    if given.get("normal_restitution") is not None and given.get("at_normal_velocity_m_s") is None:
        yield (
            "at_normal_velocity_m_s",
            "given beside normal_restitution, which holds at one velocity",
        )


def study_velocity_map(
    contact: Contact,
    normal_velocity: Axis,
    tangential_velocity: Axis,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    options: Options | None = None,
) -> VelocityMap:
    """Return a map of a contact over its velocities in m/s.

    Parameters
    ----------
    contact : Contact
        Bodies, friction, stiffness.
    normal_velocity, tangential_velocity : Axis
        Positive, and 0 or more.
    quantities : collection of str, optional
        Of `many.QUANTITIES`.
    options : Options, optional
        Method and tolerance.

    Raises
    ------
    ParameterError
        If a range is empty or a quantity is beyond double precision.
    CostError
        If it takes too many different dampings, or following too many switches.
    """
    normal = normal_velocity.values(positive=True)
    tangential = tangential_velocity.values(positive=False)
    for name, words in one_velocity_missing(values(contact)):
        raise ParameterError(name, None, words)
    if contact.is_damped:
        # η goes with g_n^{1/5}; before the scales, which take ten times as long as the motions
        refuse_more_dampings(normal.size)
    steps = [scales(contact, g_n) for g_n in normal.tolist()]
    columns = {name: np.array([getattr(at, name) for at in steps]) for name in OF_NORMAL_VELOCITY}
    friction = friction_over_alpha(contact.friction_coefficient, contact.pair.alpha)
    # the largest ratio of all, refused if it overflows
    velocity_ratio(float(tangential[-1]), float(normal[0]))
    ratios = tangential[:, None] / normal
    ratios[(ratios == 0.0) & (tangential > 0.0)[:, None]] = SMALLEST
    kappas, dampings = (
        np.broadcast_to(columns[name], ratios.shape).ravel() for name in ("kappa", "damping")
    )
    batch = study_batch(kappas, friction, ratios.ravel(), quantities, options, dampings)
    return VelocityMap(normal, tangential, friction, columns, batch)
