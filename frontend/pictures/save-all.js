// @ts-check

import { fileName } from "../format/requests.js";
import { say } from "../format/words.js";
import { linkTo } from "../state/address/bar.js";
import { writeAddress } from "../state/address/writing.js";
import { byTestId } from "../widgets/find.js";
import { download } from "./download.js";

/**
 * The button that gives all that the scene shows as one ZIP.
 * @param {import("./panel-picture.js").PanelPicture[]} panels to which those of later scenes are added
 * @param {() => import("../state/address/options.js").PageState} present
 * @param {import("./picture-menu.js").Load & {words: () => Promise<void>, say: (text: string) => void}} load
 */
export function mountSaveAll(panels, present, load) {
  const button = byTestId("save-all");

  async function save() {
    const [parts] = await Promise.all([import("./bundle.js"), load.words()]).catch(() => [null]);
    if (!parts) {
      load.reportLost(say("server.saverMissing"));
      return;
    }
    const state = present();
    const link = linkTo(writeAddress(state));
    const shown = panels.filter(isShown);
    const { zip, lack } = await parts.bundle({ state, link, panels: shown, load });
    download(zip, fileName(state.scene, { ...state.collision }, "zip"));
    load.say(lack);
  }

  button.addEventListener("click", async () => {
    if (button.ariaBusy !== "true") {
      button.ariaBusy = "true";
      await save().finally(() => (button.ariaBusy = "false"));
    }
  });
}

/** What is under the glass of the lesson is not to be had yet. @param {import("./panel-picture.js").PanelPicture} panel */
function isShown({ element, isHere }) {
  return element.checkVisibility() && !element.closest("[inert]") && isHere();
}
