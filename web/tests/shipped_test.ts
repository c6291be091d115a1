// The numbers of each shipped program, beside those of kerf.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { clock, lengthText } from "../src/units.ts";
import { MM, SOURCE, goTo, kerf, markedLine, openReport, shown, textOf, traceOf } from "./report.ts";

const shipped = readdirSync(join(SOURCE, "programs")).filter((name) => name.endsWith(".ngc"));

for (const name of shipped) {
  test(`${name} says what kerf says`, async () => {
    const program = join(SOURCE, "programs", name);
    const json = JSON.parse(kerf("dry-run", "--json", "--explain-speed", program).out);
    const trace = traceOf(program);
    const { page, said } = await openReport([program]);

    assert.equal(await textOf(page, "cycle-time"), clock(json.cycle_time_s));
    const extents = shown(await textOf(page, "extents"));
    for (const axis of ["x", "y", "z"]) {
      const [min, max] = [json.extents.min_mm[axis], json.extents.max_mm[axis]].map((mm: number) => shown(lengthText(mm, MM)));
      assert.ok(extents.includes(`${axis.toUpperCase()} ${min} to ${max}`), `${axis} in ${extents}`);
    }
    assert.equal(await textOf(page, "fit-verdict"), "fits the travel");

    // Where the time goes.
    const split: Record<string, number> = json.time_split;
    for (const [part, key] of [["cut", "cutting_s"], ["rapid", "rapid_s"]] as const) assert.equal(await textOf(page, `time-${part}`), clock(split[key]!));
    const sum = Object.values(split).reduce((all, part_s) => all + part_s, 0);
    assert.ok(Math.abs(sum - json.cycle_time_s) < json.period_s, `${sum} of ${json.cycle_time_s}`);

    // An instant: its line, its feed and what limits it.
    for (const share of [0.2, 0.57, 0.9]) {
      const tick = Math.floor(share * (trace.length - 1));
      const row = trace[tick]!;
      await goTo(page, tick);
      assert.match(await textOf(page, "instant"), new RegExp(`tick ${tick}, line ${row.line}$`));
      assert.equal(await textOf(page, "limit-now"), row.limit.replaceAll("_", " "));
      const feed = Number(shown(await textOf(page, "now-v")));
      assert.ok(Math.abs(feed - 60 * row.v) <= 0.001 * 60 * row.v + 0.6, `feed ${feed} of ${60 * row.v}`);
      const line = readFileSync(program, "utf8").split("\n")[row.line - 1]!;
      assert.equal(await markedLine(page), line);
    }

    // The line that takes longest, by the trace.
    const ticks = new Map<number, number>();
    trace.slice(0, -1).forEach((row) => ticks.set(row.line, (ticks.get(row.line) ?? 0) + 1));
    const longest = json.speed_limits_of_lines[0];
    assert.equal(Math.round(longest.time_s / json.period_s), Math.max(...ticks.values()));
    assert.ok((await textOf(page, "slowest")).includes(`line ${longest.line}`));
    assert.deepEqual(said, []);
    await page.context().close();
  });
}
