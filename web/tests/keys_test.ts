// The page without a mouse: what the keys do in the path, in the charts and on the tabs.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { Page } from "playwright-core";
import { chartAfter } from "../src/views/chart_keys.ts";
import { fragmentOf, SOURCE, openReport, pocket } from "./report.ts";

const words = async (page: Page): Promise<URLSearchParams> => new URLSearchParams((await fragmentOf(page)).slice(1));
const tickOf = async (page: Page): Promise<number> => Number(await page.locator(".instant").getAttribute("data-tick"));

test("a key moves the instant by a hundredth of what the charts show, at least by a tick, and never out of the program", () => {
  const chart = { tick: 500, span: { from: 0, to: 1000 }, last: 1000 };
  assert.deepEqual(chartAfter("ArrowRight", false, chart), { tick: 510, span: { from: 0, to: 1000 } });
  assert.deepEqual(chartAfter("ArrowLeft", false, { ...chart, tick: 4 }), { tick: 0, span: { from: 0, to: 1000 } });
  assert.equal(chartAfter("ArrowRight", false, { tick: 50, span: { from: 46, to: 54 }, last: 1000 })!.tick, 51);
  assert.equal(chartAfter("End", false, chart)!.tick, 1000);
  assert.equal(chartAfter("Home", false, chart)!.tick, 0);
  assert.equal(chartAfter("x", false, chart), null);
});

test("the charts follow the instant where a key moves it out of what they show", () => {
  const chart = { tick: 299, span: { from: 100, to: 300 }, last: 1000 };
  assert.deepEqual(chartAfter("ArrowRight", false, chart), { tick: 301, span: { from: 201, to: 401 } });
  assert.deepEqual(chartAfter("End", false, chart), { tick: 1000, span: { from: 800, to: 1000 } });
});

test("plus and minus zoom about the instant, which stays where it is seen", () => {
  const chart = { tick: 300, span: { from: 200, to: 600 }, last: 1000 };
  const { tick, span } = chartAfter("+", false, chart)!;
  assert.equal(tick, 300);
  assert.ok(span.to - span.from < 400);
  assert.ok(Math.abs((300 - span.from) / (span.to - span.from) - 0.25) < 1e-9);
  const back = chartAfter("-", false, { ...chart, span })!.span;
  assert.ok(Math.abs(back.from - 200) < 1e-9 && Math.abs(back.to - 600) < 1e-9);
  assert.deepEqual(chartAfter("ArrowUp", false, chart), chartAfter("+", false, chart));
  assert.deepEqual(chartAfter("ArrowDown", false, chart), chartAfter("-", false, chart));
});

test("with Shift the arrow keys move what the charts show and leave the instant", () => {
  const chart = { tick: 300, span: { from: 200, to: 600 }, last: 1000 };
  assert.deepEqual(chartAfter("ArrowRight", true, chart), { tick: 300, span: { from: 240, to: 640 } });
  assert.deepEqual(chartAfter("ArrowLeft", true, chart), { tick: 300, span: { from: 160, to: 560 } });
});

