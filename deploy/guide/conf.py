"""How Sphinx makes a site of `docs/`: `make docs`.

Each doubt of Sphinx is an error there; this file adds a doubt of its own, about the names of
`import restitution` that the reference does not explain.
"""

import dataclasses
import itertools
import re
from pathlib import Path
from typing import Any

import sphinx.util.logging
from numpydoc.xref import DEFAULT_LINKS
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

import restitution
from restitution.bounds import Meaning, annotations, requirement, said
from restitution.quantities import QUANTITIES, Quantity

FRONTEND = Path(__file__).parents[2] / "frontend"

project = "Restitution"
author = "The Restitution developers"
root_doc = "index"
extensions = ["myst_parser", "numpydoc", "sphinx.ext.autodoc"]

# as GitHub names them
myst_heading_anchors = 4
# quotes and dashes are meant as they stand
smartquotes = False
highlight_language = "text"

# what a docstring has between single backticks is a name, or else code
default_role = "py:obj"
# parameters and members have no place of their own to lead to, classes and constants must
nitpick_ignore_regex = [("py:obj", r"([A-Z]\w*\.)?[a-z_0-9]+")]
autodoc_default_options = {"members": True, "inherited-members": True}
autodoc_member_order = "bysource"
# docstrings say them, as numpydoc has it
autodoc_typehints = "none"
add_module_names = False
numpydoc_show_class_members = False
numpydoc_xref_param_type = True
numpydoc_xref_ignore = "all"
# links to our own classes alone: those to the manuals of Python and numpy would lead elsewhere
numpydoc_xref_aliases = {word: word for word in DEFAULT_LINKS} | {
    name: f"restitution.{name}" for name in restitution.__all__ if name[0].isupper()
}

html_theme = "furo"
html_title = project
html_favicon = str(FRONTEND / "favicon.svg")
# type and colours are those of the page; the fonts are beside this folder
html_static_path = [
    "guide.css",
    *(str(FRONTEND / "styles" / f"{n}.css") for n in ("fonts", "tokens")),
]
html_css_files = ["fonts.css", "tokens.css", "guide.css"]
templates_path = ["templates"]
html_sidebars = {
    "**": [
        "sidebar/brand.html",
        "sidebar/explorer.html",
        "sidebar/search.html",
        "sidebar/scroll-start.html",
        "sidebar/navigation.html",
        "sidebar/scroll-end.html",
    ]
}
html_copy_source = False
html_show_copyright = False

LOGGER = sphinx.util.logging.getLogger(__name__)

INNER = {"found", "held", "misfits", "beside_others", "table", "share", "wall"}
"""Members that rooms of the package share, and nobody else has any use for."""

UNSAID = {"a finite number", "a text", "an object"}
"""Requirements that a type says as well."""


def menu(_: Sphinx, name: str, source: list[str]) -> None:
    """Make the menu of the site from the lists of index.md, which read well elsewhere, too."""
    if name != root_doc:
        return
    for heading, links in re.findall(r"^## (.*)\n((?:(?!##).*\n)*)", source[0], re.MULTILINE):
        names = "\n".join(re.findall(r"^\* \[.*?\]\((.*?)\.md\)", links, re.MULTILINE))
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {heading}\n\n{names}\n```\n"


def members(_: Sphinx, kind: str, name: str, of: Any, __: Any, lines: list[str]) -> None:
    """Complete the attributes of a class by what their annotations say of them."""
    if kind != "class" or not (isinstance(of, type) and dataclasses.is_dataclass(of)):
        return
    fields = {n: a for n, a in annotations(of).items() if n not in INNER}
    section, begin, end = _attributes(lines)
    told = set()
    for at in range(begin, end):
        if match := re.fullmatch(r"(\w+(?:, \w+)*)(?: : .*)?", lines[at]):
            names = match[1].split(", ")
            told |= set(names)
            bounds = {_bounds(of, fields[each]) for each in names if each in fields}
            if len(bounds) == 1 and bounds != {""}:
                lines[at] += (", " if " : " in match[0] else " : ") + bounds.pop()
    more = []
    for each in (name for name in fields if name not in told):
        if meaning := _meaning(each, fields[each]):
            more += [f"{each} : {_bounds(of, fields[each])}".rstrip(" :"), f"    {meaning}"]
        elif f"`{each}`" not in "\n".join(lines):
            LOGGER.warning("%s.%s is explained nowhere", name, each)
    if more and not section:
        more = ["Attributes", "----------", *more, ""]
    lines[end:end] = more


def _attributes(lines: list[str]) -> tuple[bool, int, int]:
    """Return whether a docstring has attributes, and between which lines they are or belong."""
    heads = [at - 1 for at, line in enumerate(lines) if re.fullmatch("-{3,}", line)]
    for at, following in itertools.pairwise([*heads, len(lines)]):
        if lines[at] == "Attributes":
            end = following
            while not lines[end - 1].strip():
                end -= 1
            return True, at + 2, end
    first = heads[0] if heads else len(lines)
    return False, first, first


def _bounds(of: type, annotation: Any) -> str:
    """Return what a member must be, if that is looked at and its type does not say it."""
    is_checked = hasattr(of, "__pydantic_config__")
    words = requirement(annotation) if is_checked else ""
    return "" if words in UNSAID else words


def _meaning(name: str, annotation: Any) -> str:
    meaning = said(annotation, Meaning) or QUANTITIES.get(name)
    if not isinstance(meaning, Quantity):
        return meaning.text if meaning else ""
    unit = "" if meaning.unit in {"", "1"} else f" in {meaning.unit}"
    symbol = f"{meaning.symbol}: " if meaning.symbol and meaning.symbol not in meaning.text else ""
    return f"{symbol}{meaning.text}{unit}"


def skip(_: Sphinx, __: str, name: str, ___: Any, ____: bool, _____: Any) -> bool | None:
    """Leave out what is nobody else's business."""
    return True if name in INNER or hasattr(Exception, name) else None


def complete(_: Sphinx, environment: BuildEnvironment) -> None:
    """Complain about public names that have no place in the reference."""
    found = {each[0] for each in environment.domains["py"].get_objects()}
    for name in restitution.__all__:
        if f"restitution.{name}" not in found:
            LOGGER.warning("restitution.%s is not in docs/reference.md", name)


def setup(app: Sphinx) -> None:
    """Take part in the making."""
    app.connect("source-read", menu)
    app.connect("autodoc-skip-member", skip)
    # before numpydoc reads the sections
    app.connect("autodoc-process-docstring", members, priority=400)
    app.connect("env-check-consistency", complete)
