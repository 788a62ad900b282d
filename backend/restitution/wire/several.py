"""Several words in one parameter of a query."""

from typing import Any

from pydantic_core import PydanticCustomError, core_schema

from restitution.bounds import Words


class Several(Words):
    """A comma-separated choice of words."""

    allowed: tuple[str, ...]

    def __init__(self, *allowed: str) -> None:
        super().__init__(f"a comma-separated choice of {', '.join(allowed)}")
        object.__setattr__(self, "allowed", allowed)

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Let pydantic refuse other words."""
        allowed = set(self.allowed)

        def check(text: str) -> str:
            if not set(text.split(",")) <= allowed:
                raise PydanticCustomError("words", "not a choice")
            return text

        return core_schema.no_info_after_validator_function(check, handler(source))

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        """Describe the choice as a pattern."""
        word = f"({'|'.join(self.allowed)})"
        return handler(schema) | {"pattern": f"^{word}(,{word})*$"}
