"""The page at a state, in a notebook or in the browser."""

import difflib
import html
import sys
import urllib.parse
import webbrowser
from collections.abc import Sequence
from dataclasses import dataclass

from restitution.errors import ParameterError

COLLISION = ("kappa", "mu_over_alpha", "gt_over_gn", "damping", "alpha")
WAY = ("method", "integrator", "tolerance", "steps", "rtol")
SPHERES = (
    "material",
    "inertia",
    "normal_velocity_m_s",
    "tangential_velocity_m_s",
    "radius_m",
    "youngs_modulus_pa",
    "friction_coefficient",
    "tangential_stiffness_n_per_m",
    "dissipative_constant_s",
    "normal_restitution",
    *("density_kg_m3", "poisson_ratio", "second"),
    *("radius_2_m", "density_2_kg_m3", "youngs_modulus_2_pa", "poisson_ratio_2"),
)
PAGE = (
    *("scene", "step", "embed", "sliders", "theme", "lang", "notes", "handout", "face"),
    *("presenting", "left", "right"),
    *("map", "scale", "map_x", "map_y", "shape", "energy"),
    *("cut_x", "cut_y", "bounce", "spin_share", "pins", "sweep"),
    *("region", "statistic", "wanted_error", "velocity_law", "velocity_scale"),
    *("paper_verdict", "paper_kind"),
)
STATE = (*COLLISION, *WAY, *SPHERES, *PAGE)
"""What the address of the page may name, as frontend/state/address/ reads it."""


@dataclass(frozen=True)
class Page:
    """The page at an address; a notebook that is given it shows it in a frame.

    Attributes
    ----------
    url : str
        Its address.
    height : int
        Of the frame, in pixels.

    Examples
    --------
    >>> Page("http://127.0.0.1:8000/?kappa=63", 400)._repr_html_()[:45]
    '<iframe src="http://127.0.0.1:8000/?kappa=63"'
    """

    url: str
    height: int

    def _repr_html_(self) -> str:
        """Return the frame, as notebooks ask for it."""
        return (
            f'<iframe src="{html.escape(self.url)}" title="Restitution" width="100%" '
            f'height="{self.height}" style="border: 0" allow="fullscreen"></iframe>'
        )


def explore(
    *, server: str | None = None, height: int = 720, **state: str | float | Sequence[str]
) -> Page:
    """Return the page at a state: a notebook shows it in a frame, else the browser opens it.

    Parameters
    ----------
    server : str, optional
        Address of a service that runs, as ``http://127.0.0.1:8000``. Without it one is started in
        this process, for this machine alone; later calls use it, and it ends with the process.
        A notebook that runs on another machine than the browser needs one that both reach.
    height : int, optional
        Of the frame, in pixels.
    **state
        As in the address of the page: kappa, mu_over_alpha, gt_over_gn, damping; scene,
        ``"explorer"``, ``"accuracy"``, ``"spheres"``, ``"paper"`` or ``"lesson"``; embed, panels
        alone, as ``"map"`` or ``["force", "map"]``; sliders, what may be moved there, as
        ``["kappa"]`` or ``"none"``, with all else locked; … A value that makes no sense the page
        tells.

    Returns
    -------
    Page
        With its `url`.

    Raises
    ------
    ParameterError
        If the page has no such option.
    RestitutionError
        If no server is given and a setting of the environment is wrong.

    Examples
    --------
    >>> explore(kappas=63)
    Traceback (most recent call last):
    ...
    restitution.errors.ParameterError: kappas must be an option of the page, as kappa, got 63
    """
    for name in (name for name in state if name not in STATE):
        near = difflib.get_close_matches(name, STATE)
        meant = f"as {' or '.join(near)}" if near else f"one of {', '.join(STATE)}"
        raise ParameterError(name, state[name], f"an option of the page, {meant}")
    words = {
        name: value if isinstance(value, str | int | float) else ",".join(value)
        for name, value in state.items()
    }
    query = urllib.parse.urlencode(words, safe=",")
    page = Page(f"{(server or _own_server()).rstrip('/')}/?{query}", height)
    if not _in_notebook():
        webbrowser.open(page.url)
    return page


def _own_server() -> str:
    # the whole service, which nothing else here needs
    from restitution.api.background import serve_in_background  # noqa: PLC0415

    return serve_in_background()


def _in_notebook() -> bool:
    """Return whether what is returned is shown: IPython is there, and not in a terminal."""
    ipython = sys.modules.get("IPython")
    return ipython is not None and hasattr(ipython.get_ipython(), "kernel")
