// @ts-check

/**
 * Lets the kernel come that computes collisions in the page. A browser that refuses it, or a proxy
 * whose policy does, leaves the page as it is without: all is asked of the server.
 * @param {Pick<ReturnType<typeof import("../api/client.js").createClient>, "kernel">} client
 * @param {(answers: ReturnType<typeof import("../kernel/answers.js").createAnswers>) => void} onHere
 */
export async function bringKernel(client, onHere) {
  const root = document.documentElement;
  root.toggleAttribute("data-kernel-coming", true);
  try {
    onHere(await answersBy(client.kernel()));
  } catch {
    // nothing is lost that was there before
  }
  root.toggleAttribute("data-kernel-coming", false);
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
