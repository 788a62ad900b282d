"""A table as a C header (C99 and C++) that needs nothing but math.h."""

from string import Template

from restitution.export.layout import description, numbers, rows
from restitution.studies.tables.export import RestitutionTable

_HEADER = Template("""\
/*
$description
 */
#ifndef RESTITUTION_TABLE_H
#define RESTITUTION_TABLE_H

#include <math.h>

#define RESTITUTION_KAPPA_COUNT $kappa_count
#define RESTITUTION_PSI_COUNT $psi_count
#define RESTITUTION_DAMPING_COUNT $damping_count
#define RESTITUTION_LARGEST_ERROR $largest_error
#define RESTITUTION_ERROR_BASIS "$error_basis"

typedef double restitution_row[RESTITUTION_KAPPA_COUNT];

static const restitution_row
restitution_entries[RESTITUTION_DAMPING_COUNT][RESTITUTION_PSI_COUNT] = {
$planes
};

static inline int restitution_cell(double place, int count)
{
    int i = place < 1.0 ? 0 : (int)place;
    return i > count - 2 ? count - 2 : i;
}

static inline double
restitution_within(const restitution_row *cell, int i, double along, double across)
{
    double left = (1.0 - across) * cell[0][i] + across * cell[1][i];
    double right = (1.0 - across) * cell[0][i + 1] + across * cell[1][i + 1];
    return (1.0 - along) * left + along * right;
}

/* Linear interpolation along every axis; NAN where the table says nothing. */
static inline double restitution_epsilon_t(double kappa, double psi$damping_parameter)
{
    double along, across$through;
    int i, j$k;
    if (!(kappa >= $kappa_minimum && kappa <= $kappa_maximum && psi >= 0.0))
        return NAN;
$outside    if (psi > $psi_maximum)
        return $beyond;
    if (psi < $psi_minimum)
        psi = $psi_minimum;
    along = ($kappa_coordinate - ($kappa_first)) / $kappa_step;
    across = ($psi_coordinate - ($psi_first)) / $psi_step;
    i = restitution_cell(along, RESTITUTION_KAPPA_COUNT);
    j = restitution_cell(across, RESTITUTION_PSI_COUNT);
    along -= i;
    across -= j;
$interpolated}

#endif
""")

_PLANE = """\
    return restitution_within(restitution_entries[0] + j, i, along, across);
"""

_OUTSIDE = Template("""\
    if (!(damping >= $damping_minimum && damping <= $damping_maximum))
        return NAN;
""")

_PLANES = Template("""\
    through = ($damping_coordinate - ($damping_first)) / $damping_step;
    k = restitution_cell(through, RESTITUTION_DAMPING_COUNT);
    through -= k;
    return (1.0 - through) * restitution_within(restitution_entries[k] + j, i, along, across)
            + through * restitution_within(restitution_entries[k + 1] + j, i, along, across);
""")


def c_header(table: RestitutionTable) -> str:
    """Return the table and its interpolation in C."""
    filled = numbers(table, "log", "NAN")
    third = "damping" in table.axes
    planes = [",\n".join(f"    {{{row}}}" for row in plane) for plane in rows(table)]
    return _HEADER.substitute(
        filled,
        description="\n".join(f" * {line}" for line in description(table)),
        planes=",\n".join(f"  {{\n{plane}\n  }}" for plane in planes),
        damping_parameter=", double damping" if third else "",
        through=", through" if third else "",
        k=", k" if third else "",
        outside=_OUTSIDE.substitute(filled) if third else "",
        interpolated=_PLANES.substitute(filled) if third else _PLANE,
    )
