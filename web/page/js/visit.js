// Another page, with words for it beside those that it has kept.
import { address } from "./address.js";
import { pack } from "./deflate.js";
import { wordsOf } from "./kept.js";
import { muscle } from "./muscle.js";

/**
 * Goes to a page with words over the kept ones; the muscle goes along.
 * @param {string} page @param {Record<string, string | undefined>} words
 */
export async function visit(page, words) {
  await Promise.all(Object.values(words).map((word) => pack(word ?? "")));
  const to = address(page, { ...wordsOf(page), ...words, ...muscle.params() });
  if (to === location.hash)
    window.dispatchEvent(
      new PopStateEvent("popstate", { state: history.state }),
    );
  else location.hash = to;
}
