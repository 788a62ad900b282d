// @ts-check

import { createFileClient, kernelOf, METHODS_HERE } from "../../api/file-client.js";
import { keepMethods } from "../../state/accuracy.js";
import { answersBy } from "../kernel.js";

/**
 * A client that needs no server: the kernel in the file answers.
 * @param {import("../../api/file-client.js").Contents} contents
 */
export async function openFile(contents) {
  keepMethods(METHODS_HERE);
  return createFileClient(contents, await answersBy(kernelOf(contents)));
}
