// Numbers with units as an operator reads them.

export interface Units {
  readonly length: "mm" | "inch";
  readonly time: "s" | "min"; // of feeds
}

export const USUAL_UNITS: Units = { length: "mm", time: "min" };

// Of "inch/min" and the like.
export const unitsNamed = (name: string): Units => ({ length: name.startsWith("inch") ? "inch" : "mm", time: name.endsWith("/s") ? "s" : "min" });

export const MM_PER_INCH = 25.4;
// A proper minus sign, and no negative zero.
const sign = (text: string): string => (Number(text) === 0 ? text.replace("-", "") : text.replace("-", "\u2212"));

// About `digits` significant digits, without an exponent.
export function plain(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "\u2013";
  if (value === 0) return "0";
  const decimals = Math.max(0, Math.min(6, digits - 1 - Math.floor(Math.log10(Math.abs(value)))));
  const text = sign(value.toFixed(decimals));
  return Number(text) === 0 ? "0" : text;
}

export const fixed = (value: number, decimals: number): string => sign(value.toFixed(decimals));

export function lengthText(mm: number, units: Units): string {
  return fixed(fromMm(mm, units), decimalsOf(units));
}

export const fromMm = (mm: number, units: Units): number => (units.length === "mm" ? mm : mm / MM_PER_INCH);
const decimalsOf = (units: Units): number => (units.length === "mm" ? 3 : 4);

// A bound that is written so is kept by what lies within it.
export function boundOf(mm: number, bound: "least" | "most", units: Units): number {
  const scale = 10 ** decimalsOf(units);
  const scaled = fromMm(mm, units) * scale;
  const rounding = 1e-6;
  return (bound === "least" ? Math.ceil(scaled - rounding) : Math.floor(scaled + rounding)) / scale;
}
export const boundText = (mm: number, bound: "least" | "most", units: Units): string => fixed(boundOf(mm, bound, units), decimalsOf(units));

export const lengthUnit = (units: Units): string => (units.length === "mm" ? "mm" : "in");

// "1:02:03.4", "2:03.45", "3.456 s"; from a minute on with other decimals where they are given.
export function clock(seconds: number, given?: number): string {
  const s = Math.max(0, seconds);
  if (s < 60) return `${s.toFixed(3)} s`;
  const decimals = given ?? (s < 3600 ? 2 : 1);
  const whole = Number(s.toFixed(decimals));
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor((whole % 3600) / 60);
  const rest = (whole % 60).toFixed(decimals).padStart(decimals > 0 ? decimals + 3 : 2, "0");
  return hours > 0 ? `${hours}:${String(minutes).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}

// Of a key of JSON: "path jerk".
export const wordsOf = (key: string): string => key.replaceAll("_", " ");

// Short, for one line of a program: "0.035", "12.3", "2:03".
export function shortTime(seconds: number): string {
  if (seconds < 0.9995) return seconds.toFixed(3);
  if (seconds < 9.995) return seconds.toFixed(2);
  return seconds < 59.95 ? seconds.toFixed(1) : clock(Math.max(60, seconds), 0); // what rounds to a minute is one
}

// The same of an estimate, with no digits that it does not have: "\u22480.035", "\u224812", "\u22482:03".
export function roughTime(seconds: number): string {
  const decimals = seconds < 0.0995 ? 3 : seconds < 0.995 ? 2 : seconds < 9.95 ? 1 : 0;
  return `\u2248${seconds < 59.5 ? seconds.toFixed(decimals) : clock(Math.max(60, seconds), 0)}`;
}

// "+0.250 s, 4.81 %"; nothing where both are the same.
export function difference(base_s: number, other_s: number): string {
  const more_s = other_s - base_s;
  if (Math.abs(more_s) < 5e-7) return "";
  const share = base_s > 0 ? `, ${plain((100 * Math.abs(more_s)) / base_s, 3)}\u00a0%` : "";
  return `${more_s < 0 ? "\u2212" : "+"}${clock(Math.abs(more_s))}${share}`;
}

export interface Quantified {
  readonly factor: number; // from mm and s
  readonly unit: string;
}

// The unit of a quantity along the path or of an axis. Only feeds are told per minute.
export function unitOf(quantity: "v" | "a" | "j" | "length", axisUnit: "mm" | "deg", units: Units): Quantified {
  const isLength = axisUnit === "mm";
  const factor = isLength && units.length === "inch" ? 1 / MM_PER_INCH : 1;
  const name = isLength ? lengthUnit(units) : "\u00b0";
  switch (quantity) {
    case "length":
      return { factor, unit: name };
    case "v":
      return units.time === "min" ? { factor: factor * 60, unit: `${name}/min` } : { factor, unit: `${name}/s` };
    case "a":
      return { factor, unit: `${name}/s\u00b2` };
    case "j":
      return { factor, unit: `${name}/s\u00b3` };
  }
}

export const percent = (share: number): string => `${(100 * share).toFixed(share < 0.0995 && share > 0 ? 1 : 0)}\u00a0%`;
