/** A format of tables by what separates their cells: `parseRows` and `formatRows` of d3-dsv. */
export function dsvFormat(separator: string): {
  parseRows(text: string): string[][];
  formatRows(rows: readonly (readonly unknown[])[]): string;
};
