// What is drawn on, and with: the colours of the theme for what no style sheet reaches.
import type { Rgb } from "../colours.ts";

export interface Ground {
  readonly rgb: Rgb;
  readonly dark: boolean;
  readonly accent: string;
  readonly faint: string;
  readonly text: string;
}
