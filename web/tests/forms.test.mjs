// Forms against the program's schema: their lists are the page's choice of what to ask, with its examples and defaults; what a field is, its unit and
// its words to choose from the schema says.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { before, test } from "node:test";
import { program } from "./sites.mjs";

/** @typedef {import("../page/js/form.js").Field} Field */
/** @type {any} */ let schema;
const listen = { addEventListener() {} };

before(() => {
  schema = JSON.parse(execFileSync(program, ["schema"], { encoding: "utf8", maxBuffer: 1e8 }));
  // Modules of pages ask the document when they are mounted only.
  Object.assign(globalThis, {
    window: { ...globalThis, ...listen },
    document: { ...listen, getElementById() {} },
    location: { hash: "" },
    history: { state: null },
    sessionStorage: { getItem() {}, setItem() {} },
    matchMedia: () => ({ matches: false, ...listen }),
  });
});

/** What may be there besides null, with references followed. @param {any} of @returns {any[]} */
function kinds(of) {
  if (of.$ref)
    return kinds(schema.$defs[of.$ref.split("/").pop()]).map((one) => ({
      ...one,
      "x-quantity": of["x-quantity"] ?? one["x-quantity"],
    }));
  const several = of.anyOf ?? of.oneOf;
  if (several)
    return several
      .flatMap(kinds)
      .map((/** @type {any} */ one) => ({ "x-quantity": of["x-quantity"], ...one }));
  return [of];
}
/** @param {any} of */
const types = (of) =>
  kinds(of)
    .flatMap((one) => one.type ?? [])
    .filter((type) => type !== "null");
/** Words that it may be; nothing where any may. @param {any} of @returns {string[] | undefined} */
function words(of) {
  const all = kinds(of).flatMap((one) => one.enum ?? (one.const !== undefined ? [one.const] : []));
  return all.length ? all : undefined;
}

/** @param {Field} field @param {any} properties @param {string} where */
function check({ field, kind, list, words: isList, options, value, pair, or }, properties, where) {
  const of = properties[field];
  assert.ok(of, `${where} has no ${field}`);
  const quantity = kinds(of)
    .map((one) => one["x-quantity"])
    .find(Boolean);
  // Ratios have no unit, and neither have plain numbers.
  const said =
    kind === "modulus" ? "pressure" : kind === "number" || kind === "ratio" ? undefined : kind;
  if (said && quantity) assert.equal(quantity, said, `${where} ${field}`);
  if (said && !quantity && !or && !list)
    assert.fail(`${where} ${field}: the schema states no ${said}`);
  if (kind && !list)
    assert.ok(
      types(of).includes("number") || or,
      `${where} ${field} is no number but ${types(of)}`,
    );
  if (list || isList || pair)
    assert.ok(types(of).includes("array"), `${where} ${field} is no list`);
  for (const [word] of options ?? [])
    if (word && words(of))
      assert.ok(words(of)?.includes(word), `${where} ${field} is never ${word}`);
  for (const word of or ?? [])
    assert.ok(words(of)?.includes(word), `${where} ${field} is never ${word}`);
  if (options && words(of) && value)
    assert.ok(words(of)?.includes(value), `${where} ${field}: ${value}`);
  for (const [one, name] of pair ?? []) {
    const item = kinds(of).flatMap((k) => (k.items ? kinds(k.items) : []))[0]?.properties[name];
    assert.ok(item, `${where} ${field} has no ${name}`);
    if (one !== "ratio") assert.equal(item["x-quantity"], one, `${where} ${field} ${name}`);
  }
}

test("fields of all forms are fields of their requests, with their quantity, their lists and their words", async () => {
  const page = (/** @type {string} */ name) =>
    import(`../page/js/${name === "files" ? "" : "pages/"}${name}.js`);
  const of = (/** @type {string} */ command) => schema[command].request.properties;
  const [design, motion, data, rubber, files] = await Promise.all(
    ["design", "motion", "data", "rubber", "files"].map(page),
  );
  // Version 4 of the interface; an engine before it has no chance.
  const asked = design
    .choices()
    .filter((/** @type {Field} */ f) => f.field !== "certainty" || "certainty" in of("design"));
  const step = kinds(of("motion").step)[0].properties;
  /** @type {[string, Field[], any][]} */
  const forms = [
    ["design", [...design.WANTED, ...asked], of("design")],
    ["motion", motion.STEP.filter(({ field }) => field !== "model"), step],
    ["rubber", rubber.FIELDS, of("rubber")],
    ["identify", data.FIELDS.filter(({ field }) => field === "free"), of("identify")],
    ["compare", data.FIELDS.filter(({ field }) => field === "models"), of("compare")],
    ["build", files.TITLE, of("build")],
    ["export", files.BOX, of("export")],
    ["simulate", files.ELEMENTS, of("simulate")],
  ];
  let count = 0;
  for (const [where, fields, properties] of forms)
    for (const field of fields) {
      check(field, properties, where);
      count++;
    }
  assert.ok(count >= 40, `${count} fields`);
});
