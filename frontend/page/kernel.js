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
    const [{ createKernel }, { createAnswers }, module] = await Promise.all([
      import("../kernel/kernel.js"),
      import("../kernel/answers.js"),
      client.kernel(),
    ]);
    onHere(createAnswers(await createKernel(module)));
  } catch {
    // nothing is lost that was there before
  }
  root.toggleAttribute("data-kernel-coming", false);
}
