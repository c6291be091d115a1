// How the page is read: units, themes, contrast, what is in it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fragmentOf, SOURCE, goTo, openReport, pocket, programFile, shown, textOf } from "./report.ts";

// Texts on the page that are less than 4.5 to 1 from their ground (WCAG 2, 1.4.3). Runs in the page.
function faintWords(): string[] {
  const numbers = (colour: string): number[] => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]: number[]): number => {
    const linear = [r!, g!, b!].map((part) => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * linear[0]! + 0.7152 * linear[1]! + 0.0722 * linear[2]!;
  };
  const roots: (Document | ShadowRoot)[] = [document, ...[...document.querySelectorAll("*")].flatMap((element) => (element.shadowRoot ? [element.shadowRoot] : []))];
  const faint: string[] = [];
  for (const element of roots.flatMap((root) => [...root.querySelectorAll<HTMLElement>("*")])) {
    const words = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE && node.textContent!.trim() !== "").map((node) => node.textContent!.trim());
    if (words.length === 0 || !element.checkVisibility() || /^(script|style|noscript|option)$/i.test(element.tagName)) continue;
    let opacity = 1;
    let ground: number[] | null = null;
    for (let at: Element | null = element; at; at = at.parentElement ?? (at.getRootNode() as ShadowRoot).host ?? null) {
      const style = getComputedStyle(at);
      opacity *= Number(style.opacity);
      const colour = numbers(style.backgroundColor);
      if (!ground && style.backgroundColor.startsWith("rgb") && (colour[3] ?? 1) > 0.5) ground = colour;
    }
    const style = getComputedStyle(element);
    const [above, below] = [light(numbers(style.color)), light(ground ?? [255, 255, 255])];
    const ratio = (Math.max(above, below) + 0.05) / (Math.min(above, below) + 0.05);
    if (ratio < 4.5 || opacity < 0.99) faint.push(`${words[0]}: ${ratio.toFixed(2)}, opacity ${opacity}`);
  }
  return faint;
}

