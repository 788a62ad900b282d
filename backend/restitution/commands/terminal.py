"""What a terminal cannot show is written in words: ≥ as >=, κ as kappa, ε_t as epsilon_t."""

import codecs
import io
import json
import re
import sys
import unicodedata
from typing import Any

import click

from restitution.errors import RestitutionError
from restitution.neighbours import neighbour
from restitution.wire.refusals import MalformedBodyError, RefusedParametersError, sentences

WORDS = {
    "−": "-",
    "–": "-",
    "±": "+-",
    "∓": "-+",
    "×": "x",
    "·": "*",
    "½": "1/2",
    "√": "sqrt",
    "∞": "infinity",
    "∂": "d",
    "∫": "integral",
    "∏": "product",
    "≈": "~",
    "∝": "proportional to",
    "≤": "<=",
    "≥": ">=",
    "≪": "<<",
    "≳": ">~",
    "→": "->",
    "′": "'",
    "“": '"',
    "”": '"',
    "…": "...",
    "°": " degrees",
    "µ": "u",
    "ẋ": "dx/dt",
    "ẍ": "d2x/dt2",
    "Ṗ": "dP/dt",
}
"""Of signs; Greek letters have their names, others are written without their marks."""

GREEK = re.compile(r"GREEK (SMALL|CAPITAL) LETTER (\w+)")

RAISED = re.compile(r"[⁻⁰¹²³⁴-⁹]+")

IN_WORDS = "restitution-words"
"""Name of the way in which codecs deal with what they cannot encode."""

LETTERS = "restitution-ascii"
"""ASCII by another name: where it goes by its own, click writes UTF-8 in its place."""


def in_words(text: str) -> str:
    """Return a text in ASCII.

    Examples
    --------
    >>> in_words("ε_t ≥ 0 for κ ≤ 10⁻³⁰⁰")
    'epsilon_t >= 0 for kappa <= 10^-300'
    """
    raised = RAISED.sub(lambda run: "^" + "".join(map(_plain, run[0])), text)
    return "".join(map(_plain, raised))


def _plain(sign: str) -> str:
    if sign in WORDS:
        return WORDS[sign]
    if letter := GREEK.fullmatch(unicodedata.name(sign, "")):
        return letter[2].lower() if letter[1] == "SMALL" else letter[2].capitalize()
    bare = unicodedata.normalize("NFKD", sign).replace("\N{MINUS SIGN}", "-")
    found = "".join(each for each in bare if each.isascii())
    # of a mark over the letter before it nothing is left
    return found or ("" if unicodedata.combining(sign) else "?")


def _replace(error: UnicodeError) -> tuple[str, int]:
    assert isinstance(error, UnicodeEncodeError)
    return in_words(error.object[error.start : error.end]), error.end


def _letters(name: str) -> codecs.CodecInfo | None:
    if name != LETTERS.replace("-", "_"):
        return None
    found = codecs.lookup("ascii")
    return codecs.CodecInfo(
        found.encode,
        found.decode,
        found.streamreader,
        found.streamwriter,
        found.incrementalencoder,
        found.incrementaldecoder,
        LETTERS,
    )


codecs.register_error(IN_WORDS, _replace)
codecs.register(_letters)


def never_fail(stream: Any) -> None:
    """Let a text stream write in words what its encoding lacks."""
    if isinstance(stream, io.TextIOWrapper):
        is_ascii = codecs.lookup(stream.encoding).name == "ascii"
        stream.reconfigure(encoding=LETTERS if is_ascii else None, errors=IN_WORDS)


class Command(click.Command):
    """Names the option that a wrong one was perhaps meant for."""

    def names(self) -> dict[str, str]:
        """Return what options are called elsewhere, each with its name here."""
        options = [name for each in self.params for name in each.opts if name.startswith("--")]
        return {name.removeprefix("--").replace("-", "_"): name for name in options}

    def parse_args(self, context: click.Context, arguments: list[str]) -> list[str]:
        """Parse as ever."""
        try:
            return super().parse_args(context, arguments)
        except click.NoSuchOption as wrong:
            names = self.names()
            if not (meant := neighbour(wrong.option_name.lstrip("-"), names)):
                raise
            # of possibilities click names only those that are spelt alike
            words = f"{wrong.message} Did you mean {names[meant]!r}?"
            raise click.NoSuchOption(wrong.option_name, words, None, context) from wrong


class Program(click.Group):
    """A group of commands whose output any terminal can show, refusals in a line each."""

    command_class = Command

    def main(self, *args: Any, **extra: Any) -> Any:
        """Run the command that is asked for."""
        for stream in (sys.stdout, sys.stderr):
            never_fail(stream)
        return super().main(*args, **extra)

    def invoke(self, context: click.Context) -> Any:
        """Run it, and say what it refuses."""
        try:
            return super().invoke(context)
        except RefusedParametersError as refused:
            raise click.ClickException("\n".join(sentences(refused.errors))) from refused
        except (MalformedBodyError, RestitutionError) as refused:
            raise click.ClickException(str(refused)) from refused


def say_json(text: bytes) -> None:
    """Write JSON, which is UTF-8, to standard output; where that has no UTF-8, with escapes."""
    if codecs.lookup(sys.stdout.encoding).name == "utf-8":
        click.echo(text)
    else:
        click.echo(json.dumps(json.loads(text)))
