"""Coefficient of tangential restitution of frictional viscoelastic spheres.

What the service computes, in Python: the same names, the same bounds, the same numbers. Scaled
collisions are told by κ (Eq. 24, with α in it), μ/α, g_t/g_n at the point of contact and, with
damping, η = (3/2) A β^{2/5} g_n^{1/5}; collisions of real bodies by `Contact`, in SI units.
ε_t = g_t(t_c)/g_t(0): +1 for smooth spheres, −1 for gear wheels.

>>> import restitution as rs
>>> float(rs.epsilon_t(kappa=18, mu_over_alpha=1.4, gt_over_gn=5.6))
0.5
>>> rs.collision(kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358).switches
8
>>> steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
>>> contact = rs.Contact(steel, steel, 0.4, "mindlin")
>>> round(contact.impact(normal_velocity_m_s=1.0, tangential_velocity_m_s=0.5).kappa, 3)
4.521

Results have `to_pandas` and `to_xarray` (extra ``notebook``), and `explore` shows the page. A walk
through all of it is docs/python-walk.md.
"""

from restitution.errors import (
    CostError,
    ParameterError,
    RestitutionError,
    UnknownParameterError,
)
from restitution.methods.options import Options
from restitution.public.collisions import (
    collision,
    collisions,
    cut,
    epsilon_t,
    map,  # noqa: A004 - the name of the call
    trace,
)
from restitution.public.explore import Page, explore
from restitution.public.reports import paper_statements, steps, table, tradeoff, walton
from restitution.studies.accuracy.steps import StepsStudy
from restitution.studies.accuracy.tradeoff import Measurement
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.cut import CutStudy
from restitution.studies.collision.grid import GridStudy
from restitution.studies.collision.many import BatchStudy
from restitution.studies.collision.one import CollisionStudy
from restitution.studies.collision.presets import PRESETS, Preset
from restitution.studies.collision.trace import TraceStudy
from restitution.studies.spheres.bodies import Moment, Sphere, Wall
from restitution.studies.spheres.collision import ScalingStudy
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Impact, SpeedAndAngle, Velocities
from restitution.studies.spheres.materials import MATERIALS, Material
from restitution.studies.spheres.velocity_map import VelocityMap
from restitution.studies.spheres.walton import WaltonStudy
from restitution.studies.tables.export import RestitutionTable

__version__ = "0.1.0"

__all__ = [
    "MATERIALS",
    "PRESETS",
    "Axis",
    "BatchStudy",
    "CollisionStudy",
    "Contact",
    "CostError",
    "CutStudy",
    "GridStudy",
    "Impact",
    "Material",
    "Measurement",
    "Moment",
    "Options",
    "Page",
    "ParameterError",
    "Preset",
    "RestitutionError",
    "RestitutionTable",
    "ScalingStudy",
    "SpeedAndAngle",
    "Sphere",
    "StepsStudy",
    "TraceStudy",
    "UnknownParameterError",
    "Velocities",
    "VelocityMap",
    "Wall",
    "WaltonStudy",
    "collision",
    "collisions",
    "cut",
    "epsilon_t",
    "explore",
    "map",
    "paper_statements",
    "steps",
    "table",
    "trace",
    "tradeoff",
    "walton",
]
