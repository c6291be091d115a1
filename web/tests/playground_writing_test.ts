// Who writes in the playground: what stays where it is, and what is said of a run that is no more of the text.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { SOURCE, after_, caretTo, choose, compare, dist, newPage, open, page, planned, program, said, slowProgram, timesOfLines, written } from "./playground.ts";

const pocket = join(SOURCE, "programs", "pocket.ngc");
const wrongMachine = (): Promise<void> => open("Open a machine file", program("[path]\nmax_velocty_mm_s = 5\n", "wrong.toml"));
const rightMachine = (): Promise<void> => after_(() => choose("Example machine", "table.toml"));
const settled = (ms = 400): Promise<void> => page.waitForTimeout(ms);

test("what is written stays, with its undo, while the run before is looked at, whose text cannot be changed", async () => {
  await open("Open a program", program("G1 F600 X10\nM2\n", "before.ngc"));
  await compare();
  await caretTo("Control+Home");
  await after_(() => page.keyboard.type("(now)"));
  const several = page.locator('header select[aria-label="Program"]');
  await several.selectOption("1");
  assert.equal(await written(), "G1 F600 X10");
  assert.equal(await page.locator("[data-test=read-only]").isVisible(), true);
  await page.locator(".program-view .cm-content").focus();
  await page.keyboard.type("x");
  await settled();
  assert.equal(await written(), "G1 F600 X10");
  await several.selectOption("0");
  assert.equal(await written(), "(now)G1 F600 X10");
  assert.equal(await page.locator("[data-test=read-only]").isVisible(), false);
  await page.locator(".program-view .cm-content").focus();
  await after_(() => page.keyboard.press("Control+z"));
  assert.equal(await written(), "G1 F600 X10");
  await compare();
});

test("a plan of what is typed leaves the text where it is, at the caret", async () => {
  await open("Open a program", pocket);
  await caretTo("Control+End");
  await settled();
  const top = (): Promise<number> => page.locator(".program-view .cm-scroller").evaluate((panel) => panel.scrollTop);
  const before = await top();
  assert.ok(before > 100, `scrolled by ${before}`);
  await after_(() => page.keyboard.type("(end)"));
  await settled();
  assert.equal(await top(), before);
  await after_(() => page.keyboard.type("(and on)"));
  await settled();
  assert.equal(await top(), before);
});

test("the page stays at its head where it is too narrow for panels side by side", async () => {
  await open("Open a program", pocket);
  await page.setViewportSize({ width: 820, height: 900 });
  await page.evaluate(() => scrollTo(0, 0));
  for (const tick of [60_000, 400, 105_000]) {
    await page.locator(".scrub").evaluate((input, value) => {
      (input as HTMLInputElement).value = String(value);
      input.dispatchEvent(new Event("input"));
    }, tick);
    await settled(300);
    assert.equal(await page.evaluate(() => scrollY), 0);
  }
  await page.setViewportSize({ width: 1280, height: 720 });
});

// The status once the progress of a plan has a line and its time an estimate, however soon other words take their place.
const statusAtFirstLine = (): Promise<string> =>
  page.evaluate(
    () =>
      new Promise((resolve, reject) => {
        const said = (name: string): string => document.querySelector(`[data-test=${name}]`)?.textContent ?? "";
        const look = (): void => {
          if (!/^up to line \d/.test(said("progress")) || !/^about /.test(said("estimate"))) return;
          observer.disconnect();
          resolve(said("status"));
        };
        const observer = new MutationObserver(look);
        observer.observe(document.body, { childList: true, subtree: true, characterData: true });
        setTimeout(() => reject(new Error("no line and no estimate in a minute")), 60_000);
      }),
  );

const LOOP = "G21 G91 G61 F6000\no1 repeat [30000]\nG1 X1\nX-1\no1 endrepeat\nM2\n";
for (const [what, files] of [
  ["a loop", [["loop.ngc", LOOP]]],
  ["a subprogram in a file of its own", [["caller.ngc", "o<rounds> call\nM2\n"], ["rounds.ngc", `o<rounds> sub\n${LOOP.replace("M2\n", "")}o<rounds> endsub\nM2\n`]]],
] as const) {
  test(`the path of a short text that runs long, by ${what}, is there before its times`, async () => {
    await planned();
    const then = statusAtFirstLine();
    await page.locator('input[aria-label^="Open a program"]').setInputFiles(files.map(([name, text]) => program(text, name)));
    assert.match(await then, /^planning/);
  });
}

