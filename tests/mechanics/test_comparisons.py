"""Every comparison on the way to a number of switches is known, with what rounding makes of it.

`comparisons.csv` names each and says why it cannot make an uncertain count look certain: either
its rounding is carried into `switches_certain`, or both ways lead to the same count where they
part. One that is not in it fails here.
"""

import ast
import csv
from collections.abc import Iterator
from pathlib import Path

from restitution.mechanics import collision

FOLDER = Path(collision.__file__).parent
CHOOSING = {"min", "max", "round", "int", "floor", "ceil"}
ANY = "*"


def functions() -> dict[str, ast.FunctionDef]:
    """Those of the mechanics, by path of the module and name."""
    return {
        f"{path.relative_to(FOLDER).with_suffix('')}.{node.name}": node
        for path in FOLDER.rglob("*.py")
        for node in ast.parse(path.read_text()).body
        if isinstance(node, ast.FunctionDef)
    }


def called(function: ast.FunctionDef) -> set[str]:
    calls = (node.func for node in ast.walk(function) if isinstance(node, ast.Call))
    return {call.attr if isinstance(call, ast.Attribute) else ast.unparse(call) for call in calls}


def reached() -> dict[str, ast.FunctionDef]:
    """The functions that a collision goes through; of two of one name, both."""
    known = functions()
    found: dict[str, ast.FunctionDef] = {}
    ahead = ["collision._collide_in_lanes"]
    while ahead:
        name = ahead.pop()
        if name not in found:
            found[name] = known[name]
            calls = called(known[name])
            ahead += [other for other in known if other.split(".")[1] in calls]
    return found


def comparisons(node: ast.AST) -> Iterator[str]:
    """What can change the way: comparisons, and functions that choose or round."""
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, ast.Compare):
            yield ast.unparse(inner)
        chooses = isinstance(inner, ast.Call) and ast.unparse(inner.func).split(".")[-1] in CHOOSING
        if chooses:
            yield ast.unparse(inner)
        else:
            yield from comparisons(inner)


def test_every_comparison_says_what_rounding_makes_of_it():
    with Path(__file__).with_name("comparisons.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    assert all(row["reason"] for row in rows)
    listed = {(row["function"], row["comparison"]) for row in rows}
    whole = {function for function, comparison in listed if comparison == ANY}
    present = {
        (name, ANY if name in whole else comparison)
        for name, function in reached().items()
        for comparison in comparisons(function)
    }
    assert present == listed
