// The answer: does it fit, where the time goes, what is wrong.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { SOURCE, kerf, openReport, programFile, shown, textOf } from "./report.ts";

test("shows an error at its line, with what to do", async () => {
  const program = programFile("G21 G90\nG1 X10 F-100\nM30\n");
  const { page, said } = await openReport([program]);
  const diagnostic = (await page.locator(".cm-diagnostic").first().textContent())!;
  assert.ok(diagnostic.includes("E0120"));
  const [{ remedy }] = JSON.parse(kerf("check", "--format", "json", program).out).diagnostics;
  assert.ok(diagnostic.includes(remedy));
  assert.deepEqual(said, []);
  await page.context().close();
});

test("counts every error once, at whatever line, and lists as many", async () => {
  const program = programFile("G21 G90 F600\nG1 X10 F-100\nG1 X20 F-100\nG1 X30 Q\nM30\n");
  const { page, said } = await openReport([program]);
  const { errors } = JSON.parse(kerf("dry-run", "--json", program).out) as { errors: unknown[] };
  assert.equal(errors.length, 3, "two of them in the same words");
  assert.equal(await page.locator("[data-test=failed] .big").textContent(), "3 errors");
  assert.equal(await page.locator(".cm-diagnostic.cm-error").count(), 3);
  await page.locator("[data-tab=answer]").click();
  assert.equal(await page.locator("[data-test=messages] li").count(), 3);
  assert.equal(await page.locator(".part-of-answer h3").first().textContent(), "3 errors");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says that there may be more errors than were read", async () => {
  const { page, said } = await openReport([programFile(`G21 G90 F600\n${"G1 Xq\n".repeat(5000)}M30\n`)]);
  assert.equal(await page.locator("[data-test=failed] .big").textContent(), "100 errors or more");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("lists a warning once, with what to do", async () => {
  const program = programFile("G21 G90 F99999\nG1 X10\nM30\n");
  const { page, said } = await openReport([program]);
  const { warnings } = JSON.parse(kerf("dry-run", "--json", program).out) as { warnings: string[] };
  assert.ok(warnings.length > 0);
  await page.locator("[data-tab=answer]").click();
  assert.equal(await page.locator("[data-test=messages] li").count(), warnings.length);
  assert.equal(await page.locator(".part-of-answer h3").first().textContent(), `${warnings.length} warning${warnings.length === 1 ? "" : "s"}`);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("no work offset is offered to a path that leaves the travel without following one", async () => {
  const { page, said } = await openReport([programFile("G21 G90 F600\nG53 G0 X600\nG1 X20\nM2\n")]);
  assert.match(await textOf(page, "extents"), /X .* over by 100\.000/);
  assert.match(await textOf(page, "offset-in-force"), /X no place: over by 100(\.000)? wherever it lies/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a further axis that leaves its travel is no program that fits", async () => {
  const table = readFileSync(join(SOURCE, "programs", "machines", "table.toml"), "utf8");
  const turning = programFile(`${table}\n[axes.a]\nmin_deg = -90\nmax_deg = 90\nmax_velocity_deg_s = 90\nmax_acceleration_deg_s2 = 900\nmax_jerk_deg_s3 = 9000\n`, "turning.toml");
  const program = programFile("G21 G90 F600\nG1 X10 A100\nM2\n");
  const { page, said } = await openReport([program, "--machine", turning]);
  assert.match(await textOf(page, "failed"), /a goes 10 deg beyond its upper limit of 90 deg$/);
  assert.equal(await textOf(page, "fit-verdict"), "does not fit");
  assert.match(await textOf(page, "extents"), /a goes 10 deg beyond its upper limit of 90 deg$/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("an offset that is written as the page tells it fits", async () => {
  const program = programFile("G21 G90 F6000\nG1 X33.33346\nM30\n");
  const { page, said } = await openReport([program]);
  const [, most] = /X \S+ to (\d+\.\d+)/.exec(shown(await textOf(page, "offset-in-force")))!;
  assert.equal(most, "466.666", "the travel ends at 500");
  assert.equal(kerf("dry-run", "-q", "--g54", `${most},0,0`, "--start", `${most},0,0`, program).status, 0);
  assert.equal(kerf("dry-run", "-q", "--g54", "466.667,0,0", "--start", "466.667,0,0", program).status, 4);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says by how much a program does not fit, and how far the offset may move", async () => {
  const { page, said } = await openReport([programFile("G21 G90 F6000\nG1 X520\nG1 X-100\nM30\n")]);
  // The travel of X is -500 to 500.
  assert.equal(await textOf(page, "fit-verdict"), "does not fit");
  assert.ok(shown(await textOf(page, "extents")).includes("X -100.000 to 520.000, over by 20.000"));
  await page.locator("[data-tab=answer]").click();
  assert.ok(shown(await textOf(page, "offsets")).includes("-400.000 to -20.000"));
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says between which values the work offset in force would fit", async () => {
  const text = "G21 G90 G55 F6000\nG1 X20\nG1 X-100\nM30\n";
  const machine = programFile(readFileSync(join(SOURCE, "programs/machines/table.toml"), "utf8") + "\n[offsets.g55]\nx_mm = 50\n", "offset.toml");
  const { page, said } = await openReport([programFile(text), "--machine", machine]);
  await page.locator("[data-tab=answer]").click();
  // The path is at X -50 to 70 with G55 at 50; the travel is -500 to 500, so G55 may be at -400 to 480.
  const offsets = shown(await textOf(page, "offsets"));
  assert.ok(offsets.includes("G55 between") && offsets.includes("-400.000 to 480.000"), offsets);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("of an axis that an offset moves twice as far it is not said that it stays where it is", async () => {
  const { page, said } = await openReport([programFile("G21 G90 F600\nG1 X[2 * #5221 + 5] Y5\nM2\n"), "--g54", "10,0,0"]);
  await page.locator("[data-tab=answer]").click();
  const cells = await page.locator("[data-test=offsets] tbody tr").first().locator("td").allTextContents();
  assert.deepEqual([cells[0], cells[2]], ["X", "does not move it, or not one to one"]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("says at the top where the first work offset may lie, and leads to the others", async () => {
  const { page, said } = await openReport([programFile("G21 G90 F6000\nG54 G1 X20\nG55 G1 X-100 Y30\nM30\n")]);
  // The travel of X is -500 to 500, and G54 moves the end of the first line alone, X20.
  assert.equal(shown(await textOf(page, "offset-in-force")), "X -520 to 480G55 ...");
  await page.locator("[data-test=offset-in-force] button").click();
  assert.equal(await page.locator("[data-test=offsets]").isVisible(), true);
  assert.equal(await page.locator("[data-tab=answer]").getAttribute("aria-selected"), "true");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a dwell after a tool change that takes no time is a rest, as kerf says", async () => {
  const program = programFile("T1 M6\nG4 P2\nG1 X10 F600\nM2\n");
  const { time_split } = JSON.parse(kerf("dry-run", "--json", program).out) as { time_split: Record<string, number> };
  assert.deepEqual([time_split["rest_s"], time_split["tool_change_s"]], [2, 0]);
  const { page, said } = await openReport([program]);
  assert.equal(await textOf(page, "time-rest"), "2.000 s");
  assert.equal(await page.locator("[data-test=time-toolChange]").count(), 0);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("tells tool changes, dwells and rapids apart", async () => {
  const machine = programFile('[program]\ntool_change_s = 3\n' + readFileSync(join(SOURCE, "programs/machines/table.toml"), "utf8").replace(/^\[program\]$/m, ""), "changer.toml");
  const text = "G21 G90 F6000\nT1 M6\n(rough)\nG1 X10\nG4 P2\nT2 M6\n(finish)\nG1 X20\nG0 X0\nM30\n";
  const { page, said } = await openReport([programFile(text), "--machine", machine]);
  const seconds = async (name: string): Promise<number> => parseFloat(await textOf(page, name));
  assert.ok(Math.abs((await seconds("time-toolChange")) - 6) < 0.02, await textOf(page, "time-toolChange"));
  assert.ok(Math.abs((await seconds("time-rest")) - 2) < 0.02, await textOf(page, "time-rest"));
  await page.locator("[data-tab=answer]").click();
  const tools = (await page.locator("[data-test=by-tool] tbody tr td:first-child").allTextContents()).filter((name) => name !== "no tool");
  assert.deepEqual(tools, ["T1", "T2"]);
  assert.deepEqual(await page.locator("[data-test=by-operation] tbody tr td:first-child").allTextContents(), ["before the first heading", "rough", "finish"]);
  assert.deepEqual(said, []);
  await page.context().close();
});
