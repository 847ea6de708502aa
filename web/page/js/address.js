// The address: `#muscle?D=38&p=2.5bar`. All that can be seen stands in it; an entry of the history is a gesture, not a frame.

/** @returns {{ page: string, params: URLSearchParams }} */
export function read() {
  const [page, query] = location.hash.replace(/^#/, "").split("?", 2);
  return { page: page || "muscle", params: new URLSearchParams(query ?? "") };
}

/** Readable: blanks as +, and no escapes where an address needs none. @param {URLSearchParams} params */
const readable = (params) => params.toString().replaceAll("%2C", ",").replaceAll("%3A", ":").replaceAll("%2F", "/").replaceAll("%40", "@");

/** @param {string} page @param {Record<string, string | undefined>} params */
export function address(page, params) {
  const kept = new URLSearchParams(Object.entries(params).filter((pair) => pair[1] !== undefined && pair[1] !== "").map(([k, v]) => [k, /** @type {string} */ (v)]));
  const query = readable(kept);
  return `#${page}${query ? "?" + query : ""}`;
}

/** Puts it into the address: a new entry of the history, or in place of the present one. @param {string} to */
export function write(to, replace = false) {
  if (to === location.hash) return;
  if (replace) history.replaceState(null, "", to);
  else history.pushState(null, "", to);
}
