"""What the server says in English, the page has in every language under the same name."""

import json
import re
from pathlib import Path

import pytest

from restitution.studies.spheres import validity
from restitution.studies.spheres.materials import MATERIALS

LOCALES = Path(__file__).parents[1] / "frontend" / "locales"


def words_of(language: str) -> dict:
    return json.loads((LOCALES / f"{language}.json").read_text(encoding="utf-8"))


def test_english_words_of_materials_are_the_servers():
    words = words_of("en")["materials"]
    assert {
        name: (each["name"], each["notes"].replace("{{kappa}}", "kappa"))
        for name, each in words.items()
    } == {
        name.replace("-", "_"): (material.title, material.notes)
        for name, material in MATERIALS.items()
    }


@pytest.mark.parametrize("language", [path.stem for path in sorted(LOCALES.glob("*.json"))])
def test_every_warning_has_words(language: str):
    source = Path(validity.__file__).read_text(encoding="utf-8")
    codes = set(re.findall(r'Caution\(\s*"(\w+)"', source))
    assert len(codes) >= 5
    assert codes <= words_of(language)["warnings"].keys()
