export { Engine } from "./engine/wasm.js";
/** Where the documentation is, from the page; empty where it is not beside it. */
export const DOCUMENTATION = "";
