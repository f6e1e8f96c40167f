/* Lengths as people type them. */
const LENGTH = /^\s*(\d+(?:[.,]\d*)?|[.,]\d+)\s*(mm|cm|m|in|inch|"|″)?\s*$/i;
const NAMES = { inch: "in", "\"": "in", "″": "in" };

/* {value, unit} of "40", "40,5" or "1.5 in" in a unit; null for nothing, undefined for what is no length */
export function lengthOf(text, unit) {
  if (!String(text).trim()) return null;
  const match = LENGTH.exec(text), value = match && Number(match[1].replace(",", "."));
  if (!match || !(value > 0)) return undefined;
  const said = match[2]?.toLowerCase();
  return { value, unit: said ? NAMES[said] || said : unit };
}

/* millimetres of each unit */
export const MILLIMETRES = { mm: 1, cm: 10, m: 1000, in: 25.4 };

/* a size put into an object: in the object's unit where another size has it already, else in the unit it was told in */
export function given(object, name, size) {
  if (!size) { object.sizes[name] = ""; return; }
  const others = Object.keys(object.sizes).some(n => n !== name && object.sizes[n]);
  if (!others) object.unit = size.unit;
  object.sizes[name] = String(Number((size.value * MILLIMETRES[size.unit] / MILLIMETRES[object.unit]).toPrecision(9)));
}

/* a number with four digits, without zeros that say nothing */
export const shown = x => String(Number(Number(x).toPrecision(4)));

/* a length in its unit; a pixel is no unit that anybody measures in */
export const measure = (x, unit) => unit === "px" ? String(Math.round(x)) : `${shown(x)} ${unit}`;
