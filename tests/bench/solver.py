"""The same collision by a general solver of differential equations, with located events."""

import numpy as np
from scipy.integrate import solve_ivp

from restitution.mechanics.hertz import CONTACT_DURATION


def solve_with_events(kappa: float, psi: float, rtol: float = 1e-9) -> float:
    """Return ε_t from DOP853 on (x, ẋ, z, u), stopped and restarted at each switch.

    The normal motion is integrated along, as a general code would. Events are found by sign
    changes; at the end of sliding the double zero of the gap is stepped over by starting the
    sticking episode from the state of the cap.
    """

    def sliding(_: float, y: np.ndarray) -> list[float]:
        cap = max(y[0], 0.0) ** 1.5
        return [y[1], -cap, 1.5 * np.sqrt(max(y[0], 0.0)) * y[1] * side / kappa, -side * cap]

    def sticking(_: float, y: np.ndarray) -> list[float]:
        return [y[1], -(max(y[0], 0.0) ** 1.5), y[3], -kappa * y[2]]

    def stops(_: float, y: np.ndarray) -> float:
        return side * y[3] - 1.5 * np.sqrt(max(y[0], 0.0)) * y[1] / kappa

    def slips(_: float, y: np.ndarray) -> float:
        return max(y[0], 0.0) ** 1.5 - kappa * abs(y[2])

    stops.terminal = slips.terminal = True
    stops.direction = slips.direction = -1.0
    side, time, slide = 1.0, 0.0, True
    state = np.array([0.0, 1.0, 0.0, psi])
    while time < CONTACT_DURATION:
        solution = solve_ivp(
            sliding if slide else sticking,
            (time, CONTACT_DURATION),
            state,
            method="DOP853",
            events=stops if slide else slips,
            rtol=rtol,
            atol=1e-3 * rtol,
            max_step=0.2 if slide else min(0.2, 0.5 / np.sqrt(kappa)),
        )
        time, state = solution.t[-1], solution.y[:, -1].copy()
        if solution.status != 1:
            break
        slide = not slide
        if slide:
            side = np.sign(state[2])
        else:
            # a step into sticking, past the double zero of the gap
            step = 1e-6 * CONTACT_DURATION
            state = state + step * np.array(sticking(time, state))
            time += step
    return float(state[3] / psi)