test("says that the text was left out, and works without it", async () => {
  const { page, said } = await openReport(["--no-source", pocket]);
  await goTo(page, 30_000);
  assert.match((await page.locator(".program-view .empty").textContent())!, /not in this report. The tool is in line 44\./);
  assert.match((await page.locator(".what").textContent())!, /without the program.s text/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says where the browser has no WebGL, and shows all but the path", async () => {
  const { page } = await openReport([pocket]);
  await page.addInitScript(() => {
    const contextOf = HTMLCanvasElement.prototype.getContext as (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) => RenderingContext | null;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith("webgl") ? null : contextOf.call(this, kind, ...rest);
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
  await page.reload();
  await page.waitForSelector("header");
  await goTo(page, 30_000);
  assert.match((await page.locator(".space-panel .empty").textContent())!, /no WebGL/);
  assert.equal(await page.locator(".path-view").count(), 0);
  assert.match(await textOf(page, "limit-now"), /\w/);
  await page.context().close();
});

test("stays at its head where it is too narrow for panels side by side", async () => {
  const { page, said } = await openReport([pocket]);
  await page.setViewportSize({ width: 820, height: 900 });
  await page.reload();
  await page.waitForSelector("header");
  for (const tick of [60_000, 400, 105_000]) {
    await goTo(page, tick);
    await page.waitForTimeout(300);
    assert.equal(await page.evaluate(() => scrollY), 0);
  }
  await page.locator(".program-view").evaluate((panel) => panel.scrollIntoView());
  for (const tick of [60_000, 400, 105_000]) {
    await goTo(page, tick);
    await page.waitForTimeout(300);
    const isSeen = await page.locator(".cm-now").evaluate((line) => {
      const at = line.getBoundingClientRect();
      const panel = line.closest(".cm-scroller")!.getBoundingClientRect();
      return at.top >= panel.top && at.bottom <= panel.bottom;
    });
    assert.ok(isSeen, `the line of tick ${tick}`);
  }
  assert.deepEqual(said, []);
  await page.context().close();
});

test("goes where a link to another place of the same page leads", async () => {
  const { page, said } = await openReport([pocket]);
  await Promise.all([page.waitForEvent("load"), page.evaluate(() => (location.hash = "tick=1000&theme=dark"))]);
  await page.waitForSelector("header");
  assert.match(await fragmentOf(page), /tick=1000/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset["theme"]), "dark");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("shows inches, feeds per second and the dark theme, and keeps them in the address", async () => {
  const { page, said } = await openReport([pocket]);
  await page.locator("button", { hasText: /^inch$/ }).click();
  await page.locator("button", { hasText: /^\/s$/ }).click();
  await page.locator("select[aria-label=Theme]").selectOption("dark");
  await page.locator("[data-test=colour]").selectOption("limit");
  // 27 mm are 1.0630 in.
  assert.ok(shown(await textOf(page, "extents")).includes("X -1.0630 to 1.0630"));
  assert.match((await page.locator(".chart-name").first().textContent())!, /in\/s/);
  const fragment = await fragmentOf(page);
  const again = await openReport([pocket], fragment);
  assert.equal(await again.page.evaluate(() => document.documentElement.dataset["theme"]), "dark");
  assert.match((await again.page.locator(".legend-title").textContent())!, /limits the feed/);
  assert.ok(shown(await textOf(again.page, "extents")).includes("1.0630"));
  assert.deepEqual([...said, ...again.said], []);
  await page.context().close();
  await again.page.context().close();
});

for (const theme of ["light", "dark"]) {
  test(`is legible in the ${theme} theme: 4.5 to 1`, async () => {
    const { page } = await openReport([pocket], `#theme=${theme}&colour=limit`);
    const found: string[] = [];
    for (const tab of ["program", "answer"]) {
      await page.locator(`[data-tab=${tab}]`).click();
      found.push(...(await page.evaluate(faintWords)));
    }
    await page.locator(".legend.parts button").first().click();
    found.push(...(await page.evaluate(faintWords)));
    assert.deepEqual(found, []);
    await page.context().close();
  });
}

test("names the licences of what it is made of", async () => {
  const { page } = await openReport([pocket]);
  await page.locator("button", { hasText: "About" }).click();
  const about = (await page.locator("dialog").textContent())!;
  for (const name of ["three", "uplot", "@codemirror/view", "MIT"]) assert.ok(about.includes(name), name);
  assert.match(about, /Permission is hereby granted/);
  await page.context().close();
});

test("is small for a butterfly", async () => {
  const { page, size } = await openReport([join(SOURCE, "programs", "butterfly.ngc")]);
  assert.ok(size <= 2_000_000, `${size} bytes`);
  await page.context().close();
});

test("can be used from the keyboard alone", async () => {
  const { page, said } = await openReport([pocket], "#tick=1000");
  const tick = async (): Promise<number> => Number(await page.locator(".instant").getAttribute("data-tick"));
  const view = async (): Promise<string> => new URLSearchParams((await fragmentOf(page)).slice(1)).get("view") ?? "";
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  assert.equal(await tick(), 1002);
  await page.keyboard.press(",");
  assert.equal(await tick(), 1001);
  const seen: Buffer[] = [];
  for (const key of ["1", "2", "3", "4"]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(150);
    seen.push(await page.locator(".path-view canvas").first().screenshot());
  }
  seen.forEach((one, i) => assert.ok(!one.equals(seen[(i + 1) % 4]!), `view ${i + 1} is one of its own`));
  await page.keyboard.press("f");
  assert.equal(await view(), "", "what is fitted needs no words");
  // All that can be clicked is reached, in an order, and shows that it is.
  const reached: string[] = [];
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    reached.push(
      await page.evaluate(() => {
        const at = document.activeElement!;
        return at === document.body ? "" : `${at.tagName.toLowerCase()} ${at.getAttribute("aria-label") ?? at.textContent}`;
      }),
    );
  }
  for (const wanted of ["select Theme", "button top", "button Play", "input Instant", "button Program"]) {
    assert.ok(reached.some((one) => one.startsWith(wanted)), `${wanted} among ${reached.join("; ")}`);
  }
  await page.locator("[data-tab=answer]").focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator("[data-test=lines]").isVisible(), true);
  assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement!).outlineStyle), "none");
  await page.locator("[data-tab=program]").click();
  await page.locator(".program-view .cm-content").focus();
  const line = await textOf(page, "instant");
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await textOf(page, "instant"), line);
  assert.deepEqual(said, []);
  await page.context().close();
});

