"""The deliberate errors: what was wrong, with which value, what is allowed."""

import numpy as np
import numpy.typing as npt


class RestitutionError(Exception):
    """Base of every error that this package raises on purpose.

    Examples
    --------
    >>> issubclass(ParameterError, RestitutionError), issubclass(CostError, RestitutionError)
    (True, True)
    """


class ParameterError(RestitutionError, ValueError):
    """A parameter outside its range.

    Parameters
    ----------
    parameter : str
        Name as the caller knows it, an element of an array as ``kappa[17]``.
    value : object
        As received.
    requirement : str
        What holds for allowed values, to stand after "must be".

    Examples
    --------
    >>> str(ParameterError("kappa", -1.0, "finite and > 0"))
    'kappa must be finite and > 0, got -1.0'
    """

    def __init__(self, parameter: str, value: object, requirement: str) -> None:
        super().__init__(f"{parameter} must be {requirement}, got {value!r}")
        self.parameter = parameter
        self.value = value
        self.requirement = requirement

    def __reduce__(self) -> tuple[type, tuple[str, object, str]]:
        # by default it would be made anew from its message alone, when it comes from a process
        return type(self), (self.parameter, self.value, self.requirement)


class UnknownParameterError(RestitutionError, TypeError):
    """A keyword that a function or a class does not have, and what it was perhaps meant for.

    Parameters
    ----------
    parameter : str
        As it was written.
    value : object
        What it was given.
    meant : str or None
        A name that there is.

    Examples
    --------
    >>> str(UnknownParameterError("kapa", 3, "kappa"))
    'no such parameter: kapa, got 3; did you mean kappa?'
    """

    def __init__(self, parameter: str, value: object, meant: str | None) -> None:
        hint = f"; did you mean {meant}?" if meant else ""
        super().__init__(f"no such parameter: {parameter}, got {value!r}{hint}")
        self.parameter = parameter
        self.value = value
        self.meant = meant

    def __reduce__(self) -> tuple[type, tuple[str, object, str | None]]:
        # as of `ParameterError`
        return type(self), (self.parameter, self.value, self.meant)


class CostError(RestitutionError):
    """A request that would cost more than its budget, refused before any work.

    Examples
    --------
    >>> import restitution as rs
    >>> try:
    ...     rs.epsilon_t(1e12, 1.0, 1.0)
    ... except CostError:
    ...     float(rs.collision(1e12, 1.0, 1.0, tolerance=1e-3).epsilon_t)
    0.0
    """


class MissingExtraError(RestitutionError, ImportError):
    """A package of one of our extras that is not installed."""

    def __init__(self, package: str | None, extra: str) -> None:
        super().__init__(f"there is no {package} here: pip install 'restitution[{extra}]'")


def require(
    parameter: str,
    values: npt.ArrayLike,
    allowed: npt.NDArray[np.bool_] | np.bool_ | bool,
    requirement: str,
) -> None:
    """Raise `ParameterError` for the first of `values` (any shape) that is not `allowed`."""
    if allowed is True or np.all(allowed):
        return
    given = np.asarray(values, dtype=np.float64)
    place = int(np.argmin(allowed))
    name = element(parameter, given.shape, place)
    raise ParameterError(name, float(given.ravel()[place]), requirement)


def element(parameter: str, shape: tuple[int, ...], place: int) -> str:
    """Return the name of an element, by its place in the array made flat; a number has none."""
    index = ",".join(map(str, np.unravel_index(place, shape)))
    return f"{parameter}[{index}]" if shape else parameter
