"""The values of one parameter along a cut or an edge of a map."""

from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge

from restitution.bounds import checked
from restitution.errors import ParameterError
from restitution.mechanics.hertz import FloatArray

Scale = Literal["linear", "log"]


@checked
class Axis:
    """`count` values from `minimum` to `maximum`, on a ``linear`` or ``log`` scale.

    Attributes
    ----------
    minimum, maximum : float
        First and last value, > 0 on a log scale.
    count : int
        How many.
    scale : ``"linear"`` or ``"log"``
    prefix : str
        What ``min`` and ``max`` have before them in messages, where minimum and maximum are called
        so.

    Raises
    ------
    ParameterError
        If one of them is none that there can be; by `values`, if the range is empty, or reaches 0
        where it must not.

    Examples
    --------
    >>> Axis(0.1, 10.0, 3, "log").values(positive=True)
    array([ 0.1,  1. , 10. ])
    """

    minimum: float
    maximum: float
    count: Annotated[int, Ge(1)]
    scale: Scale = "linear"
    prefix: str = ""

    def values(self, *, positive: bool) -> FloatArray:
        """Return the values (count,); `positive` where the parameter has to be.

        Raises
        ------
        ParameterError
            If the range is empty, or reaches 0 where it must not.
        """
        low, high = (self.prefix + end if self.prefix else f"{end}imum" for end in ("min", "max"))
        if not self.minimum < self.maximum:
            raise ParameterError(high, self.maximum, f"greater than {low} = {self.minimum!r}")
        if self.minimum <= 0.0 and (positive or self.scale == "log"):
            reason = "as kappa is" if positive else "on a log scale"
            raise ParameterError(low, self.minimum, f"> 0, {reason}")
        space = np.linspace if self.scale == "linear" else np.geomspace
        with np.errstate(over="ignore"):
            values = space(self.minimum, self.maximum, self.count)
        # steps and logarithms round, at the edge of the double range beyond it
        return np.clip(values, self.minimum, self.maximum)


def an_axis(parameter: str, given: object) -> Axis:
    """Return a parameter that is to be an axis; `ParameterError` if it is none."""
    if not isinstance(given, Axis):
        raise ParameterError(parameter, given, "an Axis")
    return given
