"""A table as a Python module that needs nothing but the standard library."""

from string import Template

from restitution.export.layout import description, numbers, rows
from restitution.studies.tables.export import RestitutionTable

_MODULE = Template('''\
"""$description
"""

import math
from array import array

KAPPA_COUNT, PSI_COUNT, DAMPING_COUNT = $kappa_count, $psi_count, $damping_count
LARGEST_ERROR, ERROR_BASIS = $largest_error, "$error_basis"

# one line for each psi, kappa fastest$slowest
ENTRIES = array("d", [
$rows
])


def epsilon_t(kappa, psi$damping_parameter):
    """Return the coefficient of tangential restitution; NaN where the table says nothing."""
    if not ($kappa_minimum <= kappa <= $kappa_maximum and psi >= 0.0):
        return math.nan
$outside    if psi > $psi_maximum:
        return $beyond
    psi = max(psi, $psi_minimum)
    along = ($kappa_coordinate - ($kappa_first)) / $kappa_step
    across = ($psi_coordinate - ($psi_first)) / $psi_step
    i, j = _cell(along, KAPPA_COUNT), _cell(across, PSI_COUNT)
$interpolated

def _cell(place, count):
    return min(max(int(place), 0), count - 2)


def _within(below, along, across):
    above = below + KAPPA_COUNT
    left = (1.0 - across) * ENTRIES[below] + across * ENTRIES[above]
    right = (1.0 - across) * ENTRIES[below + 1] + across * ENTRIES[above + 1]
    return (1.0 - along) * left + along * right
''')

_PLANE = """\
    return _within(j * KAPPA_COUNT + i, along - i, across - j)
"""

_OUTSIDE = Template("""\
    if not $damping_minimum <= damping <= $damping_maximum:
        return math.nan
""")

_PLANES = Template("""\
    through = ($damping_coordinate - ($damping_first)) / $damping_step
    k = _cell(through, DAMPING_COUNT)
    near, far = (
        _within((plane * PSI_COUNT + j) * KAPPA_COUNT + i, along - i, across - j)
        for plane in (k, k + 1)
    )
    return (1.0 - (through - k)) * near + (through - k) * far
""")


def python_module(table: RestitutionTable) -> str:
    """Return the table and its interpolation in Python."""
    filled = numbers(table, "math.log", "math.nan")
    third = "damping" in table.axes
    return _MODULE.substitute(
        filled,
        description="\n".join(description(table)),
        rows="\n".join(f"    {row}," for plane in rows(table) for row in plane),
        slowest=", damping slowest" if third else "",
        damping_parameter=", damping" if third else "",
        outside=_OUTSIDE.substitute(filled) if third else "",
        interpolated=_PLANES.substitute(filled) if third else _PLANE,
    )
