"""`import restitution` is light enough for a notebook or the job of a cluster."""

import subprocess
import sys

import pytest

OF_PYTHON_3_11 = {"typing_extensions"} if sys.version_info < (3, 12) else set()
ALONE = {"annotated_types", "numpy"} | OF_PYTHON_3_11

LIST = """
import sys
# what the environment loads at each start
before = set(sys.modules)
import restitution as rs
{}
roots = {{name.partition(".")[0] for name in sys.modules.keys() - before}}
# extensions of Cython put modules there that are in no file
roots = {{root for root in roots if getattr(sys.modules.get(root), "__file__", "")}}
print(*(root for root in roots - sys.stdlib_module_names if root[0] != "_"))
"""

CLASSES = """
steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
rs.Contact(steel, steel, 0.4, "mindlin")
rs.Options(method="table"), rs.Axis(1, 2, 3), rs.MATERIALS, rs.PRESETS, rs.tradeoff()
try:
    rs.epsilon_t(-1.0, 1.0, 1.0)
except rs.ParameterError:
    pass
"""


def run(script: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", script], check=False, capture_output=True, text=True
    )


@pytest.mark.parametrize("lines", ["", CLASSES], ids=["nothing", "classes"])
def test_nothing_but_numpy_is_loaded_until_something_is_computed(lines):
    done = run(LIST.format(lines))
    assert set(done.stdout.split()) == ALONE | {"restitution"}, done.stderr


COMPUTE_WITH = """
import importlib.abc, sys, sysconfig

# reads a module of Python's own that is on no list
sysconfig.get_config_vars()

class Others(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path, target=None):
        root = name.partition(".")[0]
        if root not in allowed | sys.stdlib_module_names:
            raise ModuleNotFoundError(name, name=root)

allowed = {allowed}

sys.meta_path.insert(0, Others())
import restitution as rs
rs.epsilon_t(18.0, 1.4, [2.8, 5.6]), rs.cut(63, 1.4, rs.Axis(0.01, 4, 5))
rs.collision(63.0, 1.4, 1.358, 0.1), rs.trace(63.0, 1.4, 1.358, method="timestep")
rs.table(rs.Axis(3, 6, 3), rs.Axis(0.1, 2, 3)), rs.steps(1e-2, 63, 1.4, 1.358)
contact = rs.Contact(rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850), rs.Wall(7e10, 0.3), 0.4, 1e9)
contact.impact(normal_velocity_m_s=1.0, tangential_velocity_m_s=0.5)
print("computed")
try:
    rs.collision(6, 1.4, 1.358, method="ode")
except ModuleNotFoundError as error:
    print(error.name)
allowed.add("scipy")
print(rs.collision(6, 1.4, 1.358, method="ode").method)
"""


def test_scipy_is_needed_for_the_general_solver_alone_and_no_other_package():
    allowed = ALONE | {"restitution", "numba", "llvmlite"}
    done = run(COMPUTE_WITH.format(allowed=allowed))
    assert done.stdout.split() == ["computed", "scipy", "ode"], done.stderr
