"""Material and impact to ε_t, against the same collision integrated in metres and seconds."""

import math

import numpy as np
import pytest
from real_spheres import integrate, laws

from restitution.studies.spheres.bodies import Moment, Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Velocities


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


def differences(count, seed, *, damped):
    """Return the differences of ε_t and ε_n over random collisions, and their switches.

    Rows (count,) of |Δε_t|, |Δε_n|, switches here, switches of the integration.
    """
    rng = np.random.default_rng(seed)
    rows = []
    for _ in range(count):
        bodies = random_body(rng), random_body(rng)
        friction, g_n = rng.uniform(0.02, 1.0), 10 ** rng.uniform(-3, 1.5)
        mass, alpha, hertz = laws(bodies)
        depth = (1.25 * mass * g_n**2 / hertz) ** 0.4
        # around the stiffness of the normal contact, as Mindlin's is
        stiffness = 10 ** rng.uniform(-1, 1.5) * 1.5 * hertz * math.sqrt(depth)
        g_t = 10 ** rng.uniform(-1.3, 0.5) * friction / alpha * g_n
        # A of about 1/1000 of the contact's duration to as long as it: ε_n 0.99…0.3
        dissipation = 10 ** rng.uniform(-2.5, 0) * depth / g_n if damped else 0.0
        epsilon_t, epsilon_n, switches = integrate(
            mass, alpha, hertz, friction, stiffness, g_n, g_t, dissipation
        )
        contact = Contact(
            *(
                Sphere(
                    b["radius"],
                    b["young"],
                    b["poisson"],
                    mass_kg=b["mass"],
                    inertia=Moment(b["moment"]),
                )
                for b in bodies
            ),
            friction,
            stiffness,
            dissipation,
        )
        study = study_scaling(contact, Velocities(g_n, g_t))
        rows.append(
            (
                abs(study.epsilon_t - epsilon_t),
                abs(study.epsilon_n - epsilon_n),
                study.switches,
                switches,
            )
        )
    return np.array(rows).T


def judge(off, normally_off, switches, integrated):
    worst, worst_normal = off.max(), normally_off.max()
    print(f"ε_t within {worst:.1e}, ε_n within {worst_normal:.1e}, {switches.max():.0f} switches")
    # the integration's own error; it falls with its tolerance
    assert worst < 1e-8
    assert worst_normal < 1e-12
    np.testing.assert_array_equal(switches, integrated)
    # beyond those that every collision has, the one with damping
    assert np.mean(switches > 1) > 0.5


@pytest.mark.parametrize("damped", [False, True])
def test_random_spheres_agree_with_their_integration_in_si_units(damped):
    judge(*differences(10, seed=1, damped=damped))


@pytest.mark.verify
@pytest.mark.parametrize("damped", [False, True])
def test_a_thousand_random_spheres_agree_with_their_integration_in_si_units(damped):
    judge(*differences(1000, seed=2, damped=damped))
