// @ts-check

import { say } from "../../format/words.js";
import { make, told } from "../../widgets/elements.js";
import { find } from "../../widgets/find.js";
import { showReason } from "../../widgets/show-reason.js";

/**
 * A panel in place of all that the scene has, which says what it takes.
 * @param {string} id
 * @param {import("../../scenes/scene.js").Page} page
 * @returns {import("../../scenes/scene.js").Scene}
 */
export function mountStandIn(id, { present }) {
  const { scene } = present();
  const panel = make(
    "section",
    "panel needs-server",
    told("h2", "", say(`page.scenes.${id}`)),
    told("p", "", say("oneFile.needed")),
  );
  for (const part of document.querySelectorAll("main [data-scene]")) {
    const scenes = (part.getAttribute("data-scene") ?? "").split(" ").filter((own) => own !== id);
    part.setAttribute("data-scene", scenes.join(" "));
    part.toggleAttribute("hidden", !scenes.includes(scene));
  }
  panel.dataset.scene = id;
  panel.dataset.testid = "needs-server";
  panel.hidden = scene !== id;
  find("main").append(panel);
  if (id === "accuracy") {
    // a step of the lesson shows one of its panels
    showReason(find(".overlay .plot-stage"), say("oneFile.needed"));
  }

  return { show() {}, follow() {}, forget() {}, pictures: {} };
}
