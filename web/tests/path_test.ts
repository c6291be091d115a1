// The path of many lines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { clock } from "../src/units.ts";
import type { Page } from "playwright-core";
import { fragmentOf, kerf, openReport, pocket, programFile, textOf } from "./report.ts";

// A view that is moved is drawn coarsely, and then whole.
async function drawnWhole(page: Page): Promise<void> {
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".path-view canvas")!.dataset["whole"] === "true");
}

test("keeps every peak, and draws at most 300,000 vertices", async () => {
  const lines = ["G21 G90 G64 P0.01 F6000"];
  for (let i = 0; i < 60_000; ++i) lines.push(`G1 X${(100 * Math.cos(i / 50) + i / 1000).toFixed(3)} Y${(80 * Math.sin(i / 37)).toFixed(3)}`);
  const program = programFile([...lines, "M30", ""].join("\n"));
  const json = JSON.parse(kerf("dry-run", "--json", program).out);
  assert.ok(json.ticks > 200_000, "more ticks than a report has columns");
  const { page, said } = await openReport([program]);
  assert.equal(await textOf(page, "cycle-time"), clock(json.cycle_time_s));
  assert.match((await page.locator(".note").textContent())!, /finest level here is \d+ ticks/);
  for (const colour of ["feed", "limit", "jerk"]) {
    await page.locator("[data-test=colour]").selectOption(colour);
    for (const side of ["top", "iso"]) {
      await page.locator(`[data-side=${side}]`).click();
      await page.waitForTimeout(50);
      await drawnWhole(page);
      const vertices = Number(await page.locator(".path-view canvas").first().getAttribute("data-vertices"));
      assert.ok(vertices > 10_000 && vertices <= 300_000, `${vertices} vertices`);
    }
  }
  assert.deepEqual(said, []);
  await page.context().close();
});

// Of 300 drilled places a row.
function drilled(places: number): string {
  const drills = Array.from({ length: places }, (_, i) => `G0 X${i % 300} Y${Math.trunc(i / 300)}\nG1 X${(i % 300) + 0.8}`);
  return programFile(["G21 G90 F6000", ...drills, "M2", ""].join("\n"));
}

