// What stands beside the lines of the program that are seen.
import type { Page } from "playwright-core";

// Their times; empty: none.
export const timesOfLines = (page: Page): Promise<string[]> =>
  page.locator(".program-view .cm-line").evaluateAll((lines) => {
    const marks = [...lines[0]!.closest(".cm-scroller")!.querySelectorAll(".cm-times .cm-gutterElement")].filter((one) => getComputedStyle(one).visibility !== "hidden");
    const top = (element: Element): number => element.getBoundingClientRect().top;
    return lines.map((line) => marks.find((one) => Math.abs(top(one) - top(line)) < 3)?.textContent ?? "");
  });
