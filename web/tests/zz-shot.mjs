import { alive, launch, served, tab } from "./browser.mjs";
const [,, out, hash = "#muscle", width = "1440", scheme = "light", height="900"] = process.argv;
const site = await served(process.env.MCKIBBEN);
const browser = await launch();
const { page, errors } = await tab(browser, { viewport: { width: +width, height: +height }, colorScheme: scheme });
await page.goto(site.url + hash); if (/muscle/.test(hash)) await alive(page); await page.waitForTimeout(2500);
if (process.env.DRAG) { await page.evaluate(() => { const s = document.querySelector(".controls input[type=range]"); setInterval(() => { s.value = String(400 + 5 * Math.random()); s.dispatchEvent(new Event("input", { bubbles: true })); }, 60); }); await page.waitForTimeout(1500); }
if (process.env.EVAL) await page.evaluate(process.env.EVAL), await page.waitForTimeout(1200);
if (process.env.SEL) await page.locator(process.env.SEL).first().screenshot({ path: out }); else await page.screenshot({ path: out });
console.log(errors); await browser.close(); site.end();
