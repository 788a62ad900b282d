"""Material and impact to ε_t, against the same collision integrated in metres and seconds."""

import math

import numpy as np
import pytest
from real_spheres import integrate, laws

from restitution.studies.bodies import Sphere
from restitution.studies.scaling import Contact
from restitution.studies.spheres import Velocities, study_scaling


def random_body(rng):
    radius, density = 10 ** rng.uniform(-4, 0), rng.uniform(500, 2e4)
    mass = 4 / 3 * math.pi * radius**3 * density
    return {
        "radius": radius,
        "mass": mass,
        "moment": rng.uniform(0.2, 2 / 3) * mass * radius**2,
        "young": 10 ** rng.uniform(6, 12),
        "poisson": rng.uniform(-0.3, 0.5),
    }


def largest_difference(count, seed):
    """Return the largest difference of ε_t over random collisions, and how many switched."""
    rng = np.random.default_rng(seed)
    worst, switched = 0.0, 0
    for _ in range(count):
        bodies = random_body(rng), random_body(rng)
        friction, g_n = rng.uniform(0.02, 1.0), 10 ** rng.uniform(-3, 1.5)
        mass, alpha, hertz = laws(bodies)
        depth = (1.25 * mass * g_n**2 / hertz) ** 0.4
        # around the stiffness of the normal contact, as Mindlin's is
        stiffness = 10 ** rng.uniform(-1, 1.5) * 1.5 * hertz * math.sqrt(depth)
        g_t = 10 ** rng.uniform(-1.3, 0.5) * friction / alpha * g_n
        truth, switches = integrate(mass, alpha, hertz, friction, stiffness, g_n, g_t)
        contact = Contact(
            *(
                Sphere(
                    b["radius"], b["young"], b["poisson"], mass_kg=b["mass"], inertia=b["moment"]
                )
                for b in bodies
            ),
            friction,
            stiffness,
        )
        study = study_scaling(contact, Velocities(g_n, g_t))
        worst = max(worst, abs(study.epsilon_t - truth))
        switched += switches > 0
    return worst, switched


def test_random_spheres_agree_with_their_integration_in_si_units():
    worst, switched = largest_difference(40, seed=1)
    # the integration's own error; it falls with its tolerance
    assert worst < 1e-8
    assert switched > 20


@pytest.mark.verify
def test_a_thousand_random_spheres_agree_with_their_integration_in_si_units():
    worst, switched = largest_difference(1000, seed=2)
    print(f"largest difference {worst:.1e}, {switched} of 1000 switch")
    assert worst < 1e-8