test("a view that is being turned stays in the hand while the times of its path come", async () => {
  await open("Open a program", pocket);
  const view = (): string | null => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("view");
  const { x, y, width, height } = (await page.locator(".path-view canvas").first().boundingBox())!;
  await after_(async () => {
    await page.locator('input[aria-label^="Open a program"]').setInputFiles(slowProgram("turned.ngc"));
    await page.locator("[data-test=planning]").waitFor({ timeout: 60_000 });
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 30, { steps: 4 });
  });
  assert.equal(view(), null, "the hand has not let go");
  await page.mouse.up();
  await settled();
  assert.match(view() ?? "", /\d/, "the view is the one that was turned to");
});

test("a run that is on its way is no run to compare with yet", async () => {
  const isDisabled = (): Promise<string | null> => page.locator("button", { hasText: "compare with this run" }).getAttribute("aria-disabled");
  await after_(async () => {
    await page.locator('input[aria-label^="Open a program"]').setInputFiles(slowProgram("on_its_way.ngc"));
    await page.locator("[data-test=planning]").waitFor({ timeout: 60_000 });
    assert.equal(await isDisabled(), "true");
    await page.locator("[data-tab=difference]").click();
    await page.locator("button", { hasText: "compare with this run" }).click({ force: true });
  });
  assert.equal(await page.locator("[data-test=difference-whole]").count(), 0);
  assert.equal(await isDisabled(), "false");
});

const older = (): Promise<boolean> => page.locator(".older-note").isVisible();

test("what is shown is marked as of the run before as long as no other takes its place, and the times of lines move with the text", async () => {
  await open("Open a program", program("G1 F600 X10\nX20\nX40\nM2\n", "lines.ngc"));
  assert.equal(await older(), false);
  await caretTo();
  const [one, two, three] = (await timesOfLines()) as [string, string, string];
  await wrongMachine();
  await settled(500);
  assert.equal(await older(), true);
  await caretTo("Control+Home", "End");
  await after_(() => page.keyboard.type("\nX15"));
  assert.deepEqual((await timesOfLines()).slice(0, 4), [one, "", two, three]);
  await page.locator(".scrub").evaluate((input) => {
    (input as HTMLInputElement).value = (input as HTMLInputElement).max;
    input.dispatchEvent(new Event("input"));
  });
  await settled(200);
  assert.equal(await page.locator(".cm-now").textContent(), "M2");
  await rightMachine();
  assert.equal(await older(), false);
  assert.notEqual((await timesOfLines())[1], "");
});

test("the instant goes with the caret that a key takes to another line", async () => {
  await open("Open a program", program("G1 F600 X10\nX20\nX40\nM2\n", "caret.ngc"));
  await caretTo("Control+Home");
  const instant = async (): Promise<string> => (await page.locator("[data-test=instant]").textContent()) ?? "";
  await page.keyboard.press("ArrowDown");
  assert.match(await instant(), /line 2$/);
  await page.keyboard.press("ArrowDown");
  assert.match(await instant(), /line 3$/);
  await page.keyboard.press("ArrowRight");
  assert.match(await instant(), /line 3$/);
  await page.keyboard.press("Control+Home");
  assert.match(await instant(), /line 1$/);
});

test("the charts go down to the tick also where a report does not", async () => {
  const note = async (): Promise<string> => (await page.locator(".time-view .note").textContent()) ?? "";
  await open("Open a program", program("G1 F600 X10\nG4 P900\nM2\n", "quarter_hour.ngc"));
  assert.equal(await note(), "");
  await open("Open a program", program("G1 F600 X10\nG4 P7200\nM2\n", "hours.ngc"));
  assert.match(await note(), /^A column is 8 ticks .*: zoom in to see each tick\.$/);
});

