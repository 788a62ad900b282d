"""Refusals of parameters: their shape and their words."""

import math
import re
import reprlib
from typing import Any

import orjson

LONGEST_ECHO = 200
"""Characters of a refused value that are sent back."""

MOST_ERRORS = 100
"""Entries of a refusal; a refusal is for reading."""

UNKNOWN = "left out: this call has no such parameter"
"""May be followed by what was perhaps meant."""


DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+(e[+-]?\d+)?", re.IGNORECASE)


class RefusedParametersError(Exception):
    """Several parameters are wrong at once; `errors` as in the answer."""

    def __init__(self, errors: list[dict[str, Any]]) -> None:
        super().__init__(f"{len(errors)} parameters")
        self.errors = errors


def as_received(value: object) -> object:
    """Return a refused value in a form that JSON can hold."""
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else ("Infinity" if value > 0 else "-Infinity")
    if isinstance(value, float) or (isinstance(value, int) and abs(value) < 2**53):
        return value
    text = value if isinstance(value, str) else _json_text(value)
    return text[:LONGEST_ECHO].encode("utf-8", "replace").decode()


def _json_text(value: object) -> str:
    """Return the JSON of a list or an object; Python's words for what JSON cannot hold."""
    try:
        return orjson.dumps(value).decode()
    except TypeError:
        # too deep, too large a number, or half a character
        return reprlib.repr(value)


def refusal(parameter: str, value: object, requirement: str) -> dict[str, Any]:
    """Return one entry of `errors`; of a number that was meant, what is wrong with its mark."""
    if isinstance(value, str) and DECIMAL_COMMA.fullmatch(value):
        requirement += ", with a decimal point"
    return {
        "parameter": as_received(parameter),
        "value": as_received(value),
        "requirement": requirement,
    }


class MalformedBodyError(Exception):
    """What was sent is not the JSON object that it should be."""


def unknown(meant: str | None) -> str:
    """Return what holds for a parameter that there is not."""
    return f"{UNKNOWN}; did you mean {meant}?" if meant else UNKNOWN


def _sentence(parameter: str, value: object, requirement: str) -> str:
    if requirement.startswith(UNKNOWN):
        return f"no such parameter: {parameter}{requirement.removeprefix(UNKNOWN)}"
    if value is None:
        return f"{parameter} is missing; it must be {requirement}"
    return f"{parameter} must be {requirement}, got {value}"


def sentences(errors: list[dict[str, Any]]) -> list[str]:
    """Return a sentence for each of the first `MOST_ERRORS` wrong parameters."""
    first = [_sentence(**error) for error in errors[:MOST_ERRORS]]
    return [*first, "and more"] if len(errors) > MOST_ERRORS else first
