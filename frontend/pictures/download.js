// @ts-check

let last = "";

/**
 * Hands the reader a file.
 * @param {Blob} file
 * @param {string} fileName
 */
export function download(file, fileName) {
  const link = document.createElement("a");
  // Not when it is handed over: the browser may still be reading it.
  URL.revokeObjectURL(last);
  last = URL.createObjectURL(file);
  link.href = last;
  link.download = fileName;
  link.click();
}
