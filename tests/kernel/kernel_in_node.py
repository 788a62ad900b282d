"""What the kernel in the page answers, in Node, and the native one."""

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "tests" / "frontend" / "kernel" / "answer.js"


def answers(calls: list[list[Any]]) -> list[Any]:
    """Return what the calls of frontend/kernel/kernel.js give, each a name and its arguments."""
    written = json.dumps(calls)
    done = subprocess.run(
        [Path(sys.executable).with_name("node"), SCRIPT],
        input=written,
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def collision(kappa: float, psi: float, damping: float = 0.0) -> dict[str, float]:
    """Return the parameters of a collision, of μ/α = 1 but where ψ is infinite."""
    given = {"mu_over_alpha": 1.0, "gt_over_gn": float(psi)}
    if psi == math.inf:
        given = {"mu_over_alpha": 0.0, "gt_over_gn": 1.0}
    return {"kappa": float(kappa), **given, "damping": float(damping)}


def column(found: list[dict[str, Any]], name: str) -> np.ndarray:
    return np.array([each[name] for each in found])


def random_states(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return κ, ψ and η; every other collision is undamped."""
    random = np.random.default_rng(seed)
    kappa = 10 ** random.uniform(-2, 4, count)
    psi = 10 ** random.uniform(-5, 0.8, count)
    damping = 10 ** random.uniform(-6, 3, count)
    damping[::2] = 0.0
    return kappa, psi, damping