for (const [width, height] of [[1280, 720], [1024, 768], [768, 1024]] as const) {
  test(`has all of its parts at ${width} by ${height}, none wider than the page, none in small print`, async () => {
    const { page, said } = await openReport([pocket], "#colour=limit");
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(200);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
    for (const part of [".strip", ".path-view", ".time-view", ".program-view", ".legend"]) {
      const box = (await page.locator(part).boundingBox())!;
      assert.ok(box.width >= 150 && box.height >= 60 && box.x >= 0 && box.x + box.width <= width + 1, `${part}: ${JSON.stringify(box)}`);
    }
    const small = await page.evaluate(() =>
      [...document.querySelectorAll<HTMLElement>("#app *")].filter((one) => one.checkVisibility() && one.textContent!.trim() !== "" && parseFloat(getComputedStyle(one).fontSize) < 12).map((one) => one.textContent),
    );
    assert.deepEqual(small, []);
    assert.deepEqual(said, []);
    await page.context().close();
  });
}

// With a tool change, a rest and a rapid, a deviation, and places with all of their digits.
const LONG_FIGURES = "G21 G90 F6000\nT1 M6\nG1 X10\nG4 P2\nT2 M6\nG1 X20.123 Y-431.001\nG0 X0 Z-123.456\nM30\n";

for (const [width, height] of [[1280, 720], [1024, 768], [768, 1024]] as const) {
  test(`shows all of the answer at ${width} by ${height}, where the work offset may lie, and the band of limits`, async () => {
    const table = readFileSync(join(SOURCE, "programs/machines/table.toml"), "utf8");
    const changer = programFile(`[program]\ntool_change_s = 3\n${table.replace(/^\[program\]$/m, "")}`, "changer.toml");
    for (const words of [[pocket], [programFile(LONG_FIGURES), pocket, "--machine", changer], [programFile("G21 G90 F6000\nG1 X520\nG1 X-100\nM30\n")]]) {
      const { page, said } = await openReport(words, "#colour=limit");
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(200);
      const clipped = (): Promise<(string | null)[]> =>
        page.locator(".strip, .strip .card, .strip .card *").evaluateAll((all) =>
          all.filter((one) => one.textContent !== "" && getComputedStyle(one).display !== "inline" && (one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 2)).map((one) => one.textContent),
        );
      assert.deepEqual(await clipped(), []);
      await page.locator("button", { hasText: /^inch$/ }).click();
      assert.deepEqual(await clipped(), [], "in inches");
      assert.match(shown((await page.locator("[data-test=fit]").textContent())!), /G54 betweenX -?[\d.]+ to -?[\d.]+/);
      if ((await page.locator(".band").isVisible()) || words.length > 1) {
        const [band, panel, charts] = await Promise.all([".band-row", ".time-panel", ".charts"].map(async (one) => (await page.locator(one).boundingBox())!));
        assert.ok(band!.height >= 24 && band!.y + band!.height <= panel!.y + panel!.height, JSON.stringify({ band, panel }));
        assert.ok(width < 1000 || band!.y + band!.height <= height, "without scrolling");
        assert.ok(band!.y + band!.height <= charts!.y + charts!.height + 1);
        assert.equal(await page.locator(".band-row .chart-name").isVisible(), true);
      }
      assert.deepEqual(said, []);
      await page.context().close();
    }
  });
}
