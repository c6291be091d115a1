// The answer: does it fit, where the time goes, what is wrong.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { SOURCE, goTo, kerf, markedLine, openReport, programFile, shown, textOf, traceOf } from "./report.ts";

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

test("tells lines of subprograms in files of their own from those of the program", async () => {
  const folder = dirname(programFile("(sub)\no<legs> sub\nG1 Y#1 F600\nG4 P1\nG1 Y0\no<legs> endsub\nM2\n", "legs.ngc"));
  const program = programFile("G21 G90 G61 F1200\nG1 X5\nG1 X9\no<legs> call [7]\nG1 X0\nM2\n", "main.ngc");
  const trace = traceOf(program);
  const { page, said } = await openReport([program]);
  // The third line of both: X goes in one, Y in the other.
  const at = (goes: (row: { v: number; xyz: readonly number[] }) => boolean): number => trace.findIndex((row) => row.line === 3 && row.v > 5 && goes(row));
  await goTo(page, at((row) => row.xyz[0]! > 6 && row.xyz[1] === 0));
  assert.match(await textOf(page, "instant"), /line 3$/);
  assert.equal(await markedLine(page), "G1 X9");
  await goTo(page, at((row) => row.xyz[1]! > 1));
  assert.match(await textOf(page, "instant"), /line 3 of legs\.ngc$/);
  assert.equal(await page.locator(".cm-now").count(), 0);
  await page.locator("[data-tab=answer]").click();
  const rows = await page.locator("[data-test=by-file] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent!)));
  assert.deepEqual(rows.map(([name]) => name), ["main.ngc", "legs.ngc"]);
  // What moves Y, and the dwell, is the subprogram's.
  const there = trace.slice(0, -1).filter((row, tick) => row.line >= 3 && (trace[tick + 1]!.xyz[1] !== row.xyz[1] || row.line === 4)).length;
  assert.ok(Math.abs(parseFloat(rows[1]![1]!) - there / 1000) <= 0.003, `${rows[1]![1]} of ${there} ms`);
  assert.equal(folder, dirname(program));
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
