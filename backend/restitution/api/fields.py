"""The fields of requests: names, ranges, and the words in which a refusal states them."""

from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, field_validator
from pydantic_core import PydanticCustomError

from restitution.mechanics.viscoelastic import MOST_DAMPING

REQUIREMENTS: dict[str, str] = {}
"""Parameter → what holds for allowed values, filled by `stated`."""


def stated(name: str, requirement: str, meaning: str = "", **bounds: Any) -> Any:
    """Return a pydantic field whose description and refusals say the same."""
    REQUIREMENTS[name] = requirement
    return Field(description=f"{meaning}: {requirement}" if meaning else requirement, **bounds)


def words(allowed: tuple[str, ...]) -> AfterValidator:
    """Return a validator of a comma-separated choice of `allowed`."""

    def check(text: str) -> str:
        if not set(text.split(",")) <= set(allowed):
            raise PydanticCustomError("words", "not a choice", {"allowed": ", ".join(allowed)})
        return text

    return AfterValidator(check)


def one_of(allowed: tuple[str, ...]) -> AfterValidator:
    """Return a validator of one of the words `allowed`, where calls differ in what they allow."""

    def check(text: str) -> str:
        if text not in allowed:
            raise PydanticCustomError("word", "not allowed", {"allowed": ", ".join(allowed)})
        return text

    return AfterValidator(check)


def choice(allowed: tuple[str, ...]) -> Any:
    """Return a pydantic field that describes a comma-separated choice of `allowed`."""
    word = f"({'|'.join(allowed)})"
    return Field(
        description=f"a comma-separated choice of {', '.join(allowed)}",
        # the validator refuses with better words than a pattern of pydantic's would
        json_schema_extra={"pattern": f"^{word}(,{word})*$"},
    )


Finite = Annotated[float, Field(allow_inf_nan=False)]
Kappa = Annotated[Finite, stated("kappa", "finite and > 0", "κ of Eq. 24, with α in it", gt=0)]
MuOverAlpha = Annotated[Finite, stated("mu_over_alpha", "finite and ≥ 0", "μ/α", ge=0)]
GtOverGn = Annotated[Finite, stated("gt_over_gn", "finite and ≥ 0", "g_t/g_n", ge=0)]
Damping = Annotated[
    Finite,
    stated("damping", f"from 0 to {MOST_DAMPING:g}", "η = (3/2) A β^{2/5} g_n^{1/5}"),
    Field(ge=0, le=MOST_DAMPING),
]


class Closed(BaseModel):
    """Parameters beside which there are no others."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    @field_validator("*")
    @classmethod
    def _without_sign_of_zero(cls, value: object) -> object:
        """Make −0 the 0 that it equals, in answers and in ETags."""
        # not a part of `Finite`: bounds around it would be lost in its JSON Schema
        return value + 0.0 if isinstance(value, float) else value
