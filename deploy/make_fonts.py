"""Write the page's fonts, in `frontend/fonts`, from the packages of package.json they come in.

`python deploy/make_fonts.py [FOLDER]`; the same packages and tools give the same bytes.
"""

import shutil
import sys
from collections.abc import Iterable
from pathlib import Path

from fontTools.merge import Merger, Options
from fontTools.subset import Options as SubsetOptions
from fontTools.subset import Subsetter
from fontTools.ttLib import TTFont
from fontTools.varLib.instancer import instantiateVariableFont

ROOT = Path(__file__).parents[1]
PACKAGES = ROOT / "node_modules"
INTER = PACKAGES / "inter-ui"
STIX = PACKAGES / "@expo-google-fonts" / "stix-two-text"
NOTO = PACKAGES / "@expo-google-fonts" / "noto-sans-math"

# What the first view needs comes first and small; the rest when it is shown.
FIRST = {
    *range(0x20, 0x7F),
    *map(ord, "\u00a0°±²³µ·¹¼½×ÄÖÜßäöü"),
    # of French and Spanish, whose names stand in the list of languages
    *map(ord, "«»¡¿ÀÂÇÉÈÊÎÔÑàâçèéêëîïôùûœáíóúñ"),
    *map(ord, "\u2009\u200a\u202f–—‘’“”…′⁰⁴⁵⁶⁷⁸⁹⁻←→↺∂∏∑−√∞∫≈≠≤≥✓✗"),
}
GREEK = {*range(0x384, 0x3CF), 0x3D1, 0x3D5, 0x3F1, 0x3F5}
# Latin letters with the dots of derivatives, and accents for other letters
DERIVATIVES = {0x1E56, 0x1E57, *range(0x1E8A, 0x1E8E), *range(0x300, 0x30D)}
EXTENDED = {
    *({*range(0xA0, 0x180)} - FIRST),
    *(*GREEK, *DERIVATIVES),
    *map(ord, "‐‑‒―‚„†‡•‰″‹›⁄€ℓ™⁺⁼⁽⁾₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎↑↓↔↕↖↗↘↙∆∕"),
    *map(ord, "■□▲△▶▷▼▽◀◁◆◇○●★☆①②③④⑤⑥⑦⑧⑨"),
}
SYMBOLS = {*range(0x20, 0x7F), *range(0x391, 0x3CA), 0x3D1, 0x3D5, 0x3F1, 0x3F5, *DERIVATIVES}
# What Inter lacks of them comes from a mathematical face, in the file of the symbols.
SIGNS_OF_NOTO = "∓∝≪≫≲≳⋯⬢"


def main() -> None:
    """Write the files, each with the licences of what is in it."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "frontend" / "fonts"
    save(text_face(FIRST), folder / "inter.woff2")
    save(text_face(EXTENDED), folder / "inter-extended.woff2")
    save(symbol_face(folder), folder / "stix-two-text-italic.woff2")
    shutil.copy(INTER / "LICENSE.txt", folder / "inter.LICENSE")
    shutil.copy(STIX / "LICENSE_FONT", folder / "stix-two-text-italic.LICENSE")
    shutil.copy(NOTO / "LICENSE_FONT", folder / "noto-sans-math.LICENSE")


def text_face(code_points: set[int]) -> TTFont:
    """Return characters of Inter, with the weights of the page and the design for small text."""
    font = open_font(INTER / "variable" / "InterVariable.woff2")
    # Its tabular figures become its only ones: so they are in saved pictures, too, where no style
    # sheet asks for them, and its full stop keeps its width in prose.
    tabular = substitutes(font, "tnum")
    digits = {ord(digit): tabular[font.getBestCmap()[ord(digit)]] for digit in "0123456789"}
    for table in font["cmap"].tables:
        table.cmap.update(digits)
    keep(font, code_points, ["kern", "mark", "mkmk", "ccmp", "locl"])
    return instantiateVariableFont(font, {"opsz": 14, "wght": (300, 400, 700)})


def substitutes(font: TTFont, feature: str) -> dict[str, str]:
    """Return the glyphs that a feature puts in the place of others."""
    table = font["GSUB"].table
    lookups = {
        i
        for record in table.FeatureList.FeatureRecord
        if record.FeatureTag == feature
        for i in record.Feature.LookupListIndex
    }
    subtables = (s for i in sorted(lookups) for s in table.LookupList.Lookup[i].SubTable)
    plain = (getattr(subtable, "ExtSubTable", subtable) for subtable in subtables)
    return {old: new for s in plain for old, new in getattr(s, "mapping", {}).items()}


def symbol_face(folder: Path) -> TTFont:
    """Return STIX Two's italic, and upright the signs that neither it nor Inter has."""
    italic = open_font(STIX / "400Regular_Italic" / "STIXTwoText_400Regular_Italic.ttf")
    keep(italic, SYMBOLS, ["mark", "ccmp"])
    signs = open_font(NOTO / "400Regular" / "NotoSansMath_400Regular.ttf")
    keep(signs, map(ord, SIGNS_OF_NOTO), [])
    parts = []
    for name, font in (("italic", italic), ("signs", signs)):
        parts.append(folder / f"{name}.ttf")
        font.save(parts[-1])
    merged = Merger(Options(drop_tables=["MATH", "STAT", "DSIG"])).merge(list(map(str, parts)))
    # The merger writes the time of day.
    for date in ("created", "modified"):
        setattr(merged["head"], date, getattr(italic["head"], date))
    for part in parts:
        part.unlink()
    return merged


def open_font(path: Path) -> TTFont:
    """Return a font that keeps its own dates."""
    return TTFont(path, recalcTimestamp=False)


def keep(font: TTFont, code_points: Iterable[int], features: list[str]) -> None:
    """Leave a font these characters and these layout features."""
    options = SubsetOptions(layout_features=features, hinting=False, notdef_outline=True)
    # Names, version, copyright and licence travel with the letters.
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=code_points)
    subsetter.subset(font)


def save(font: TTFont, path: Path) -> None:
    """Write a font as WOFF2 and say how large it became."""
    font.flavor = "woff2"
    font.recalcTimestamp = False
    font.save(path)
    print(path.name, path.stat().st_size, "bytes")


if __name__ == "__main__":
    main()
