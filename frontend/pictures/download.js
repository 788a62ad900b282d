// @ts-check

/**
 * Hands the reader a file.
 * @param {string} address of its content
 * @param {string} fileName
 */
export function download(address, fileName) {
  const link = document.createElement("a");
  link.href = address;
  link.download = fileName;
  link.click();
}
