"""The body of ``POST /scaling`` told by options of the command line, as they are or over a file.

What there are follows from the classes that a body is made of; what their values may be is not
looked at here but when the body is read, so that refusals are those of the service.
"""

import copy
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, get_origin

from restitution.bounds import Meaning, annotations, plain, requirement, said
from restitution.neighbours import stem
from restitution.studies.spheres.bodies import Moment, Sphere, Wall
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import TOLD_BY, Velocities, kind_of_impact

Json = dict[str, Any]

SHORT = {"friction_coefficient": "friction", "tangential_stiffness": "stiffness"}

EITHER_OR = (
    ("density_kg_m3", "mass_kg"),
    ("dissipative_constant_s", "normal_restitution"),
)
"""Of which an option takes the place of the other one in a file, or of the first body."""


class Told(NamedTuple):
    """An option: its name, the member that it tells, what that may be, of how many values."""

    name: str
    path: tuple[str, ...]
    words: str
    size: int

    @property
    def key(self) -> str:
        """The name as Python has it."""
        return self.name.removeprefix("--").replace("-", "_")


def _told(annotation: Any, *path: str, second: bool = False) -> Told:
    short = stem(path[-1])
    name = "--" + SHORT.get(short, short).replace("_", "-") + ("-2" if second else "")
    meaning = said(annotation, Meaning)
    words = f"{meaning.text}; {requirement(annotation)}" if meaning else requirement(annotation)
    return Told(name, path, words, 3 if get_origin(plain(annotation)) is tuple else 1)


def _options() -> Iterator[Told]:
    for place in (1, 2):
        body, second = f"body_{place}", place == 2
        for member, annotation in annotations(Sphere).items():
            if member != "wall":
                yield _told(annotation, body, member, second=second)
        moment = annotations(Moment)["moment_kg_m2"]
        yield _told(moment, body, "inertia", "moment_kg_m2", second=second)
    for member, annotation in annotations(Contact).items():
        if not member.startswith("body_"):
            yield _told(annotation, member)
    for kind in reversed(TOLD_BY):
        for member, annotation in annotations(kind).items():
            yield _told(annotation, "impact", member)


OPTIONS = tuple(_options())

OF_WALL = annotations(Wall).keys()


def told_body(base: Json | None, given: Mapping[str, Any], *, wall: bool) -> Json:
    """Return the body that options tell, over that of a file where there is one.

    Parameters
    ----------
    base : dict or None
        The body of the file.
    given : mapping
        Texts, or triples of them, by the `key` of `OPTIONS`; None where an option is not given.
    wall : bool
        Whether the second body is a wall.

    Returns
    -------
    dict
        Numbers where the texts are numbers. Without a file the second body is as the first in
        what is not said of it, the stiffness Mindlin's, and the tangential velocity 0.

    Examples
    --------
    >>> body = told_body(None, {"radius": "0.02", "radius_2": "0.01"}, wall=False)
    >>> body["body_2"], body["tangential_stiffness_n_per_m"]
    ({'radius_m': 0.01}, 'mindlin')
    """
    told: Json = {}
    for option in OPTIONS:
        if (value := given.get(option.key)) is not None:
            _put(told, option.path, _values(value))
    body: Json = copy.deepcopy(base) if base else {"tangential_stiffness_n_per_m": "mindlin"}
    impact = _impact(body.get("impact"), told.pop("impact", {}))
    bodies = [told.pop(name, {}) for name in ("body_1", "body_2")]
    body = {**_over(body, told), **({"impact": impact} if impact else {})}
    first = body["body_1"] = _over(body.get("body_1", {}), bodies[0])
    second = body.get("body_2", first if base is None else {})
    if wall and isinstance(second, dict):
        second = {n: v for n, v in second.items() if n in OF_WALL} | {"wall": True}
    body["body_2"] = _over(second, bodies[1])
    return body


def by_option(errors: list[Json], given: Mapping[str, Any], *, alone: bool) -> list[Json]:
    """Return refusals of a body that `told_body` made by the names of options.

    Of those that are `given`, and of all that could be given where they stand `alone`, without a
    file: then the second body is refused by what is refused of the first.
    """
    told = [each for each in OPTIONS if alone or given.get(each.key) is not None]
    names = {".".join(option.path): option.name for option in told}
    within = {option.path[-1]: option.name for option in reversed(told)}
    found: Json = {}
    for error in errors:
        member: str = error["parameter"]
        if alone and given.get(_key_of(member)) is None:
            member = member.replace("body_2.", "body_1.")
        name = names.get(member, member)
        words = re.sub(r"\w+_\w+", lambda word: within.get(word[0], word[0]), error["requirement"])
        found.setdefault(name, error | {"parameter": name, "requirement": words})
    return list(found.values())


def _key_of(member: str) -> str:
    return next((each.key for each in OPTIONS if ".".join(each.path) == member), "")


def _put(whole: Json, path: tuple[str, ...], value: Any) -> None:
    *parents, last = path
    for name in parents:
        if not isinstance(whole.get(name), dict):
            whole[name] = {}
        whole = whole[name]
    whole[last] = value


def _values(value: Any) -> Any:
    return [_value(part) for part in value] if isinstance(value, tuple) else _value(value)


def _value(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _over(below: Any, told: Json) -> Any:
    """Return an object with what is told in place of what it has."""
    if not isinstance(below, dict):
        # refused when it is read
        return below
    replaced = {
        other
        for either in EITHER_OR
        for name, other in (either, either[::-1])
        if name in told and other not in told
    }
    return {name: value for name, value in below.items() if name not in replaced} | told


def _impact(below: Any, told: Json) -> Any:
    """Return an impact told by options over that of a file, if this is told in the same way."""
    if not told:
        return below
    if isinstance(below, dict) and kind_of_impact(below) is kind_of_impact(told):
        return below | told
    head_on = kind_of_impact(told) is Velocities and "normal_velocity_m_s" in told
    return ({"tangential_velocity_m_s": 0.0} if head_on else {}) | told
