"""Fixed time steps, the way of codes of discrete elements."""

from restitution.errors import CostError
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.stepping import most_steps, step_collisions
from restitution.methods.answer import Answer
from restitution.methods.measured import measured
from restitution.methods.options import Options

MOST_STEPS = 4_000_000_000
"""Steps of one request: a second or two of one core, at 0.3 ns for a step of one of many."""


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t and switches of collisions (N,) by `options.steps` steps of `integrator`.

    The error is measured: the distance to the exact ε_t and its own bound. Steps longer than
    2/√κ are unstable; ε_t is then finite, of any size, and its error says so. Cost: 0.3 ns for a
    step where many collisions share the normal motion, 12 ns for one alone, and the exact ones.

    Raises
    ------
    CostError
        If the collisions may take too many steps together.
    """
    # a contact that is strongly damped takes all of these
    cost = most_steps(options.steps) * kappa.size
    if cost > MOST_STEPS * options.share:
        raise CostError(
            f"{kappa.size:,} collisions of {options.steps:,} steps may take {cost:.3g} steps; the "
            f"limit is {MOST_STEPS * options.share:.3g}. Ask for fewer collisions or fewer steps"
        )
    stepped = step_collisions(
        kappa, psi, options.steps, options.integrator, options.phase, damping=options.damping
    )
    return measured(kappa, psi, stepped.epsilon_t, options, stepped.switches)
