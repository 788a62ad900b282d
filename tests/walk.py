"""Run docs/python-walk.md in a folder, where it leaves its pictures: `make pictures`."""

import doctest
import os
import re
import sys
import webbrowser
from pathlib import Path

import matplotlib as mpl

WALK = Path(__file__).parents[1] / "docs" / "python-walk.md"


class Fenced(doctest.DocTestParser):
    """Reads lines in fences, of which doctest knows nothing."""

    def parse(self, string, name="<string>"):
        """Return what is said and what is run."""
        return super().parse(re.sub(r"^```.*", "", string, flags=re.MULTILINE), name)


def main(folder: Path) -> int:
    """Return the failures among the lines."""
    os.chdir(folder)
    # the same bytes each time, on a machine without a screen
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = WALK.name
    # `explore` shall open nothing here
    webbrowser.open = lambda _: True
    failures, tried = doctest.testfile(str(WALK), module_relative=False, parser=Fenced())
    print(f"{tried} lines, {failures} failures")
    return failures


if __name__ == "__main__":
    sys.exit(bool(main(Path(sys.argv[1]))))
