"""A table as a Python module that needs nothing but the standard library."""

from string import Template

from restitution.export.layout import description, numbers, rows
from restitution.studies.table_export import RestitutionTable

_MODULE = Template('''\
"""$description
"""

import math
from array import array

KAPPA_COUNT, PSI_COUNT = $kappa_count, $psi_count
LARGEST_ERROR = $largest_error

# one line for each psi, kappa fastest
ENTRIES = array("d", [
$rows
])


def epsilon_t(kappa, psi):
    """Return the coefficient of tangential restitution; NaN where the table says nothing."""
    if not ($kappa_minimum <= kappa <= $kappa_maximum and psi >= 0.0):
        return math.nan
    if psi > $psi_maximum:
        return $beyond
    psi = max(psi, $psi_minimum)
    along = ($kappa_coordinate - ($kappa_first)) / $kappa_step
    across = ($psi_coordinate - ($psi_first)) / $psi_step
    i = min(max(int(along), 0), KAPPA_COUNT - 2)
    j = min(max(int(across), 0), PSI_COUNT - 2)
    along -= i
    across -= j
    below, above = j * KAPPA_COUNT + i, (j + 1) * KAPPA_COUNT + i
    left = (1.0 - across) * ENTRIES[below] + across * ENTRIES[above]
    right = (1.0 - across) * ENTRIES[below + 1] + across * ENTRIES[above + 1]
    return (1.0 - along) * left + along * right
''')


def python_module(table: RestitutionTable) -> str:
    """Return the table and its interpolation in Python."""
    return _MODULE.substitute(
        numbers(table, "math.log", "math.nan"),
        description="\n".join(description(table)),
        rows="\n".join(f"    {row}," for row in rows(table)),
    )
