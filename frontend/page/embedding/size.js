// @ts-check

/**
 * Tells who shows this frame how high it is best, and what is in it, whenever that changes.
 * @param {MessagePort} port
 */
export function tellSize(port) {
  const root = document.documentElement;
  const panels = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[data-embedded]")]);
  const foot = document.querySelectorAll(".embed-foot > *");
  let told = "";

  function tell() {
    // Its height by its content, not by the frame, for as long as it is measured.
    root.toggleAttribute("data-measured", true);
    const height = Math.ceil(document.body.getBoundingClientRect().height);
    root.toggleAttribute("data-measured", false);
    const names = panels.flatMap(({ dataset }) => dataset.title ?? []);
    const all = JSON.stringify([height, names]);
    if (all !== told) {
      told = all;
      port.postMessage({ height, names });
    }
  }

  const watch = new ResizeObserver(tell);
  for (const part of [...panels.flatMap((panel) => [panel, ...panel.children]), ...foot]) {
    watch.observe(part);
  }
}
