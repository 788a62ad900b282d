"""Collisions followed one after the other, which is what lanes are held against."""

import numpy as np

from restitution.mechanics.collision import EPISODE, _collide_one
from restitution.mechanics.compiled import compiled


@compiled
def collide_each(contact, most_switches, kappa, psi, epsilon_t, switches, certain, bound):
    """Fill the last four arrays (N,) for κ and ψ (N,)."""
    nothing = np.empty(0, dtype=EPISODE)
    for i in range(kappa.size):
        epsilon_t[i], switches[i], certain[i], bound[i] = _collide_one(
            contact, most_switches, kappa[i], psi[i], nothing
        )
