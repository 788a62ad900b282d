// @ts-check

/**
 * The arrays of an answer, as `encoding=base64` writes them: little-endian, as every machine with a
 * browser has it in memory.
 * @typedef {{dtype: "f8" | "i4" | "i1", shape: string, bdata: string}} EncodedArray
 */

/**
 * The numbers of an encoded array, row after row.
 * @param {EncodedArray} encoded
 * @returns {Float64Array | Int32Array | Int8Array}
 */
export function decodeArray({ dtype, bdata }) {
  const text = atob(bdata);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) {
    bytes[i] = text.charCodeAt(i);
  }
  switch (dtype) {
    case "f8":
      return new Float64Array(bytes.buffer);
    case "i4":
      return new Int32Array(bytes.buffer);
    case "i1":
      return new Int8Array(bytes.buffer);
    default:
      throw new Error(`arrays of ${dtype} are not known here`);
  }
}

/**
 * The lengths along each axis of an encoded array.
 * @param {EncodedArray} encoded
 */
export function shapeOf({ shape }) {
  return shape.split(",").map(Number);
}

/**
 * An answer with every encoded array on its first level decoded; one with two axes becomes its rows.
 * @param {Record<string, any>} answer
 * @returns {Record<string, any>}
 */
export function decodeArrays(answer) {
  return Object.fromEntries(
    Object.entries(answer).map(([key, value]) => [key, isEncoded(value) ? rows(value) : value]),
  );
}

/** @param {any} value */
function isEncoded(value) {
  return typeof value?.bdata === "string";
}

/** @param {EncodedArray} encoded */
function rows(encoded) {
  const flat = decodeArray(encoded);
  const [count, length] = shapeOf(encoded);
  if (length === undefined) {
    return flat;
  }
  return Array.from({ length: count }, (_, row) => flat.subarray(row * length, (row + 1) * length));
}
