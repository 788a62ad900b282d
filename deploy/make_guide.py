"""Write the guide, a site made of `docs/`, into a folder: `make docs`.

`python deploy/make_guide.py FOLDER [DOCS]`. Whatever Sphinx is in doubt about is an error, as a
link that leads nowhere or a public name without a word (`deploy/guide/conf.py`); the folder is then
left as it was.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from sphinx.cmd.build import build_main

ROOT = Path(__file__).parents[1]
STRICT = ["--fail-on-warning", "--nitpicky", "--quiet"]


def main(folder: Path, docs: Path = ROOT / "docs") -> int:
    """Return the status of Sphinx."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as made:
        site, kept = Path(made, "site"), Path(made, "kept")
        where = ["-c", str(ROOT / "deploy" / "guide"), "-d", str(kept)]
        if status := build_main([*STRICT, *where, str(docs), str(site)]):
            return status
        # where fonts.css of the page looks for them
        shutil.copytree(ROOT / "frontend" / "fonts", site / "fonts")
        shutil.rmtree(folder, ignore_errors=True)
        site.rename(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(*(Path(each).resolve() for each in sys.argv[1:])))
