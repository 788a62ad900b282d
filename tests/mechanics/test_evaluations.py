"""How often the equations are evaluated until a switch is found, counted in interpreted kernels."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

from cases import every_day
from restitution.mechanics.collision import MOST_SWITCHES, expected_switch_counts

COUNT = """
import json, sys, warnings
import numpy as np
from restitution.mechanics import collision, contact

# overflow and division by zero, which compiled kernels pass over, too
warnings.simplefilter("ignore")
evaluations = 0

def note(frame, event, _):
    global evaluations
    evaluations += event == "call" and frame.f_code.co_name in {"normal_motion", "damped_motion"}

found = []
for kappa, psi, damping in json.load(sys.stdin):
    given = contact.contact_of(damping), float(collision.MOST_SWITCHES), kappa, psi
    nothing = np.empty(0, collision.EPISODE)
    evaluations = 0
    sys.setprofile(note)
    _, switches, _, _ = collision._collide_one(*given, nothing)
    sys.setprofile(None)
    found.append((evaluations, int(switches)))
json.dump(found, sys.stdout)
"""

ENDS = (5e-324, 1e-300, 1e-100, 1e-16, 0.57, 1.57, 2.0, 1e3, 1e16, 1e100, 1e300, 1.797e308)
PSIS = (5e-324, 1e-300, 1e-100, 1e-6, 0.5, 1.9999999999999998, 2.0, 1e16, 1.797e308)
DAMPINGS = (0.0, 5e-324, 1e-100, 1e-20, 0.3, 1e30)
ORDINARY = [(0.1 * 7**i, 0.01 * 3**j) for i in range(5) for j in range(6)]


def counted(collisions):
    """Return the evaluations and the switches of collisions (κ, ψ, η)."""
    run = subprocess.run(
        [sys.executable, "-c", COUNT],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        input=json.dumps(collisions),
        check=True,
        capture_output=True,
        text=True,
    )
    return json.loads(run.stdout)


@pytest.mark.parametrize("damping", every_day([0.0, 1e-20, 1e30], of=DAMPINGS))
def test_extremes_take_no_more_evaluations_than_their_predicted_cost_allows(damping):
    """Ordinary ones take 5, with damping 20 for each switch that is expected."""
    pairs = [(kappa, psi) for kappa in ENDS for psi in PSIS]
    found = counted([(kappa, psi, damping) for kappa, psi in pairs])
    expected = [expected_switch_counts(*np.atleast_1d(k, p), damping)[0] for k, p in pairs]
    shares = [
        evaluations / switches
        for (evaluations, _), switches in zip(found, expected, strict=True)
        if switches <= MOST_SWITCHES
    ]
    assert max(shares) <= (60.0 if damping else 16.0)


@pytest.mark.parametrize(("damping", "most"), [(0.0, 8.0), (0.3, 28.0)])
def test_ordinary_collisions_take_few_evaluations_for_a_switch(damping, most):
    found = counted([(kappa, psi, damping) for kappa, psi in ORDINARY])
    assert sum(switches > 1 for _, switches in found) >= 10
    assert max(evaluations / (switches + 2) for evaluations, switches in found) <= most
