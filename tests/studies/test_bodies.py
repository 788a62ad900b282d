"""Two bodies as one collision sees them: inertia, walls."""

import pytest

from restitution.errors import ParameterError
from restitution.studies.spheres.bodies import Moment, Sphere, Wall, pair

GLASS = Sphere(0.0031, 6.9e10, 0.24, mass_kg=3e-4, inertia=Moment(1.4e-9))


@pytest.mark.parametrize(
    ("inertia", "alpha"),
    [("solid", 2 / 7), ("hollow", 2 / 5), (Moment(0.5 * 0.02**2 * 3.0), 1 / 3)],
)
def test_alpha_of_a_sphere_on_a_wall_is_that_of_two_equal_spheres(inertia, alpha):
    body = Sphere(0.02, 1e9, 0.3, mass_kg=3.0, inertia=inertia)
    wall = Wall(1e10, 0.2)
    for first, second in ((body, body), (body, wall), (wall, body)):
        assert pair(first, second).alpha == pytest.approx(alpha, rel=1e-14)


def test_wall_is_the_limit_of_a_large_sphere():
    wall = pair(GLASS, Wall(2e11, 0.28))
    # Eqs. 12 and 18 differ by R₁/R₂ and m₁/m₂
    large = pair(GLASS, Sphere(1e10, 2e11, 0.28, mass_kg=1e10))
    for name in ("alpha", "effective_mass_kg", "effective_radius_m", "effective_modulus_pa"):
        assert getattr(large, name) == pytest.approx(getattr(wall, name), rel=1e-11), name


def test_two_walls_are_refused():
    with pytest.raises(ParameterError, match="sphere"):
        pair(Wall(1e10, 0.2), Wall(1e10, 0.2))
