"""One collision by laws that the model does not have, in plain time steps; scaled as the model is.

What stands here is what docs/model.md says of other codes, and nothing of the package: a solid
sphere without spin, α = 2/7, μ/α = 1.4, whose tangential spring has at the largest compression the
stiffness κ that Mindlin's has for ν = 0.3.
"""

import math

ALPHA = 2.0 / 7.0
FRICTION = 1.4
"""μ/α."""

KAPPA = 4.520853
STEPS = 20_000
DURATION = 3.2180654597190431
DEEPEST = 1.25**0.4
HARDEST = 1.25**0.6
"""Largest compression and force of an elastic Hertz contact."""


def hertz(x):
    return x**1.5


def hooke(x):
    """Return the force of a linear spring whose contact lasts as long as Hertz's."""
    return (math.pi / DURATION) ** 2 * x


def constant(_):
    return 1.0


def as_the_area(x):
    """Return Mindlin's stiffness, 8G*a with a ∝ √x, over that at the largest compression."""
    return math.sqrt(x / DEEPEST)


def tsuji(normal_restitution):
    """Return the tangential dashpot that goes with a coefficient of normal restitution.

    γ_t = 2√(5/6) β √(k_t m_eff) with β = −ln e/√(π² + ln² e), over α m_eff/t_scale.
    """
    log = -math.log(normal_restitution)
    return 2.0 * math.sqrt(5.0 / 6.0) * log / math.hypot(math.pi, log) * math.sqrt(KAPPA / ALPHA)


def epsilon_t(
    psi,
    *,
    normal=hertz,
    softness=constant,
    summed=False,
    rescaled=False,
    dashpot=0.0,
    rolling=0.0,
    adhesion=0.0,
    kappa=KAPPA,
):
    """Return ε_t.

    Parameters
    ----------
    psi : float
        (α/μ)(g_t/g_n).
    normal, softness : callable
        Normal force, and tangential stiffness over `kappa`, of the compression.
    summed : bool
        Whether the force of the spring is summed up, dF = k dz, instead of F = k z.
    rescaled : bool
        Whether it falls with the radius of the contact while that shrinks.
    dashpot : float
        γ_t t_scale/(α m_eff); the force of spring and dashpot together is capped.
    rolling : float
        Coefficient of rolling friction on a wall: a torque of so much times R F_n against the spin.
    adhesion : float
        Pull of a DMT contact, with which the cap is μ(F_n + 2 · pull).
    """
    dt = DURATION / STEPS
    x, rate, before = 0.0, 1.0, 0.0
    start = velocity = FRICTION * psi
    force = spring = spin = 0.0
    while True:
        pressed = normal(x) - (adhesion if x > 0.0 else 0.0)
        rate -= dt * pressed
        x += dt * rate
        if x <= 0.0:
            return velocity / start
        if rescaled and x < before:
            spring *= math.sqrt(x / before)
            force *= math.sqrt(x / before)
        before = x
        stiffness = kappa * softness(x)
        spring += dt * velocity
        force = force + dt * stiffness * velocity if summed else stiffness * spring
        pressed = normal(x) - adhesion
        cap = FRICTION * (pressed + 2.0 * adhesion)
        total = min(max(force + dashpot * velocity, -cap), cap)
        if abs(force + dashpot * velocity) > cap:
            force = total - dashpot * velocity
            spring = force / stiffness
        # the torque of friction on the spin is (1 − α)/α times its force on the centre
        against = rolling * (1.0 - ALPHA) / ALPHA * pressed
        turned = spin + dt * ((1.0 - ALPHA) * total - math.copysign(against, spin))
        velocity -= dt * total - (dt * math.copysign(against, spin) if spin else 0.0)
        spin = turned if spin else dt * (1.0 - ALPHA) * total
