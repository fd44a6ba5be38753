/** Numbers and times as text, with real minus signs. */

export function capital(text) {
  return `${text[0]?.toUpperCase() ?? ""}${text.slice(1)}`;
}

export function fixed(value, digits) {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? (0).toFixed(digits) : text).replace("-", "\u2212");
}

/** Fill in the fields, in braces, of a sentence that Python provides. */
export function filled(text, fields) {
  return text.replace(/\{(\w+)\}/g, (_, name) => fields[name]);
}

/** Four significant digits at most, without zeros at the end. */
export function short(value) {
  const text = Number(value.toPrecision(4));
  const size = Math.abs(text);
  const written = size !== 0 && (size >= 1e5 || size < 1e-3) ? value.toExponential(2) : String(text);
  return written.replaceAll("-", "\u2212");
}

let readingUnits = {};

/** Set the legible units, which the package provides. */
export function takeUnits(units) {
  readingUnits = units;
}

/** The legible unit for values in an SI unit, by the largest one, and its factor; same rules as forficula.quantities. */
function readingUnit(si, largest) {
  const units = readingUnits[si];
  const fits = ([, scale, least]) => (largest === 0 ? scale === 1 : largest >= least);
  const [unit, factor] = units.find(fits) ?? (largest === 0 ? units[0] : units.at(-1));
  return { unit, factor };
}

/** The factor from SI of a unit by its name. */
export function unitFactor(name) {
  return Object.values(readingUnits).flat().find(([unit]) => unit === name)[1];
}

/** A value, SI, in a legible unit. */
export function readable(value, si) {
  const { unit, factor } = readingUnit(si, Math.abs(value));
  return `${short(factor * value)} ${unit}`;
}

/** The legible unit for the times of a span, and its factor from s; a span of another quantity names its unit. */
export function timeUnit(span) {
  if (span.unit) return { unit: span.unit, factor: 1 };
  return readingUnit("s", Math.max(Math.abs(span.start), Math.abs(span.end)));
}

/** A time of a span, to about a thousandth of the span. */
export function timeText(moment, span) {
  const { unit, factor } = timeUnit(span);
  const digits = Math.ceil(2.7 - Math.log10(factor * (span.end - span.start)));
  return `${fixed(factor * moment, Math.min(6, Math.max(0, digits)))} ${unit}`;
}
