export { Engine } from "./engine/wasm.js";
