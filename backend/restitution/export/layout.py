"""What a table says in every language: where its entries are, how good it is, which sign it has."""

import math
from dataclasses import dataclass

from restitution.studies.collision.axis import Axis
from restitution.studies.tables.export import RestitutionTable
from restitution.studies.tables.grid import DIGITS
from restitution.studies.tables.largest_error import BASES

SIGNS = {
    "paper": "g_t(t_c)/g_t(0) at the contact point: +1 smooth spheres, -1 gear wheels",
    "reversed": "-g_t(t_c)/g_t(0) at the contact point: -1 smooth spheres, +1 gear wheels",
}
ETA = "; eta = (3/2) A beta^(2/5) g_n^(1/5)."


@dataclass(frozen=True)
class Edge:
    """An axis in the coordinate in which its values are equidistant."""

    logarithmic: bool
    first: float
    step: float


def edge(axis: Axis) -> Edge:
    """Return an axis in its coordinate, the value itself or its natural logarithm."""
    logarithmic = axis.scale == "log"
    low, high = axis.minimum, axis.maximum
    if logarithmic:
        low, high = math.log(low), math.log(high)
    return Edge(logarithmic, low, (high - low) / (axis.count - 1))


def numbers(table: RestitutionTable, logarithm: str, not_a_number: str) -> dict[str, str]:
    """Return what fills a template of either language, given its words.

    Its decimals are those of Python's ``repr``, which C reads as the same doubles.
    """
    filled = {
        "kappa_count": str(table.kappa.count),
        "psi_count": str(table.psi.count),
        "damping_count": str(table.axes["damping"].count if "damping" in table.axes else 1),
        # rounded up
        "largest_error": f"{1.0005 * table.largest_error:.3e}",
        "error_basis": table.error_basis,
        "beyond": "1.0 - 2.0 / psi" if table.sign == "paper" else "2.0 / psi - 1.0",
    }
    if math.isnan(table.slides_above):
        filled["beyond"] = not_a_number
    for name, axis in table.axes.items():
        at = edge(axis)
        filled |= {
            f"{name}_minimum": repr(float(axis.minimum)),
            f"{name}_maximum": repr(float(axis.maximum)),
            f"{name}_coordinate": f"{logarithm}({name})" if at.logarithmic else name,
            f"{name}_first": repr(float(at.first)),
            f"{name}_step": repr(at.step),
        }
    return filled


def rows(table: RestitutionTable) -> list[list[str]]:
    """Return for each η and each ψ the entries, κ fastest, as comma-separated decimals."""
    planes = table.epsilon_t.reshape(-1, table.psi.count, table.kappa.count)
    return [
        [", ".join(f"{entry:.{DIGITS}f}".rstrip("0").rstrip(".") for entry in row) for row in plane]
        for plane in planes.tolist()
    ]


def description(table: RestitutionTable) -> list[str]:
    """Return what a reader of the table must know, line by line."""
    kappa, psi = table.kappa, table.psi
    if math.isnan(table.slides_above):
        above = "not a number above psi = {0:g}, where the table ends"
    else:
        above = "1 - 2/psi, exact, above psi = {0:g}"
    outside = "kappa outside its range gives"
    if not table.damped:
        contact, eta = "without viscous damping", []
    elif isinstance(table.damping, Axis):
        third = table.damping
        contact, outside = "with viscous damping", "kappa and eta outside their ranges give"
        span = f"from {third.minimum:g} to {third.maximum:g} ({third.scale})"
        eta = [f"{third.count} values of eta {span},"]
    else:
        contact, eta = f"with viscous damping eta = {table.damping!r}", []
    linear = "trilinear" if eta else "bilinear"
    return [
        f"Coefficient of tangential restitution of frictional spheres {contact},",
        "after Schwager, Becker & Poeschel, Eur. Phys. J. E 27, 107 (2008).",
        f"Sign: {SIGNS[table.sign]}.",
        "kappa = k_t / (alpha m_eff beta^(4/5) g_n^(2/5)), with alpha in it (Eq. 24);",
        f"psi = (alpha/mu) (g_t/g_n){ETA if table.damped else '.'}",
        *eta,
        f"{psi.count} values of psi from {psi.minimum:g} to {psi.maximum:g} ({psi.scale}),",
        f"{kappa.count} of kappa from {kappa.minimum:g} to {kappa.maximum:g} ({kappa.scale}).",
        f"Largest error of {linear} interpolation within them: {1.0005 * table.largest_error:.3e}",
        f"({table.error_basis}: {BASES[table.error_basis]}).",
        f"Below psi = {psi.minimum:g} the value at {psi.minimum:g} stands, without that statement;",
        f"{above.format(psi.maximum)};",
        f"{outside} not a number.",
    ]
