// The working tree's page, to look at: PORT=8080 MCKIBBEN=… node tests/look.mjs
process.env.PAGE ??= "web/page";
const [{ served }, { program }] = await Promise.all([
  import("./browser.mjs"),
  import("./sites.mjs"),
]);
console.log((await served(program)).url);