test("says where a view joins rests and rapids with what is beside them, and joins none of them nearer", async () => {
  const { page, said } = await openReport([drilled(36_500)]);
  await drawnWhole(page);
  assert.match((await textOf(page, "path-note"))!, /^more rests and rapids than fit this view: .*zoom in/);
  const box = (await page.locator(".path-view").boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  for (let step = 0; step < 12; ++step) await page.mouse.wheel(0, -240);
  await page.waitForFunction(() => document.querySelector("[data-test=path-note]")!.textContent === "");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says where a report has fewer points than there are rapids", async () => {
  const { page, said } = await openReport([drilled(45_000)]);
  await drawnWhole(page);
  assert.match((await textOf(page, "path-note"))!, /^more rapids than the path has points here/);
  assert.deepEqual(said, []);
  await page.context().close();
});

// Of a move of some ticks, and of a program whose columns stand for many.
test("the legend says what limits the feed as the table does", async () => {
  const long = ["G21 G90 G61 F6000"];
  for (let i = 0; i < 4000; ++i) long.push(`G1 X${i % 2 === 0 ? 10 : 0}`);
  for (const text of ["G21 G90 G61\nG1 X0.001 F6000\nM2\n", [...long, "M2", ""].join("\n")]) {
    const { page, said } = await openReport([programFile(text)]);
    await page.locator("[data-test=colour]").selectOption("limit");
    await page.locator("[data-tab=answer]").click();
    const rows = await page.locator("[data-test=constraints] tbody tr").evaluateAll((all) => all.map((row) => row.lastElementChild!.textContent));
    const parts = await page.locator(".legend.parts button .soft").allTextContents();
    assert.ok(rows.length > 0);
    assert.deepEqual(parts, rows);
    assert.deepEqual(said, []);
    await page.context().close();
  }
});

// What a hand does with the view: turns it, comes nearer, moves it. Calls `look` after each step.
async function wander(page: Page, look: () => Promise<void>): Promise<void> {
  const box = (await page.locator(".path-view").boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  for (const button of ["left", "right"] as const) {
    await page.mouse.move(x, y);
    await page.mouse.down({ button });
    for (let step = 1; step <= 6; ++step) {
      await page.mouse.move(x + 12 * step, y + 7 * step);
      await look();
    }
    await page.mouse.up({ button });
  }
  await page.mouse.move(x, y);
  for (let step = 0; step < 12; ++step) {
    await page.mouse.wheel(0, -240);
    await look();
  }
}

test("a view of many lines has at most 300,000 vertices in every frame, and most frames cost at most 8 ms of script", async () => {
  const lines = Array.from({ length: 80_000 }, (_, i) => `G1 X${(100 * Math.cos(i / 50) + 60 * Math.sin(i * i)).toFixed(3)} Y${(80 * Math.sin(i / 37) + 60 * Math.cos(3 * i * i)).toFixed(3)}`);
  const { page, said } = await openReport([programFile(["G21 G90 G61 F12000", ...lines, "M30", ""].join("\n"))], "#colour=limit");
  const canvas = page.locator(".path-view canvas").first();
  const costs: number[] = [];
  const vertices: number[] = [];
  await wander(page, async () => {
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    vertices.push(Number(await canvas.getAttribute("data-vertices")));
    costs.push(Number(await canvas.getAttribute("data-script-ms")));
    await drawnWhole(page);
    vertices.push(Number(await canvas.getAttribute("data-vertices")));
  });
  assert.ok(Math.max(...vertices) > 100_000 && Math.max(...vertices) <= 300_000, `${Math.max(...vertices)} vertices`);
  costs.sort((a, b) => a - b);
  assert.ok(costs[costs.length >> 1]! <= 8, `${costs.join(" ")} ms`); // a machine that does something else meanwhile has worse ones
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the path is coloured by how far it is from the program, up to what kerf says", async () => {
  const program = programFile("G21 G90 G64 P0.1 Q0 F3000\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM2\n");
  const { deviation } = JSON.parse(kerf("dry-run", "--json", program).out);
  const { page, said } = await openReport([program], "#colour=deviation");
  assert.match((await page.locator(".legend-title").textContent())!, /off the programmed path, \u00b5m/);
  const marks = (await page.locator(".legend .marks span").allTextContents()).map(Number);
  assert.equal(marks[0], 0);
  assert.ok(Math.abs(marks[4]! - 1000 * deviation.max_mm) <= 0.005 * 1000 * deviation.max_mm, `${marks[4]} of ${1000 * deviation.max_mm} \u00b5m`);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("each colour has its legend, and a part of one that is clicked dims the others", async () => {
  const { page, said } = await openReport([pocket]);
  const colours = await page.locator("[data-test=colour] option").evaluateAll((all) => all.map((one) => (one as HTMLOptionElement).value));
  assert.deepEqual(colours, ["feed", "limit", "acceleration", "jerk", "deviation", "tool", "following"]);
  for (const colour of colours) {
    await page.locator("[data-test=colour]").selectOption(colour);
    assert.equal(await page.locator(".legend").count(), 1);
  }
  await page.locator("[data-test=colour]").selectOption("limit");
  const before = await page.locator(".path-view canvas").first().screenshot();
  await page.locator(".legend.parts button").first().click();
  assert.equal(await page.locator(".legend.parts button[aria-pressed=true]").count(), 1);
  assert.ok((await page.locator(".legend.parts button.dimmed").count()) >= 1);
  await page.waitForTimeout(200);
  assert.ok(!before.equals(await page.locator(".path-view canvas").first().screenshot()), "the picture is another one");
  await page.locator(".legend.parts button").first().click();
  assert.equal(await page.locator(".legend.parts button.dimmed").count(), 0);
  // Of a scale, a quarter.
  await page.locator("[data-test=colour]").selectOption("feed");
  const whole = await page.locator(".path-view canvas").first().screenshot();
  const quarters = await page.locator(".legend .ramp button").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")!));
  const marks = await page.locator(".legend .marks span").allTextContents();
  assert.deepEqual(quarters, [0, 1, 2, 3].map((i) => `${marks[i]} to ${marks[i + 1]} mm/min`));
  await page.locator(".legend .ramp button").last().click();
  assert.equal(await page.locator(".legend .ramp button.dimmed").count(), 3);
  await page.waitForTimeout(200);
  assert.ok(!whole.equals(await page.locator(".path-view canvas").first().screenshot()), "the slower ways are dimmed");
  assert.match(await fragmentOf(page), /shown=3/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the path of a program that leaves the travel is drawn, in red what leads out of it", async () => {
  const { page, said } = await openReport([programFile("G21 G90 G61 F3000\nG1 X100\nG3 X100 Y60 I0 J30\nG1 X620 Y20\nG1 X0\nM2\n")]);
  assert.ok(Number(await page.locator(".path-view canvas").first().getAttribute("data-vertices")) > 200, "the arc, too, has its points");
  // Of 100 mm, half a circle of 30 mm, and the ways to X 620 and back: what is beyond 500.
  const [there, back] = [Math.hypot(520, 40), 620];
  const out = (there * 120) / 520 + 120;
  const share = Math.round((100 * out) / (100 + 30 * Math.PI + there + back));
  assert.match((await page.locator(".legend.parts button", { hasText: "out of the travel" }).textContent())!, new RegExp(`${share}\\s%`));
  assert.equal(await page.locator(".time-panel").isVisible(), false);
  assert.deepEqual(said, []);
  await page.context().close();
});
