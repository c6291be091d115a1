// Runs side by side.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { clock, difference } from "../src/units.ts";
import { SOURCE, goTo, kerf, markedLine, openReport, programFile, shown, textOf, traceOf } from "./report.ts";

test("sets two machines side by side", async () => {
  const machines = ["table", "sigmoid-wm"].map((name) => join(SOURCE, `programs/machines/${name}.toml`));
  const wm = join(SOURCE, "programs", "wm.ngc");
  const { page, said } = await openReport([wm, "--machine", machines[0]!, "--machine", machines[1]!]);
  const times = machines.map((machine) => clock(JSON.parse(kerf("dry-run", "--json", wm, "--machine", machine).out).cycle_time_s));
  const select = page.locator("select[aria-label=Program]");
  assert.deepEqual(await select.locator("option").allTextContents(), [`wm.ngc, table.toml: ${times[0]}`, `wm.ngc, sigmoid-wm.toml: ${times[1]}`]);
  assert.equal(await textOf(page, "cycle-time"), times[0]);
  await select.selectOption("1");
  assert.equal(await textOf(page, "cycle-time"), times[1]);
  await page.locator("[data-tab=answer]").click();
  const seconds = machines.map((machine) => JSON.parse(kerf("dry-run", "--json", wm, "--machine", machine).out).cycle_time_s as number);
  const difference = shown(await page.locator("[data-test=side-by-side] tbody tr:nth-child(2) td:last-child").textContent() ?? "");
  assert.equal(parseFloat(difference).toFixed(3), (seconds[1]! - seconds[0]!).toFixed(3));
  await page.locator("[data-test=side-by-side] button").first().click();
  assert.equal(await textOf(page, "cycle-time"), times[0]);
  assert.equal(await select.inputValue(), "0");
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a run that ends early has no cycle time, and none is compared with it", async () => {
  const [slow, fast] = [60, 1200].map((feed) => programFile(`G21 G90 G61\nG1 X19.999 F${feed}\nM2\n`, `f${feed}.ngc`));
  const { page, said } = await openReport([slow!, fast!, "--max-time", "20s"]);
  assert.deepEqual(JSON.parse(kerf("dry-run", "--json", "--max-time", "20s", slow!).out).exit_status, 1);
  const select = page.locator("select[aria-label=Program]");
  assert.equal((await select.locator("option").allTextContents())[0], "f60.ngc: ends early");
  await select.selectOption("0");
  assert.match(await textOf(page, "failed"), /^Ends early/);
  assert.equal(await page.locator("[data-test=cycle-time]").count(), 0);
  // What kerf has no figures of is left out.
  for (const unknown of ["slowest", "limits", "deviation", "largest"]) assert.equal(await page.locator(`[data-test=${unknown}]`).count(), 0, unknown);
  await page.locator("[data-tab=answer]").click();
  assert.doesNotMatch(await textOf(page, "plan"), /path|ticks/);
  await select.selectOption("1");
  assert.equal(await textOf(page, "cycle-time"), clock(JSON.parse(kerf("dry-run", "--json", fast!).out).cycle_time_s));
  assert.equal(await page.locator("[data-test=time-difference]").count(), 0);
  await page.locator("[data-tab=difference]").click();
  assert.match((await page.locator(".compared").textContent()) ?? "", /f60\.ngc ends early: there is nothing to compare/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("a machine on which the program does not run shows no instant of the one on which it does", async () => {
  const table = join(SOURCE, "programs", "machines", "table.toml");
  const small = programFile(readFileSync(table, "utf8").replace("max_mm = 500", "max_mm = 5"), "small.toml"); // of X, the first
  const { page, said } = await openReport([programFile("G21 G90 F600\nG1 X10\nX20\nM2\n"), "--machine", table, "--machine", small]);
  await goTo(page, 1500);
  assert.equal(await markedLine(page), "X20");
  await page.locator("select[aria-label=Program]").selectOption("1");
  assert.match(await textOf(page, "failed"), /^Does not run/);
  assert.equal(await page.locator(".cm-now").count(), 0);
  assert.equal(await page.locator(".now-line").evaluate((line) => (line as HTMLElement).hidden), true);
  assert.equal(await textOf(page, "instant"), "");
  await page.locator("body").press("Space");
  assert.equal(await page.locator("button.play").getAttribute("aria-label"), "Play");
  await page.locator("select[aria-label=Program]").selectOption("0");
  await goTo(page, 1500);
  assert.equal(await markedLine(page), "X20");
  await page.locator(".now-line").waitFor();
  assert.match(await textOf(page, "instant"), /line 3$/);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the path is seen again after a look at a program that has none", async () => {
  const { page, said } = await openReport([programFile("G21 G90 F600\nG1 X10 Y5 Z-2\nX0\nM2\n"), programFile("G1 G2 X5\nM2\n")]);
  const canvas = page.locator(".path-view canvas").first();
  const select = page.locator("select[aria-label=Program]");
  const before = await canvas.screenshot();
  await select.selectOption("1");
  await page.waitForTimeout(100);
  await select.selectOption("0");
  await page.locator("body").press("f");
  await page.waitForTimeout(300);
  assert.ok(before.equals(await canvas.screenshot()));
  assert.deepEqual(said, []);
  await page.context().close();
});

test("programs of one name have numbers, and the first that runs is the base", async () => {
  const [slow, fast] = [600, 1200].map((feed) => programFile(`G21 G90 G61 F${feed}\nG1 X20\nM2\n`, `f${feed}/part.ngc`));
  const wrong = programFile("G1 G2 X5\nM2\n", "wrong.ngc");
  const { page, said } = await openReport([wrong, slow!, fast!]);
  const options = await page.locator("select[aria-label=Program] option").allTextContents();
  assert.match(options[1]!, /^part\.ngc \(1\): /);
  assert.match(options[2]!, /^part\.ngc \(2\): /);
  await page.locator("select[aria-label=Program]").selectOption("2");
  await page.locator("[data-tab=difference]").click();
  assert.deepEqual((await page.locator("[data-test=difference-whole] th").allTextContents()).slice(1, 3), ["part.ngc (1)", "part.ngc (2)"]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("two programs are compared line by line, those first that differ most", async () => {
  const before = programFile("G21 G90 G61 F600\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM2\n", "before.ngc");
  const after = programFile("(new post)\nG21 G90 G61 F600\nG1 X20\nF1200\nG1 Y20\nG1 X0\nM2\n", "after.ngc");
  const [slow, fast] = [before, after].map((file) => JSON.parse(kerf("dry-run", "--json", "--explain-speed", file).out));
  // What each line takes, by the trace.
  const [of, in_] = [before, after].map((file) => {
    const lines = new Map<number, number>();
    for (const row of traceOf(file).slice(0, -1)) lines.set(row.line, (lines.get(row.line) ?? 0) + slow.period_s);
    return (line: number): string => clock(lines.get(line) ?? 0);
  });
  const { page, said } = await openReport([before, after]);
  await page.locator("[data-tab=difference]").click();
  const rows = await page.locator("[data-test=difference-lines] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent!)));
  const told = new Map(rows.map(([line, text, base, other]) => [text, [line, base, other]]));
  assert.deepEqual(told.get("G1 X20"), ["2 \u2192 3", of!(2), in_!(3)]);
  assert.deepEqual(told.get("G1 Y20"), ["3 \u2192 5", of!(3), in_!(5)]);
  assert.deepEqual(told.get("G1 X0"), ["4 \u2192 6", of!(4), in_!(6)]);
  assert.deepEqual(told.get("G1 Y0"), ["\u2212 5", of!(5), clock(0)]);
  const amounts = rows.map((row) => Math.abs(parseFloat(shown(row[4]!) || "0")));
  assert.deepEqual(amounts, [...amounts].sort((a, b) => b - a));
  const whole = await page.locator("[data-test=difference-whole] tbody tr").first().locator("td").allTextContents();
  assert.deepEqual(whole, ["cycle time", clock(slow.cycle_time_s), clock(fast.cycle_time_s), difference(slow.cycle_time_s, fast.cycle_time_s)]);
  const limits = await page.locator("[data-test=difference-limits] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent!)));
  const feed = limits.find(([name]) => name === "programmed feedrate")!;
  assert.deepEqual(feed.slice(1, 3), [slow, fast].map((one) => clock(one.speed_limits.programmed_feedrate.time_s)));
  await page.locator("select[aria-label='Order of the lines']").selectOption("program");
  assert.deepEqual(await page.locator("[data-test=difference-lines] code").allTextContents(), ["G1 X20", "G1 Y20", "G1 X0", "G1 Y0"]);
  // A line of the run that is shown is gone to.
  await page.locator("[data-test=difference-lines] button", { hasText: "4" }).click();
  assert.match(await textOf(page, "instant"), /line 4$/);
  assert.deepEqual(said, []);
  await page.context().close();
});

// The rows that differ, as the page names them.
function rowsOf(before: string, after: string): string[][] {
  interface Side { from_line: number; to_line: number; time_s: number }
  const { lines } = JSON.parse(kerf("compare", "--json", "--lines", "1000", before, after).out).difference;
  const span = (side: Side | null): string => (!side ? "" : side.from_line === side.to_line ? `${side.from_line}` : `${side.from_line} to ${side.to_line}`);
  return (lines as { first: Side | null; second: Side | null }[]).map(({ first, second }) => {
    const [from, to] = [span(first), span(second)];
    const name = from === to ? from : from === "" ? `+ ${to}` : to === "" ? `\u2212 ${from}` : `${from} \u2192 ${to}`;
    return [name, clock(first?.time_s ?? 0), clock(second?.time_s ?? 0)];
  });
}

test("the rows by line are those of kerf compare", async () => {
  const moves = Array.from({ length: 12 }, (_, i) => `G1 X${(i % 3) * 4} Y${i}`);
  const program = (name: string, body: readonly string[]): string => programFile(["G21 G90 G61 F600", ...body, "M2", ""].join("\n"), name);
  const slow = program("slow.ngc", moves.map((move) => `${move} F1000`));
  const fast = program("fast.ngc", moves.flatMap((move, i) => [`${move} F1200`, ...(i === 4 ? ["G4 P0.1"] : [])]));
  const numbered = program("numbered.ngc", moves.flatMap((move, i) => [`N${i} ${move}${i === 7 ? " F300 (slow)" : " ; as before"}`, ...(i % 5 === 4 ? ["G4 P0.2", "(rest)"] : [])]));
  for (const [before, after] of [[slow, fast], [program("plain.ngc", moves), numbered], [numbered, slow]] as const) {
    const { page } = await openReport([before, after]);
    await page.locator("[data-tab=difference]").click();
    const rows = await page.locator("[data-test=difference-lines] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent!)));
    assert.deepEqual(rows.filter((row) => row[4] !== "").map(([name, , base, other]) => [name, base, other]), rowsOf(before, after));
    await page.context().close();
  }
});
