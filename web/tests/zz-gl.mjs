import { alive, launch, served, tab } from "./browser.mjs";
const site = await served(process.env.MCKIBBEN);
const browser = await launch();
const { page } = await tab(browser);
await page.addInitScript(() => { const g = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (...a) { const c = g.apply(this, a); if (c && a[0] === "webgl2") window.lastgl = c; return c; }; });
await page.goto(site.url + "#muscle"); await alive(page); await page.waitForTimeout(2500);
const r = await page.evaluate(async () => {
  const { View } = await import("/js/view3d.js");
  let v; const d = View.prototype.draw; View.prototype.draw = function (s) { v = this; return d.call(this, s); };
  // provoke a draw
  const c = document.querySelector(".stage canvas"); c.focus(); c.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true })); 
  await new Promise((r) => setTimeout(r, 500));
  const gl = v.gl, px = new Uint8Array(4), out = {};
  out.size = [v.width, v.height, v.shape.stations, v.shape.across, v.shape.strands];
  const time = (name, f) => { const t = []; for (let i = 0; i < 25; i++) { const s = performance.now(); f(); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, px); t.push(performance.now() - s); } t.sort((a, b) => a - b); out[name] = t[12].toFixed(2); };
  clearTimeout(v.rest);
  time("coarse", () => d.call(v, false));
  time("upload+coarse", () => { v.upload(); d.call(v, false); });
  time("sharp", () => d.call(v, true));
  const w = v.width, h = v.height;
  for (const k of [0.8, 0.6, 0.4]) { v.width = w * k; v.height = h * k; time("coarse x" + k, () => d.call(v, false)); }
  v.width = w * .1; v.height = h * .1; time("coarse x.1 (vertices)", () => d.call(v, false)); v.width = w; v.height = h;
  const pl = v.plugs; v.plugs = () => {}; time("no plugs", () => d.call(v, false)); v.plugs = pl;
  const st = v.shape.strands; v.shape.strands = 0.5; time("strands none-ish", () => d.call(v, false)); v.shape.strands = st;
  
  out.url = document.querySelector(".stage canvas") && v.canvas.toDataURL().length; return out;
});
console.log(r);
await browser.close(); site.end();
