// A window over the page, as the browser has it: Escape closes it, and the focus returns to where it was.
import { block, button, el } from "./dom.js";

let count = 0;
/** @param {string} title @param {(close: () => void) => (Node | string | null)[]} inside */
export function dialog(title, inside) {
  const id = `dialog-${++count}`;
  const box = el("dialog", { "aria-labelledby": id });
  const close = () => box.close();
  box.addEventListener("close", () => box.remove());
  // A click beside it closes it too.
  box.addEventListener("click", (event) => {
    if (event.target === box) close();
  });
  const head = block(
    "row head",
    el("h2", { id }, title),
    button("Close", close),
  );
  box.append(
    block("inside", head, ...inside(close).filter((part) => part !== null)),
  );
  document.body.append(box);
  box.showModal();
  return box;
}
