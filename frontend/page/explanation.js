// @ts-check

import { NeedsServer, Refused, Unreachable } from "../api/client.js";
import { say } from "../format/words.js";

/**
 * What is to be done about an error: a refusal is left to whom it concerns.
 * @param {(reason: string) => void} onLost
 * @returns {(refuse: (reason: string, language: string) => void) => (error: unknown) => void} told with the
 *   language of the reason, where it is not that of the page: the server has but one
 */
export function createExplanation(onLost) {
  return (refuse) => (error) => {
    if (error instanceof Unreachable) {
      onLost(say(`server.${error.reason}`));
    } else if (error instanceof NeedsServer) {
      refuse(say("oneFile.needed"), "");
    } else if (!(error instanceof Refused)) {
      throw error;
    } else if (error.message) {
      refuse(error.message, "en");
    } else {
      refuse(say("server.status", { status: error.status }), "");
    }
  };
}
