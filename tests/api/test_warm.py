"""What is prepared before the first request, and kept in the image."""

import subprocess
import sys

COUNT_WHAT_REQUESTS_COMPILE = """
import gc
from numba.core.dispatcher import Dispatcher
from starlette.testclient import TestClient
from restitution.api.app import create_app
from restitution.api.warm import warm, warm_rest

def made():
    kernels = (each for each in gc.get_objects() if isinstance(each, Dispatcher))
    return {f"{each.__module__}.{each.__name__}": len(each.signatures) for each in kernels}

collision = "kappa=18&mu_over_alpha=1.4&gt_over_gn=0.4"
cut = "along=kappa&mu_over_alpha=1.4&gt_over_gn=0.4"
map_ = "mu_over_alpha=1.4&kappa_count=20&gt_over_gn_count=20"
methods = ["auto", "exact", "table", "timestep", "ode", "stiff"]
paths = [f"steps?{collision}", "table?kappa_min=1&kappa_max=4&psi_min=.1&psi_max=1&error=.01"]
for damping in ("", "&damping=0.1"):
    paths += [f"collision?{collision}{damping}&method={method}" for method in methods]
    paths += [f"{call}{damping}" for call in (f"trace?{collision}", f"cut?{cut}", f"map?{map_}")]
    paths += [f"map?{map_}{damping}&tolerance=4e-3&quantities=epsilon_t"]
    paths += [f"map?{map_}{damping}&method=timestep&integrator=forward_euler"]
body = {"kappa": [18, 63], "mu_over_alpha": 1.4, "gt_over_gn": 1, "damping": [0, 0.1]}

warm()
warm_rest()
before = made()
client = TestClient(create_app())
answers = [client.get(f"/api/v1/{path}") for path in paths]
answers.append(client.post("/api/v1/collisions", json=body))
# a method that does not know damping says so
assert {answer.status_code for answer in answers} == {200, 422}
assert sum(answer.status_code == 422 for answer in answers) == 2, [a.text[:99] for a in answers]
print([kernel for kernel, count in made().items() if count != before.get(kernel, 0)])
"""


def test_no_request_needs_a_kernel_that_is_not_ready():
    run = subprocess.run(
        [sys.executable, "-c", COUNT_WHAT_REQUESTS_COMPILE],
        check=False,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr[-2000:]
    assert run.stdout.strip() == "[]"
