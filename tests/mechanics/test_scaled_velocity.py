"""ψ from the ratios of velocities, over the whole double range."""

import numpy as np

from restitution.mechanics.scaled_velocity import scaled_velocity


def test_scaled_velocity_is_formed_at_the_edges_of_the_double_range():
    assert scaled_velocity(0.0, 0.0) == np.inf
    assert scaled_velocity(1.0, 0.0) == 0.0
    assert scaled_velocity(1e-300, 1e300) == np.inf
    assert scaled_velocity(1e300, 1e-300) == 5e-324
    assert scaled_velocity(5e-324, 5e-324) == 1.0
    assert scaled_velocity([0.0, 2.0], [[1.0], [3.0]]).tolist() == [[np.inf, 0.5], [np.inf, 1.5]]
