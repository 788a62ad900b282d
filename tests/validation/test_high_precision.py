"""Fresh collisions in 100 digits: about three minutes on one core."""

import high_precision
import numpy as np
import pytest

from restitution.mechanics.collision import collide


@pytest.mark.verify
@pytest.mark.parametrize("seed", range(4))
def test_fresh_collisions_agree_with_an_independent_solver(seed):
    rng = np.random.default_rng([2026, seed])
    for _ in range(100):
        kappa, psi = 10 ** rng.uniform(-3, 3.5), 10 ** rng.uniform(-3, 0.35)
        exact = high_precision.collide(repr(kappa), repr(psi))
        ours = collide(kappa, psi)
        assert abs(ours.epsilon_t - float(exact.epsilon_t)) <= ours.error_bound, (kappa, psi)
        if exact.nearest_grazing > 1e-10:
            assert ours.switches == exact.switches, (kappa, psi)