test("a chart that is near has each tick of a long program, which are those of a short one", async () => {
  const note = page.locator(".time-view .note");
  const now = (what: string): Promise<string | null> => page.locator(`[data-test=now-${what}]`).textContent();
  const ticksOfLine3 = async (dwell_s: number): Promise<string[]> => {
    await open("Open a program", program(`G1 F600 X10\nG4 P${dwell_s}\nG1 X40\nM2\n`, `dwell${dwell_s}.ngc`));
    await caretTo("Control+Home", "ArrowDown", "ArrowDown");
    await page.locator("button", { hasText: "near" }).click();
    await page.waitForFunction(() => /^(Each tick is shown here\.)?$/.test(document.querySelector(".time-view .note")?.textContent ?? "?"));
    await page.locator(".time-view").focus();
    const seen: string[] = [];
    for (let i = 0; i < 20; ++i) {
      await page.keyboard.press(".");
      seen.push((await Promise.all(["v", "a", "j"].map(now))).join(" "));
    }
    return seen;
  };
  const short = await ticksOfLine3(1);
  assert.ok(new Set(short).size > 15 && !short.join().includes("\u2026"), short.join());
  assert.deepEqual(await ticksOfLine3(1500), short);
  await page.locator("button", { hasText: "all", hasNotText: "install" }).first().click();
  await page.waitForFunction(() => /zoom in to see each tick/.test(document.querySelector(".time-view .note")?.textContent ?? ""));
  assert.equal(await note.count(), 1);
});

test("what the charts show stays where the same program is planned anew", async () => {
  await open("Open a program", program("G1 F600 X10\nX20\nM2\n", "zoomed.ngc"));
  await caretTo("Control+Home", "ArrowDown");
  await page.locator("button", { hasText: "near" }).click();
  const span = async (): Promise<string | null> => {
    await page.waitForTimeout(400); // the address follows a moment later
    return new URLSearchParams(new URL(page.url()).hash.slice(1)).get("span");
  };
  const near = await span();
  assert.match(near ?? "", /^\d+,\d+$/);
  await after_(() => page.locator("select[aria-label=Profile]").selectOption("s-curve"));
  assert.equal(await span(), near);
  await after_(() => page.locator("select[aria-label=Profile]").selectOption("time-optimal"));
  await open("Open a program", program("G1 F600 X30\nM2\n", "other.ngc"));
  assert.equal(await span(), null, "another program is seen as a whole");
});

test("a kernel that fails after the path is shown leaves no time on its way", async () => {
  const other = await newPage();
  await other.addInitScript(() => {
    const { Worker } = window;
    window.Worker = class extends Worker {
      constructor(script: string | URL) {
        super(script);
        Object.assign(window, { fail: () => this.dispatchEvent(new ErrorEvent("error", { message: "out of memory" })) });
      }
    };
  });
  await other.goto(pathToFileURL(dist).href);
  await other.waitForFunction(() => /^planned/.test(document.querySelector("[data-test=status]")?.textContent ?? ""), null, { timeout: 60_000 });
  const estimate = other.locator("[data-test=estimate]");
  await other.locator('input[aria-label^="Open a program"]').setInputFiles(slowProgram("fails.ngc"));
  await estimate.waitFor();
  const expected = other.locator(".program-view .cm-time", { hasText: "\u2248" });
  await other.locator(".program-view .cm-scroller").evaluate((element) => (element.scrollTop = element.scrollHeight));
  await expected.first().waitFor();
  await other.evaluate(() => (window as unknown as { fail: () => void }).fail());
  assert.equal(await estimate.textContent(), "not planned");
  assert.equal(await expected.count(), 0);
  assert.equal(await other.locator(".refusal").textContent(), "The kernel has failed: out of memory");
  await other.locator("button", { hasText: "inch" }).click();
  assert.equal(await estimate.textContent(), "not planned");
  await other.context().close();
});

test("a kernel that cannot be started is told", async () => {
  const other = await newPage();
  await other.addInitScript(() => {
    const { Blob } = window;
    window.Blob = class extends Blob {
      constructor(parts: BlobPart[] = [], options?: BlobPropertyBag) {
        super(["WebAssembly.instantiate = () => Promise.reject(new Error('too little memory'));", ...parts], options);
      }
    };
  });
  await other.goto(pathToFileURL(dist).href);
  await other.waitForFunction(() => /cannot be shown: The kernel has failed: Error: too little memory/.test(document.querySelector(".failure")?.textContent ?? ""), null, { timeout: 20_000 });
  await other.context().close();
});

test("the console says nothing", async () => {
  await planned();
  assert.deepEqual(said, []);
});
