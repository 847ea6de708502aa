// Drawings as text.

/**
 * An element with its attributes, but for those without a value.
 * @param {string} tag @param {Record<string, string | number | undefined>} attributes
 * @param {string[]} inside
 */
export function svg(tag, attributes, ...inside) {
  const said = Object.entries(attributes).flatMap(([name, value]) =>
    value === undefined ? [] : ` ${name}="${value}"`,
  );
  return `<${tag}${said.join("")}>${inside.join("")}</${tag}>`;
}
/** @param {string} d @param {string} [kind] its class */
export const path = (d, kind) => svg("path", { d, class: kind });
/** @param {string} text @param {number} x @param {number} y @param {string} [anchor] */
export const words = (text, x, y, anchor) =>
  svg("text", { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor }, text);
