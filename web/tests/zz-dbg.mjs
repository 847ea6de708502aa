import { alive, launch, served, tab } from "./browser.mjs";
const site = await served(process.env.MCKIBBEN); const browser = await launch(); const { page } = await tab(browser);
await page.route("**/bench/dimensions.js", async (r) => { const a = await r.fetch(); let t = await a.text(); t = t.replace("return low;", "console.log(JSON.stringify({rest, now: now/degree, ahead, across, radius, low, ratio, share})); return low;"); await r.fulfill({ response: a, body: t }); });
page.on("console", (m) => console.log(m.text()));
await page.goto(site.url + "#muscle"); await alive(page); await page.waitForTimeout(1500);
const box = await page.locator(".dimensions circle").nth(3).boundingBox(); const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
await page.mouse.move(x, y); await page.mouse.down(); await page.mouse.move(x - 6, y + 3, { steps: 4 }); await page.mouse.up(); await page.waitForTimeout(500);
await browser.close(); site.end();
