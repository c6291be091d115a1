// The playground as its visitors meet it: opened from disk in Chromium without a network, beside what kerf itself says.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { clock } from "../src/units.ts";
import { SOURCE, after_, choose, dist, folder, keyIsThere, open, page, program, said, secondsOf, shownTime, slowProgram, status, timeOf, written } from "./playground.ts";

test("every shipped program takes the time that kerf says, to a thousandth", async () => {
  for (const name of readdirSync(join(SOURCE, "programs")).filter((one) => one.endsWith(".ngc"))) {
    const file = join(SOURCE, "programs", name);
    await open("Open a program", file);
    const here = secondsOf(await shownTime());
    const there = timeOf(file);
    const rounding = 0.006 + (there >= 3600 ? 0.05 : 0);
    assert.ok(Math.abs(here - there) <= 0.001 * there + rounding, `${name}: ${here} s in the page, ${there} s by kerf`);
  }
});

test("what is typed is planned, and an error stands at its line until it is mended", async () => {
  await open("Open a program", program("G1 F600 X10\nM2\n", "typed.ngc"));
  assert.equal(await shownTime(), clock(timeOf(join(folder, "typed.ngc"))));
  const editor = page.locator(".program-view .cm-content");
  await editor.click();
  await page.keyboard.press("Control+Home");
  // Each key that is a command of the page elsewhere, too.
  const typed = "G1 G2 X1.5, F1234f ";
  await after_(() => page.keyboard.type(`${typed}\n`));
  assert.equal(await editor.locator(".cm-line").first().textContent(), typed);
  assert.match((await page.locator(".cm-error").textContent()) ?? "", /E\d{4}/);
  assert.equal(await page.locator("canvas.band").evaluate((band) => (band as HTMLCanvasElement).width), 0, "nothing of the plan before");
  assert.equal(await page.locator("[data-test=limit-now]").textContent(), "");
  assert.equal(await page.locator("[data-test=instant]").textContent(), "");
  assert.equal(await page.locator(".now-line").isVisible(), false);
  assert.equal(await editor.locator(".cm-now").count(), 0);
  await after_(async () => {
    for (let i = 0; i <= typed.length; ++i) await page.keyboard.press("Backspace");
  });
  assert.equal(await page.locator(".cm-error").count(), 0);
  assert.equal(await shownTime(), clock(timeOf(join(folder, "typed.ngc"))));
});

test("the text may be deleted and another one typed", async () => {
  await open("Open a program", join(SOURCE, "programs", "pocket.ngc"));
  const editor = page.locator(".program-view .cm-content");
  await editor.click();
  await after_(async () => {
    await page.keyboard.press("Control+a");
    await page.keyboard.press("Delete");
    await page.keyboard.type("G1 F600 X10\nM2\n");
  });
  program("G1 F600 X10\nM2\n", "other.ngc");
  await page.waitForFunction((time) => document.querySelector('[data-test="cycle-time"]')?.textContent === time, clock(timeOf(join(folder, "other.ngc"))), { timeout: 30_000 });
});

test("the path of a program that takes long to plan is there before its times", async () => {
  let estimate_s = 0;
  let early: string[] = [];
  let expected: string[] = [];
  const scrolled = (share: number): Promise<void> =>
    page.locator(".program-view .cm-scroller").evaluate(async (element, share) => {
      element.scrollTop = share * element.scrollHeight;
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    }, share);
  const timesShown = (): Promise<string[]> => page.locator(".program-view .cm-time").allTextContents();
  const lines = Array.from({ length: 5000 }, (_, i) => `G1 X${(80 * Math.sin(i * i)).toFixed(3)} Y${(60 * Math.cos(3 * i * i)).toFixed(3)}`);
  await after_(async () => {
    await page.locator('input[aria-label^="Open a program"]').setInputFiles(program(["G21 G90 G61 F6000", ...lines, "M2", ""].join("\n"), "corners.ngc"));
    await page.locator("[data-test=planning]").waitFor({ timeout: 60_000 });
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    assert.match(await page.locator("[data-test=status]").textContent() ?? "", /^planning/);
    assert.ok(Number(await page.locator(".path-view canvas").first().getAttribute("data-vertices")) > 10_000, "all lines are drawn");
    assert.match(await page.locator("[data-test=fit-verdict]").textContent() ?? "", /^fits/);
    // Then the times of lines as they are planned, and an estimate of the whole.
    await page.waitForFunction(() => /up to line \d{2,}$/.test(document.querySelector("[data-test=so-far]")?.textContent ?? ""), null, { timeout: 60_000 });
    estimate_s = secondsOf((await page.locator("[data-test=estimate]").textContent() ?? "").replace(/^about /, ""));
    early = await timesShown();
    await scrolled(1);
    expected = (await timesShown()).slice(-20);
    await scrolled(0);
  });
  assert.equal(await page.locator("[data-test=planning]").count(), 0);
  const whole_s = timeOf(join(folder, "corners.ngc"));
  assert.equal(await shownTime(), clock(whole_s));
  assert.ok(Math.abs(estimate_s - whole_s) < 0.2 * whole_s, `an estimate of ${estimate_s} s for ${whole_s} s`);
  // The lines that are seen are the first ones: what was said of them stays true.
  assert.ok(early.length > 10);
  assert.deepEqual(early, (await timesShown()).slice(0, early.length));
  // The last ones had an estimate, which is called one.
  await scrolled(1);
  const last = (await timesShown()).slice(-20);
  const sumOf = (times: string[]): number => times.reduce((sum, time) => sum + secondsOf(time.replace("≈", "")), 0);
  assert.equal(expected.length, 20);
  assert.ok(expected.every((time) => time.startsWith("≈")), expected.join(" "));
  assert.ok(!last.some((time) => time.startsWith("≈")), last.join(" "));
  assert.ok(Math.abs(sumOf(expected) - sumOf(last)) < 0.2 * sumOf(last), `${expected.join(" ")} for ${last.join(" ")}`);
});

