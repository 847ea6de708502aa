import { alive, launch, served, tab } from "./browser.mjs";
import { writeFileSync } from "node:fs";
const card = Number(process.argv[2] ?? 0), names = process.argv.slice(3);
const site = await served(process.env.MCKIBBEN);
const browser = await launch();
const { page } = await tab(browser);
await page.addInitScript(() => {
  const w = window; w.fetches = []; const f = w.fetch;
  w.fetch = async (u, o) => { const t0 = performance.now(); const name = String(u).split("/").pop(); const a = await f(u, o); const t1 = performance.now(); const ab = a.arrayBuffer.bind(a); a.arrayBuffer = async () => { const b = await ab(); w.fetches.push([name, t0, t1, performance.now(), b.byteLength, o?.body?.length]); return b; }; return a; };
});
await page.goto(site.url + "#muscle"); await alive(page); await page.waitForTimeout(2000);
if (card >= 0) {
  await page.goto(`${site.url}#about`); await page.goto(`${site.url}#muscle`);
  await page.locator("#welcome .gallery .card").nth(card).click();
  await page.waitForFunction(() => /file=/.test(location.hash));
  await page.evaluate(() => { location.hash = location.hash.replace(/^#[a-z]+/, "#muscle"); });
  await alive(page); await page.waitForTimeout(3000);
}
await page.evaluate(() => { for (const b of document.querySelectorAll(".controls details")) b.open = true; 
  const w = window; w.delays = []; w.open = []; w.inputs=[]; w.anss=[]; w.lt=[];
  document.addEventListener("input", (e) => { w.open.push(e.timeStamp); w.inputs.push([e.timeStamp, performance.now()]); }, true);
  new MutationObserver(() => { const mine = w.open.splice(0); w.anss.push(performance.now());
    requestAnimationFrame(() => { const raf = performance.now(); const { port1, port2 } = new MessageChannel(); port1.onmessage = () => mine.forEach((t) => w.delays.push([performance.now() - t, raf - t])); port2.postMessage(0); });
  }).observe(document.querySelector(".stage .say"), { childList: true });
  new PerformanceObserver((l) => l.getEntries().forEach((e) => w.lt.push(e.duration))).observe({ entryTypes: ["longtask"] });
});
const q = (l, p) => { const s = [...l].sort((a, b) => a - b); return s.length ? s[Math.min(s.length - 1, Math.floor(p * s.length))].toFixed(1) : "-"; };
const cdp = await page.context().newCDPSession(page);
for (const name of names) {
  const slider = page.getByRole("slider", { name, exact: true });
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox(), at = Number(await slider.inputValue()) / 1000, middle = Math.min(0.9, Math.max(0.1, at)), y = box.y + box.height / 2;
  if (process.env.CPU) { await cdp.send("Profiler.enable"); await cdp.send("Profiler.setSamplingInterval", { interval: 200 }); await cdp.send("Profiler.start"); }
  if (process.env.TRACE) await browser.startTracing(page, { path: process.env.TRACE, categories: ["devtools.timeline", "disabled-by-default-devtools.timeline", "blink.user_timing", "v8", "cc", "viz", "gpu", "latencyInfo"] });
  await page.evaluate(() => { window.delays.length = 0; window.fetches.length = 0; window.inputs.length = 0; window.lt.length = 0; });
  await page.mouse.move(box.x + middle * box.width, y); await page.mouse.down();
  for (let i = 0; i < 120; i++) { await page.mouse.move(box.x + (middle + 0.08 * Math.sin(i / 6)) * box.width, y); await page.waitForTimeout(16); }
  await page.mouse.move(box.x + middle * box.width, y); await page.mouse.up(); await page.waitForTimeout(800);
  if (process.env.TRACE) await browser.stopTracing();
  if (process.env.CPU) { const { profile } = await cdp.send("Profiler.stop"); writeFileSync(process.env.CPU, JSON.stringify(profile)); }
  const r = await page.evaluate(() => ({ delays: window.delays.splice(0), fetches: window.fetches.splice(0), inputs: window.inputs.splice(0), lt: window.lt.splice(0) }));
  const d = r.delays.map((x) => x[0]), raf = r.delays.map((x) => x[1]);
  console.log(`${name}: n ${d.length} median ${q(d, .5)} p95 ${q(d, .95)} max ${q(d, 1)}; to raf ${q(raf, .5)} ${q(raf, .95)}; input delay ${q(r.inputs.map((x) => x[1] - x[0]), .5)} ${q(r.inputs.map((x) => x[1] - x[0]), .95)}; longtasks ${r.lt.map((x) => x.toFixed(0))}`);
  for (const c of new Set(r.fetches.map((x) => x[0]))) { const m = r.fetches.filter((x) => x[0] === c); console.log(`   ${c}: n ${m.length} headers ${q(m.map((x) => x[2] - x[1]), .5)} ${q(m.map((x) => x[2] - x[1]), .95)}; whole ${q(m.map((x) => x[3] - x[1]), .5)} ${q(m.map((x) => x[3] - x[1]), .95)}; bytes ${m[0][4]} req ${m[0][5]}`); }
}
await browser.close(); site.end();
