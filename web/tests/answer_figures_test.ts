// The figures of the answer, and those beside the lines, are those of --json.
import assert from "node:assert/strict";
import { test } from "node:test";
import { clock, percent, plain } from "../src/units.ts";
import { timesOfLines } from "./lines.ts";
import { goTo, kerf, openReport, programFile, shown, textOf, traceOf } from "./report.ts";

const text = "G21 G90 G64 P0.05 F6000\nG1 X50\nY50\nG4 P0.5\nX0\nY0 F600\nM2\n";

interface Figures {
  readonly cycle_time_s: number;
  readonly deviation: { readonly max_mm: number; readonly line: number };
  readonly max: { readonly path: Record<string, number>; readonly axes: Record<string, Record<string, number>> };
  readonly speed_limits_of_lines: readonly { readonly line: number; readonly time_s: number; readonly limits: Record<string, { readonly share: number }> }[];
}
const figuresOf = (program: string): Figures => JSON.parse(kerf("dry-run", "--json", "--explain-speed", program).out) as Figures;

test("the lines that cost most stand with their time, what limits them and what would help", async () => {
  const program = programFile(text);
  const { page, said } = await openReport([program]);
  const { speed_limits_of_lines: lines, cycle_time_s } = figuresOf(program);
  assert.deepEqual(lines.map(({ line }) => line).slice(0, 1), [6], "50 mm at 10 mm/s");
  assert.equal(lines.length, 5);
  await page.locator("[data-tab=answer]").click();
  const rows = await page.locator("[data-test=lines] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  assert.deepEqual(
    rows.map(([line, time]) => [line, time]),
    lines.map(({ line, time_s }) => [String(line), clock(time_s)]),
  );
  rows.forEach(([, , limit], i) => assert.ok(limit!.endsWith(percent(Object.values(lines[i]!.limits)[0]!.share)), limit));
  const remedyOf = (line: number): string => rows.find(([of]) => of === String(line))![3]!;
  assert.equal(remedyOf(6), "a higher F would save time");
  assert.match(remedyOf(4), /^a dwell/);
  const most = await textOf(page, "slowest");
  for (const part of ["line 6", clock(lines[0]!.time_s), percent(lines[0]!.time_s / cycle_time_s), "a higher F would save time"]) assert.ok(most.includes(part), `${part} in ${most}`);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the largest figures stand beside the limits of the machine, and the deviation at its line", async () => {
  const program = programFile(text);
  const { page, said } = await openReport([program]);
  const { max, deviation } = figuresOf(program);
  await page.locator("[data-tab=answer]").click();
  const rows = await page.locator("[data-test=largest] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  const rowOf = (name: string): readonly string[] => rows.find(([where]) => where === name)!;
  const per_min = 60 * max.axes["x"]!["v_mm_s"]!;
  assert.deepEqual(rowOf("axis X velocity"), ["axis X velocity", `${plain(per_min)} mm/min`, "15000", percent(per_min / 15000)]);
  assert.equal(rowOf("axis Y acceleration")[3], percent(max.axes["y"]!["a_mm_s2"]! / 2500));
  assert.equal(rowOf("path jerk")[3], percent(max.path["j_mm_s3"]! / 50_000));
  assert.match(await textOf(page, "limits"), new RegExp(`velocity${percent(per_min / 15000)}.*accel\\.${percent(max.path["a_mm_s2"]! / 2500)}`));
  const off = shown(await textOf(page, "deviation"));
  assert.ok(off.includes(`${plain(1000 * deviation.max_mm, 3)} \u00b5m`), off);
  assert.ok(off.includes("of 50.0 \u00b5m allowed, line 3"), off);
  assert.equal(deviation.line, 3);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("beside a line of a report is its time", async () => {
  const program = programFile(text);
  const { page, said } = await openReport([program]);
  const beside = await timesOfLines(page);
  for (const { line, time_s } of figuresOf(program).speed_limits_of_lines) assert.ok(Math.abs(Number(beside[line - 1]) - time_s) <= 0.0051, `${beside[line - 1]} beside line ${line}`);
  assert.deepEqual([beside[0], beside[6]], ["", ""]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a warning stands at its line", async () => {
  const { page, said } = await openReport([programFile("G21 G90\nG1 X10 F99999\nM30\n")]);
  const warning = page.locator(".cm-diagnostic.cm-warning");
  assert.equal(await warning.count(), 1);
  assert.match((await warning.textContent()) ?? "", /E1010/);
  const before = await warning.evaluate((element) => element.previousElementSibling?.textContent);
  assert.equal(before, "G1 X10 F99999");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a line that is pointed at is shown in the path and in time, and a place that is clicked is the instant", async () => {
  const program = programFile(text);
  const { page, said } = await openReport([program]);
  const trace = traceOf(program);
  await page.locator(".program-view .cm-line", { hasText: "Y0 F600" }).hover();
  assert.equal(trace[Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1])]!.line, 6);
  await goTo(page, 0);
  await page.locator("button", { hasText: /^top$/i }).click();
  await page.waitForTimeout(100);
  const view = (await page.locator(".path-view canvas").first().boundingBox())!;
  // The lower edge of the square: line 2, from X0 to X50.
  let found = "";
  for (let share = 0.5; share < 1.0 && found !== "2"; share += 0.01) {
    await page.mouse.click(view.x + 0.5 * view.width, view.y + share * view.height);
    const tick = Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]);
    found = tick > 0 ? String(trace[tick]!.line) : "";
  }
  assert.equal(found, "2");
  assert.deepEqual(said, []);
  await page.context().close();
});
