// Round numbers.

/** The next of 1, 2, 2.5, 5 times a power of ten. @param {number} x */
export function niceUp(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([1, 2, 2.5, 5, 10].find((m) => m * power >= x * 0.999) ?? 10);
}
/** To two digits. @param {number} x */
export const twoDigits = (x) => Number(x.toPrecision(2));
