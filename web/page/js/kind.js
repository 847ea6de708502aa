export { Engine } from "./wasm.js";