test("another profile and another machine take their own time", async () => {
  const file = join(SOURCE, "programs", "pocket.ngc");
  await open("Open a program", file);
  await after_(() => page.locator('select[aria-label="Profile"]').selectOption("quintic"));
  assert.equal(await shownTime(), clock(timeOf("--profile", "quintic", file)));
  const machine = program("[path]\nmax_velocity_mm_s = 5\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = 1000\n", "slow.toml");
  await open("Open a machine file", machine);
  assert.equal(await shownTime(), clock(timeOf("--profile", "quintic", "--machine", machine, file)));
  await after_(() => page.locator('select[aria-label="Profile"]').selectOption("time-optimal"));
});

test("another tolerance of the machine takes its own time", async () => {
  const file = program("G21 G90 F6000\nG1 X20\nY20\nX0\nY0\nM2\n", "corners.ngc");
  await open("Open a program", file);
  const limits = "[path]\nmax_velocity_mm_s = 150\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 50000\n";
  const times: number[] = [];
  for (const tolerance of ["0.01", "0.5"]) {
    const machine = program(`${limits}[program]\npath_mode = "G64 P${tolerance} Q${tolerance}"\n`, `p${tolerance}.toml`);
    await open("Open a machine file", machine);
    times.push(timeOf("--machine", machine, file));
    assert.equal(await shownTime(), clock(times.at(-1)!));
  }
  assert.ok(times[1]! < times[0]!);
  await after_(() => choose("Example machine", "table.toml"));
});

test("a machine file that is wrong is refused with its place", async () => {
  await open("Open a machine file", program("[path]\nmax_velocty_mm_s = 5\n", "wrong.toml"));
  assert.match((await page.locator(".refusal").textContent()) ?? "", /wrong\.toml:2:1: error: unknown key 'max_velocty_mm_s'/);
  await after_(() => choose("Example machine", "table.toml"));
  assert.equal(await page.locator(".refusal").isVisible(), false);
});

test("a run that is kept is what later ones are compared with", async () => {
  const [long, short] = [program("G21 G90 G61 F1200\nG1 X100\nM2\n", "long.ngc"), program("G21 G90 G61 F1200\nG1 X50\nM2\n", "short.ngc")];
  await open("Open a program", long);
  await page.locator("[data-tab=difference]").click();
  await page.locator("button", { hasText: "compare with this run" }).click();
  await open("Open a program", short);
  const cells = await page.locator("[data-test=difference-whole] tbody tr").first().locator("td").allTextContents();
  assert.deepEqual(cells.slice(0, 3), ["cycle time", clock(timeOf(long)), clock(timeOf(short))]);
  await after_(() => page.locator("button", { hasText: "compare with this run" }).click());
  assert.equal(await page.locator('[data-test="difference-whole"]').count(), 0);
});

test("a feed override takes the time that kerf says, and can be compared", async () => {
  const file = join(SOURCE, "programs", "pocket.ngc");
  await open("Open a program", file);
  await page.locator("[data-tab=difference]").click();
  await page.locator("button", { hasText: "compare with this run" }).click();
  const feed = page.locator('input[aria-label^="Feed override"]');
  const enter = async (percent: string): Promise<void> => {
    await feed.fill(percent);
    await feed.press("Enter");
  };
  for (const percent of ["50", "150"]) {
    await after_(() => enter(percent));
    assert.equal(await shownTime(), clock(timeOf("--feed-override", percent, file)));
  }
  const cells = await page.locator("[data-test=difference-whole] tbody tr").first().locator("td").allTextContents();
  assert.deepEqual(cells.slice(0, 3), ["cycle time", clock(timeOf(file)), clock(timeOf("--feed-override", "150", file))]);
  await after_(() => enter("100"));
  await page.locator("button", { hasText: "compare with this run" }).click();
});

