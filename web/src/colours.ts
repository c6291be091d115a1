// Colours of figures. Along a scale they are those of matplotlib's plasma (Smith, van der Walt, Firing; CC0): even steps to
// the eye, also for the colour-blind.

export type Rgb = readonly [number, number, number]; // 0 to 1

export function rgbOf(hex: string): Rgb {
  const number = parseInt(hex.slice(1), 16);
  return [((number >> 16) & 255) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}

export function hexOf(rgb: Rgb): string {
  return `#${rgb.map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;
}

const PLASMA = ["#0d0887", "#41049d", "#6a00a8", "#8f0da4", "#b12a90", "#cc4778", "#e16462", "#f2844b", "#fca636", "#fcce25"].map(rgbOf);

export const mixed = (a: Rgb, b: Rgb, share: number): Rgb => [
  a[0] + share * (b[0] - a[0]),
  a[1] + share * (b[1] - a[1]),
  a[2] + share * (b[2] - a[2]),
];

// On dark ground the scale begins where it can be seen, on light ground it ends there.
export function scaleColour(share: number, dark: boolean): Rgb {
  const clamped = Math.min(1, Math.max(0, Number.isFinite(share) ? share : 0));
  const steps = PLASMA.length - 1;
  const at = dark ? 2.4 + clamped * (steps - 2.4) : clamped * (steps - 1);
  const i = Math.min(steps - 1, Math.floor(at));
  return mixed(PLASMA[i]!, PLASMA[i + 1]!, at - i);
}

export function luminance([r, g, b]: Rgb): number {
  const linear = (part: number): number => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

const SHARES = 40;
const DARKEST = 0.1; // of the bound on light ground: what is darker is seen well as it is

// A colour of parts so that it stands out from the ground by 3 to 1 (WCAG 1.4.11), and lighter ones stay lighter than others:
// on light ground all are darkened in proportion, on dark ground lightened.
export function visibleOn(colour: Rgb, ground: Rgb): Rgb {
  const below = luminance(ground);
  const isDark = below < 0.2;
  const bound = isDark ? 3 * (below + 0.05) - 0.05 : (below + 0.05) / 3 - 0.05;
  const wanted = isDark ? bound + (1 - bound) * luminance(colour) : bound * (DARKEST + (1 - DARKEST) * luminance(colour));
  for (let i = 0; i <= SHARES; ++i) {
    const shown = mixed(colour, isDark ? [1, 1, 1] : [0, 0, 0], i / SHARES);
    if (isDark ? luminance(shown) >= wanted : luminance(shown) <= wanted) return shown;
  }
  return isDark ? [1, 1, 1] : [0, 0, 0];
}

const TOOLS = ["#7a7f87", "#1f77b4", "#d95f02", "#1b9e77", "#c51b7d", "#7570b3", "#8c6d1f", "#17a2b8", "#e7298a"].map(rgbOf);
export const toolColour = (tool: number): Rgb => (tool === 0 ? TOOLS[0]! : TOOLS[1 + ((tool - 1) % (TOOLS.length - 1))]!);
