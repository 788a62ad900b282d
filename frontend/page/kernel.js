// @ts-check

import { createSource } from "../state/loading/source.js";

/**
 * The server with the kernel beside it.
 * @param {ReturnType<typeof import("../api/client.js").createClient>} client
 * @param {Parameters<typeof createSource>[2]} options
 */
export async function sourceWithKernel(client, options) {
  return createSource(client, await answersBy(client.kernel()), options);
}

/**
 * What a kernel that is on its way answers.
 * @param {Promise<WebAssembly.Module>} coming
 */
export async function answersBy(coming) {
  const [{ createKernel }, { createAnswers }, module] = await Promise.all([
    import("../kernel/kernel.js"),
    import("../kernel/answers.js"),
    coming,
  ]);
  return createAnswers(await createKernel(module));
}