test("of a feed that is typed no digit alone is planned, and one that is none is refused", async () => {
  const file = join(SOURCE, "programs", "pocket.ngc");
  await open("Open a program", file);
  const feed = page.locator('input[aria-label^="Feed override"]');
  const refused = page.locator("[data-test=feed-refused]");
  const before = await status();
  await feed.fill("");
  for (const digit of "250") {
    await feed.press(digit);
    await page.waitForTimeout(400);
  }
  await feed.press("Enter");
  await page.waitForTimeout(400);
  assert.equal(await status(), before);
  assert.equal(await shownTime(), clock(timeOf(file)));
  assert.match((await refused.textContent()) ?? "", /^not planned: a whole number from 1 to 200 %; it stays at 100 %$/);
  await feed.fill("25");
  await after_(() => feed.press("Enter"));
  assert.equal(await refused.isVisible(), false);
  assert.equal(await shownTime(), clock(timeOf("--feed-override", "25", file)));
  await feed.fill("100");
  await after_(() => feed.press("Enter"));
});

test("no older text takes the place of what is written, and no older run that of what is shown", async () => {
  await open("Open a program", slowProgram("written.ngc"));
  const compare = page.locator("button", { hasText: "compare with this run" });
  await page.locator("[data-tab=difference]").click();
  await after_(() => compare.click());
  await page.locator("[data-tab=program]").click();
  await page.locator(".program-view .cm-content").click();
  await page.keyboard.press("Control+Home");
  for (const [key, expected] of [["1", "(1)G21 G90 G61 F6000"], ["2", "(1)(2)G21 G90 G61 F6000"]] as const) {
    const editor = await page.locator(".program-view .cm-editor").elementHandle();
    await after_(async () => {
      await page.keyboard.type(`(${key})`);
      await keyIsThere(expected);
      const end = Date.now() + 120_000;
      while (Date.now() < end && !/^planned/.test((await page.locator("[data-test=status]").textContent()) ?? "")) {
        assert.equal(await written(), expected);
        await page.waitForTimeout(50);
      }
    });
    assert.equal(await written(), expected);
    assert.ok(await editor!.evaluate((element) => element.isConnected), "the same editor, with its caret");
  }
  await page.locator("[data-tab=difference]").click();
  await after_(() => compare.click());
});

test("a key within the path's patience is not lost", async () => {
  await open("Open a program", slowProgram("typed_on.ngc"));
  await page.locator("[data-tab=program]").click();
  await page.locator(".program-view .cm-content").click();
  await page.keyboard.press("Control+Home");
  await after_(async () => {
    let text = "";
    for (const key of "(abcdef") {
      await page.keyboard.type(key);
      text += key;
      await keyIsThere(`${text}G21 G90 G61 F6000`);
      for (let i = 0; i < 13; ++i) {
        assert.equal(await written(), `${text}G21 G90 G61 F6000`);
        await page.waitForTimeout(50);
      }
    }
    await page.keyboard.type(")");
    await page.evaluate(() => (document.querySelector('[data-test="status"]')!.textContent = ""));
  });
  assert.equal(await written(), "(abcdef)G21 G90 G61 F6000");
});

test("what is chosen again before another plan is there stays", async () => {
  await open("Open a program", slowProgram("chosen.ngc"));
  const time = await shownTime();
  const profile = page.locator('select[aria-label="Profile"]');
  await profile.selectOption("quintic");
  await page.waitForTimeout(900);
  await after_(() => profile.selectOption("time-optimal"));
  for (let i = 0; i < 60; ++i) {
    assert.equal(await page.locator("[data-test=planning]").count(), 0);
    assert.equal(await shownTime(), time);
    await page.waitForTimeout(100);
  }
});

test("a run that was refused is not kept to be compared with", async () => {
  await open("Open a program", program("G21 G90 G61 F1200\nG1 X100\nM2\n", "kept.ngc"));
  await open("Open a machine file", program("[path]\nmax_velocty_mm_s = 5\n", "wrong.toml"));
  const compare = page.locator("button", { hasText: "compare with this run" });
  await page.locator("[data-tab=difference]").click();
  await after_(() => compare.click());
  await after_(() => choose("Example machine", "table.toml"));
  assert.equal(await page.locator(".refusal").isVisible(), false);
  assert.equal(await shownTime(), clock(timeOf(join(folder, "kept.ngc"))));
  await after_(() => compare.click());
});

test("a subprogram is found beside its program", async () => {
  const main = program("o<line> call [7]\nM2\n", "main.ngc");
  await open("Open a program", main, program("o<line> sub\nG1 F300 X#1\no<line> endsub\nM2\n", "line.ngc"));
  assert.equal(await shownTime(), clock(timeOf(main)));
});

test("texts of a hostile program are shown, not run", async () => {
  await open("Open a program", program("(<script>document.title='x'</script>)\n(MSG, <img src=x onerror=alert(1)>)\nG1 F100 X1\nM2\n", "<img src=x>.ngc"));
  assert.notEqual(await page.title(), "x");
  assert.equal(await page.locator("main img").count(), 0);
});

test("the console says nothing, and nothing is asked of the network", () => {
  assert.deepEqual(said, []);
  assert.ok(readFileSync(dist, "utf8").includes("default-src 'none'"));
});
