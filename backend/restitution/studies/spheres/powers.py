"""Products of powers that neither overflow nor underflow on the way."""

import math

from restitution.errors import ParameterError

LEAST, LARGEST = 2.2250738585072014e-308, 1.7976931348623157e308
"""The numbers that double precision holds with all digits."""


def product_of_powers(*factors: tuple[float, int]) -> float:
    """Return ∏ value^(tenths/10), infinite or 0 only where the product itself is out of range.

    Parameters
    ----------
    factors : tuples of float and int
        Positive values, each with its exponent in tenths: ``(beta, -4)`` is β^{-2/5}.

    Examples
    --------
    >>> product_of_powers((2.0**900, 20), (2.0**-900, 10), (2.0**890, -10))
    1024.0
    """
    mantissa, tenths = 1.0, 0
    for value, power in factors:
        part, exponent = math.frexp(value)
        mantissa *= part ** (power / 10)
        tenths += exponent * power
    whole, rest = divmod(tenths, 10)
    try:
        return math.ldexp(mantissa * 2.0 ** (rest / 10), whole)
    except OverflowError:
        return math.inf


def joined(first: float, second: float) -> float:
    """Return 1/(1/first + 1/second) of positive numbers; one of them may be infinite."""
    small, large = min(first, second), max(first, second)
    return small / (1.0 + small / large)


def representable(name: str, value: float, change: str) -> float:
    """Return `value` if it is a positive number that double precision holds with all digits.

    Parameters
    ----------
    name : str
        Of the derived quantity.
    value : float
        0 or more, infinite if it overflowed.
    change : str
        The given quantities to change otherwise.

    Raises
    ------
    ParameterError
        If it is not.
    """
    if not LEAST <= value <= LARGEST:
        requirement = (
            f"from 2.3e-308 to 1.7e308, what double precision holds; it follows from {change}: "
            "bring these nearer to 1"
        )
        raise ParameterError(name, value, requirement)
    return value