test("the arrow keys turn the path, with Shift they move it, plus and minus zoom, and the address keeps it", async () => {
  const { page, said } = await openReport([pocket]);
  await page.locator(".path-view canvas").first().focus();
  const pressed = async (key: string): Promise<number[]> => {
    await page.keyboard.press(key);
    return (await words(page)).get("view")!.split(",").map(Number);
  };
  const direction = ([px, py, pz, tx, ty, tz]: number[]): number[] => [px! - tx!, py! - ty!, pz! - tz!];
  const near = (a: readonly number[], b: readonly number[]): boolean => a.every((one, i) => Math.abs(one - b[i]!) <= 1e-3 * Math.max(...b.map(Math.abs)));
  const right = await pressed("ArrowRight");
  const further = await pressed("ArrowRight");
  assert.ok(!near(direction(right), direction(further)), "turned");
  assert.ok(near([further[5]!, further[6]!], [right[5]!, right[6]!]), "neither moved nor zoomed");
  assert.ok(near(direction(await pressed("ArrowLeft")), direction(right)), "and back");
  const down = await pressed("ArrowDown");
  assert.ok(down[2]! > right[2]!, "seen from further above, as if it was dragged down");
  assert.ok(near(direction(await pressed("ArrowUp")), direction(right)));
  const moved = await pressed("Shift+ArrowRight");
  assert.ok(near(direction(moved), direction(right)), "not turned");
  assert.ok(Math.hypot(moved[3]! - right[3]!, moved[4]! - right[4]!) * moved[6]! > 10, "by some pixels");
  const nearer = await pressed("+");
  assert.ok(nearer[6]! > moved[6]!);
  assert.ok(Math.abs((await pressed("-"))[6]! / moved[6]! - 1) < 1e-3);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("in the charts the arrow keys move the instant and zoom, and the path follows", async () => {
  const { page, said } = await openReport([pocket], "#tick=20000");
  await page.locator(".time-view").focus();
  await page.keyboard.press("ArrowRight");
  const step = (await tickOf(page)) - 20000;
  assert.ok(step > 100, `${step} ticks`);
  await page.keyboard.press("ArrowLeft");
  assert.equal(await tickOf(page), 20000);
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowUp");
  const [from, to] = (await words(page)).get("span")!.split(",").map(Number);
  assert.ok(from! < 20000 && 20000 < to! && to! - from! < 30 * step, `${from} to ${to}`);
  await page.keyboard.press("ArrowRight");
  const finer = (await tickOf(page)) - 20000;
  assert.ok(finer > 0 && finer < step / 2, `${finer} of ${step}`);
  for (let i = 0; i < 8; ++i) await page.keyboard.press("ArrowDown");
  assert.equal((await words(page)).get("span"), null, "all of it");
  await page.keyboard.press("Home");
  assert.equal(await tickOf(page), 0);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the tabs are one stop of the Tab key, and the arrow keys go from one to the next and round", async () => {
  const { page, said } = await openReport([pocket, join(SOURCE, "programs", "star.ngc")]);
  const tabs = page.locator("[role=tablist] [role=tab]:visible");
  assert.deepEqual(await tabs.evaluateAll((all) => all.map((one) => (one as HTMLElement).tabIndex)), [0, -1, -1]);
  await page.locator("[data-tab=program]").focus();
  const at = (): Promise<string | undefined> => page.evaluate(() => (document.activeElement as HTMLElement).dataset["tab"]);
  const visible = (): Promise<(string | null)[]> => page.locator("[role=tabpanel]:visible").evaluateAll((all) => all.map((one) => one.id));
  for (const [key, name] of [["ArrowRight", "answer"], ["ArrowRight", "difference"], ["ArrowRight", "program"], ["ArrowLeft", "difference"], ["Home", "program"], ["End", "difference"]] as const) {
    await page.keyboard.press(key);
    assert.equal(await at(), name, key);
    assert.deepEqual(await visible(), [await page.locator(`[data-tab=${name}]`).getAttribute("aria-controls")]);
    assert.equal(await page.locator(`[data-tab=${name}]`).getAttribute("tabindex"), "0");
  }
  for (const panel of await page.locator("[role=tabpanel]").all()) {
    const label = (await panel.getAttribute("aria-labelledby"))!;
    assert.equal(await page.locator(`#${label}`).getAttribute("aria-controls"), await panel.getAttribute("id"));
  }
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the keys act on the slider, too, whatever the case, but not after the about box", async () => {
  const { page, said } = await openReport([pocket], "#tick=20000&view=400,-300,300,40,30,0,9");
  await page.locator(".scrub").focus();
  await page.keyboard.press(".");
  assert.equal(await tickOf(page), 20001);
  await page.keyboard.press("F");
  assert.equal(((await words(page)).get("view") ?? "9").split(",").pop() === "9", false, "fitted");
  const label = (): Promise<string | null> => page.locator("button.play").getAttribute("aria-label");
  await page.keyboard.press("Space");
  assert.equal(await label(), "Pause");
  await page.keyboard.press("Space");
  const tick = await tickOf(page);
  await page.locator("button", { hasText: "About" }).click();
  await page.keyboard.press(".");
  assert.equal(await tickOf(page), tick);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a screen reader hears the slider's time and line, and no word for each frame", async () => {
  const { page } = await openReport([pocket], "#tick=20000");
  assert.equal(await page.locator(".scrub").getAttribute("aria-valuetext"), await page.locator(".instant").textContent());
  assert.equal(await page.locator(".time-panel").locator("output, [aria-live], [role=status]").count(), 0);
  await page.context().close();
});

test("the about box lists the keys", async () => {
  const { page } = await openReport([pocket]);
  await page.locator("button", { hasText: "About" }).click();
  const keys = (await page.locator("[data-test=keys]").textContent())!;
  for (const wanted of ["space", "comma", "arrow keys", "in the path", "in the charts", "on the tabs", "Shift", "Home"]) assert.ok(keys.includes(wanted), wanted);
  await page.context().close();
});

test("what is chosen of a legend by a key keeps the focus", async () => {
  const { page, said } = await openReport([pocket]);
  await page.locator("select[aria-label^=Colour]").selectOption("limit");
  const part = page.locator(".legend button").nth(1);
  await part.focus();
  await page.keyboard.press("Enter");
  assert.equal(await part.getAttribute("aria-pressed"), "true");
  assert.ok(await part.evaluate((button) => button === document.activeElement));
  await page.keyboard.press("Enter");
  assert.equal(await part.getAttribute("aria-pressed"), "false");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a drag over the charts that ends after they were drawn anew changes nothing", async () => {
  const { page, said } = await openReport([pocket], "#span=100,900");
  const over = (await page.locator(".u-over").first().boundingBox())!;
  await page.mouse.move(over.x + 0.3 * over.width, over.y + 10);
  await page.mouse.down();
  await page.mouse.move(over.x + 0.6 * over.width, over.y + 10, { steps: 4 });
  await page.evaluate(() => [...document.querySelectorAll("button")].find((button) => button.textContent === "inch")!.click());
  await page.mouse.up();
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  assert.doesNotMatch(await fragmentOf(page), /NaN/);
  assert.match(await fragmentOf(page), /span=100,900/);
  assert.deepEqual(said, []);
  await page.context().close();
});
