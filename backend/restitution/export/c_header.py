"""A table as a C header (C99 and C++) that needs nothing but math.h."""

from string import Template

from restitution.export.layout import description, numbers, rows
from restitution.studies.table_export import RestitutionTable

_HEADER = Template("""\
/*
$description
 */
#ifndef RESTITUTION_TABLE_H
#define RESTITUTION_TABLE_H

#include <math.h>

#define RESTITUTION_KAPPA_COUNT $kappa_count
#define RESTITUTION_PSI_COUNT $psi_count
#define RESTITUTION_LARGEST_ERROR $largest_error

static const double restitution_entries[RESTITUTION_PSI_COUNT][RESTITUTION_KAPPA_COUNT] = {
$rows
};

/* Bilinear interpolation; NAN where the table says nothing. */
static inline double restitution_epsilon_t(double kappa, double psi)
{
    double along, across, left, right;
    int i, j;
    if (!(kappa >= $kappa_minimum && kappa <= $kappa_maximum && psi >= 0.0))
        return NAN;
    if (psi > $psi_maximum)
        return $beyond;
    if (psi < $psi_minimum)
        psi = $psi_minimum;
    along = ($kappa_coordinate - ($kappa_first)) / $kappa_step;
    across = ($psi_coordinate - ($psi_first)) / $psi_step;
    i = along < 1.0 ? 0 : (int)along;
    j = across < 1.0 ? 0 : (int)across;
    if (i > RESTITUTION_KAPPA_COUNT - 2)
        i = RESTITUTION_KAPPA_COUNT - 2;
    if (j > RESTITUTION_PSI_COUNT - 2)
        j = RESTITUTION_PSI_COUNT - 2;
    along -= i;
    across -= j;
    left = (1.0 - across) * restitution_entries[j][i] + across * restitution_entries[j + 1][i];
    right = (1.0 - across) * restitution_entries[j][i + 1]
            + across * restitution_entries[j + 1][i + 1];
    return (1.0 - along) * left + along * right;
}

#endif
""")


def c_header(table: RestitutionTable) -> str:
    """Return the table and its interpolation in C."""
    return _HEADER.substitute(
        numbers(table, "log", "NAN"),
        description="\n".join(f" * {line}" for line in description(table)),
        rows=",\n".join(f"    {{{row}}}" for row in rows(table)),
    )
