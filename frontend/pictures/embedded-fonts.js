// @ts-check

/**
 * A picture with the page's own fonts in it, as far as it uses them: it looks the same wherever it is
 * opened.
 * @param {string} svg
 * @param {(address: string) => Promise<Blob>} loadFont
 * @returns {Promise<string>}
 */
export async function withFonts(svg, loadFont) {
  const letters = [...new Set(svg)];
  const faces = ownFaces().filter((face) => isUsed(face, svg, letters));
  const rules = await Promise.all(faces.map((face) => embedded(face, loadFont)));
  return svg.replace(/<svg[^>]*>/, (opening) => `${opening}<style>${rules.join("")}</style>`);
}

function ownFaces() {
  return [...document.styleSheets]
    .flatMap(({ cssRules }) => [...cssRules])
    .filter((rule) => rule instanceof CSSFontFaceRule)
    .filter(({ cssText }) => addressIn(cssText));
}

/** @param {string} cssText */
function addressIn(cssText) {
  return /url\("([^"]+)"\)/.exec(cssText)?.[1] ?? "";
}

/**
 * @param {CSSFontFaceRule} face
 * @param {string} svg
 * @param {string[]} letters each that is in it, once
 */
function isUsed({ style }, svg, letters) {
  if (style.getPropertyValue("font-style") === "italic" && !svg.includes("italic")) {
    return false;
  }
  const range = style.getPropertyValue("unicode-range");
  return !range || letters.some((letter) => isIn(range, letter));
}

/**
 * @param {string} range as in U+2213, U+226A-226B
 * @param {string} letter
 */
function isIn(range, letter) {
  const code = letter.codePointAt(0) ?? 0;
  return range.split(",").some((part) => {
    const [first, last = first] = part
      .replace(/U\+/i, "")
      .split("-")
      .map((digits) => Number.parseInt(digits, 16));
    return first <= code && code <= last;
  });
}

/**
 * @param {CSSFontFaceRule} face
 * @param {(address: string) => Promise<Blob>} loadFont
 */
async function embedded({ cssText, parentStyleSheet }, loadFont) {
  const address = addressIn(cssText);
  try {
    const { href } = new URL(address, parentStyleSheet?.href ?? undefined);
    const uri = await dataUri(await loadFont(href));
    // A picture that becomes a bitmap is drawn at once, with the fonts that are known by then.
    await new FontFace("embedded", `url("${uri}")`).load();
    return cssText.replace(address, uri);
  } catch {
    // Without a server a picture is still worth saving.
    return "";
  }
}

/**
 * @param {Blob} blob
 * @returns {Promise<string>}
 */
function dataUri(blob) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
}
