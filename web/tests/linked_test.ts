// Path, time and program are one: what is pointed at in one is followed by the others.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fragmentOf, goTo, kerf, markedLine, openReport, pocket, programFile, shown, textOf, traceOf } from "./report.ts";

test("a line that is clicked moves the instant to where it begins", async () => {
  const { page, said } = await openReport([pocket]);
  const first = traceOf(pocket).findIndex((row) => row.line === 16);
  await page.locator(".cm-line", { hasText: "G1 X-11. Y0. F1200." }).click();
  assert.match(await textOf(page, "instant"), new RegExp(`tick ${first}, line 16$`));
  assert.equal(await markedLine(page), "G1 X-11. Y0. F1200.");
  assert.match(await fragmentOf(page), new RegExp(`tick=${first}`));
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a line that takes no time leads to where the next begins that does", async () => {
  const file = programFile("G21 G90 G61 F600\nG1 X5\n(contour)\nF300\nG1 X9\nM2\n");
  const { page, said } = await openReport([file]);
  await page.locator(".cm-line", { hasText: "(contour)" }).click();
  const tick = traceOf(file).findIndex((row) => row.line === 5);
  assert.match(await textOf(page, "instant"), new RegExp(`tick ${tick}, line 5$`));
  assert.match(await textOf(page, "words"), /F300/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a place on the path that is pointed at shows its line and instant, and goes again", async () => {
  const { page, said } = await openReport([pocket], "#tick=1000");
  const before = await textOf(page, "instant");
  const box = (await page.locator(".path-view").boundingBox())!;
  // Somewhere along this row the pointer crosses the path.
  let hit = "";
  for (let x = 0.3; x < 0.8 && hit === ""; x += 0.01) {
    await page.mouse.move(box.x + x * box.width, box.y + 0.5 * box.height);
    const tip = page.locator(".tip");
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    if (await tip.isVisible()) hit = (await tip.textContent()) ?? "";
  }
  const line = /^line (\d+) /.exec(hit)![1]!;
  assert.match(await textOf(page, "instant"), new RegExp(`line ${line}$`));
  assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[Number(line) - 1]);
  const [, x] = /X (\S+)/.exec(shown(hit))!;
  const tick = Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]);
  assert.ok(Math.abs(Number(x) - traceOf(pocket)[tick]!.xyz[0]!) < 0.002, `${x} at tick ${tick}`);
  await page.mouse.move(box.x + 2, box.y + 2);
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".tip")!.hidden);
  assert.equal(await textOf(page, "instant"), before);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a place that was pointed at is not told any more while the program plays", async () => {
  const { page } = await openReport([pocket]);
  const box = (await page.locator(".path-view").boundingBox())!;
  const tip = page.locator(".tip");
  for (let x = 0.3; x < 0.8 && !(await tip.isVisible()); x += 0.01) {
    await page.mouse.move(box.x + x * box.width, box.y + 0.5 * box.height);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  }
  assert.ok(await tip.isVisible());
  await page.keyboard.press(" ");
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".tip")!.hidden, null, { timeout: 5000 });
  await page.context().close();
});

test("an instant that is clicked in the chart marks its line", async () => {
  const { page, said } = await openReport([pocket]);
  const over = (await page.locator(".u-over").first().boundingBox())!;
  await page.mouse.click(over.x + 0.4 * over.width, over.y + 10);
  const [, tick, line] = /tick (\d+), line (\d+)$/.exec(await textOf(page, "instant"))!;
  const trace = traceOf(pocket);
  assert.ok(Math.abs(Number(tick) / (trace.length - 1) - 0.4) < 0.003);
  assert.equal(trace[Number(tick)]!.line, Number(line));
  assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[Number(line) - 1]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the codes in force at the instant are those that explain names before the next line", async () => {
  const { page, said } = await openReport([pocket]);
  const trace = traceOf(pocket);
  for (const line of [7, 10, 16, 44]) {
    await goTo(page, trace.findIndex((row) => row.line === line) + 5);
    // What a block sets is in force before the next one.
    const block = JSON.parse(kerf("explain", pocket, "--line", String(line + 1), "--json").out).block as { codes: string[] };
    const shownCodes = (await textOf(page, "codes")).split(" ");
    for (const code of shownCodes) assert.ok(block.codes.includes(code), `${code} in ${block.codes.join(" ")}`);
    assert.ok(shownCodes.length >= 8);
  }
  assert.deepEqual(said, []);
  await page.context().close();
});

test("beside the codes are F and S and T as they are in force before the next line", async () => {
  const text = "G21 G90 G61\nT1 M6\nS9000 M3\nG1 X10 F600\nX20\nX30 F1200.5 S3000\nT5\nX40\nX50\nM30\n";
  const program = programFile(text);
  const { page, said } = await openReport([program]);
  const trace = traceOf(program);
  for (const [line, F] of [[4, 600], [5, 600], [6, 1200.5], [8, 1200.5]] as const) {
    await goTo(page, trace.findIndex((row) => row.line === line) + 5);
    const block = JSON.parse(kerf("explain", program, "--line", String(line + 1), "--json").out).block as { feedrate_mm_s: number; spindle_speed: number; tool: number };
    assert.ok(Math.abs(block.feedrate_mm_s * 60 - F) < 1e-9);
    assert.equal(await textOf(page, "words"), `F${F} S${block.spindle_speed} T${block.tool}`, `line ${line}`);
  }
  assert.deepEqual(said, []);
  await page.context().close();
});

test("play goes on in time, and space stops it", async () => {
  const { page, said } = await openReport([pocket], "#tick=20000");
  await page.locator("body").press("Space");
  await page.waitForFunction(() => Number(document.querySelector<HTMLElement>(".instant")!.dataset["tick"]) > 20100);
  await page.locator("body").press("Space");
  const stopped = await textOf(page, "instant");
  await page.waitForTimeout(150);
  assert.equal(await textOf(page, "instant"), stopped);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the chart zooms to what is dragged over, down to ticks, and back", async () => {
  const { page, said } = await openReport([pocket]);
  const over = (await page.locator(".u-over").first().boundingBox())!;
  await page.mouse.move(over.x + 0.3 * over.width, over.y + 10);
  await page.mouse.down();
  await page.mouse.move(over.x + 0.5 * over.width, over.y + 12, { steps: 4 });
  await page.waitForTimeout(100); // uPlot takes a move with the next frame
  await page.mouse.up();
  await page.mouse.move(over.x + 0.5 * over.width, over.y + 10);
  // The middle of what is seen is now at 0.4 of the whole.
  const tick = Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]);
  const all = traceOf(pocket).length - 1;
  assert.ok(Math.abs(tick / all - 0.4) < 0.003, `${tick} of ${all}`);
  await page.locator("button", { hasText: /^all$/ }).click();
  await page.mouse.move(over.x + 0.5 * over.width, over.y + 10);
  assert.ok(Math.abs(Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]) / all - 0.5) < 0.003);
  assert.deepEqual(said, []);
  await page.context().close();
});
