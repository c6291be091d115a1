// Who writes in the playground: what stays where it is, what is said of a run that is no more of the text, and what opens a file.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import type { JSHandle } from "playwright-core";
import { clock } from "../src/units.ts";
import { SOURCE, after_, caretTo, choose, compare, dist, folder, newPage, open, page, planned, program, said, shownTime, slowProgram, status, timeOf, written } from "./playground.ts";

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
  await after_(() => page.keyboard.type("(end)"));
  const before = await top();
  assert.ok(before > 100, `scrolled by ${before}`);
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

// Of each line that is seen; empty: it has none.
const times = (): Promise<string[]> =>
  page.locator(".program-view .cm-line").evaluateAll((lines) => {
    const marks = [...lines[0]!.closest(".cm-scroller")!.querySelectorAll(".cm-times .cm-gutterElement")].filter((one) => getComputedStyle(one).visibility !== "hidden");
    const top = (element: Element): number => element.getBoundingClientRect().top;
    return lines.map((line) => marks.find((one) => Math.abs(top(one) - top(line)) < 3)?.textContent ?? "");
  });
const older = (): Promise<boolean> => page.locator(".older-note").isVisible();

test("what is shown is marked as of the run before as long as no other takes its place, and the times of lines move with the text", async () => {
  await open("Open a program", program("G1 F600 X10\nX20\nX40\nM2\n", "lines.ngc"));
  assert.equal(await older(), false);
  await caretTo();
  const [one, two, three] = (await times()) as [string, string, string];
  await wrongMachine();
  await settled(500);
  assert.equal(await older(), true);
  await caretTo("Control+Home", "End");
  await after_(() => page.keyboard.type("\nX15"));
  assert.deepEqual((await times()).slice(0, 4), [one, "", two, three]);
  await page.locator(".scrub").evaluate((input) => {
    (input as HTMLInputElement).value = (input as HTMLInputElement).max;
    input.dispatchEvent(new Event("input"));
  });
  await settled(200);
  assert.equal(await page.locator(".cm-now").textContent(), "M2");
  await rightMachine();
  assert.equal(await older(), false);
  assert.notEqual((await times())[1], "");
});

test("a program that is opened beside a faulty machine file is the one that is written on", async () => {
  await wrongMachine();
  await open("Open a program", program("G1 F600 X5\nM2\n", "other.ngc"));
  assert.equal(await written(), "G1 F600 X5");
  assert.equal((await times()).join(""), "", "no times of the program before");
  await rightMachine();
  assert.equal(await shownTime(), clock(timeOf(join(folder, "other.ngc"))));
});

// Files as they are dropped on a part of the page; says whether the page has taken them from the browser.
async function drop(on: string, files: readonly (readonly [name: string, text: string])[]): Promise<boolean> {
  const data: JSHandle<DataTransfer> = await page.evaluateHandle((all) => {
    const transfer = new DataTransfer();
    for (const [name, text] of all) transfer.items.add(new File([text], name));
    return transfer;
  }, files);
  return page.locator(on).first().evaluate((element, dataTransfer) => {
    const event = (name: string): DragEvent => new DragEvent(name, { dataTransfer, bubbles: true, composed: true, cancelable: true });
    return !element.dispatchEvent(event("dragover")) && !element.dispatchEvent(event("drop"));
  }, data);
}

test("files that are dropped anywhere are opened as by the button", async () => {
  for (const on of [".strip", ".path-view", ".program-view .cm-content"]) {
    await open("Open a program", program("G1 F600 X7\nM2\n", "there.ngc"));
    await after_(async () => assert.equal(await drop(on, [["line.ngc", "o<line> sub\nG1 F300 X#1\no<line> endsub\nM2\n"], ["calls.ngc", "o<line> call [7]\nM2\n"]]), true, on));
    assert.equal(await written(), "o<line> call [7]");
    assert.equal(await page.locator("h1").textContent(), "calls.ngc");
  }
  const slow = "[path]\nmax_velocity_mm_s = 5\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = 1000\n";
  await after_(() => drop(".strip", [["dropped.toml", slow]]));
  assert.match((await page.locator(".what").textContent()) ?? "", /^dropped\.toml/);
  assert.equal(await written(), "o<line> call [7]");
  await rightMachine();
});

test("leaving asks where something was written, and only there", async () => {
  const asks = (): Promise<boolean> => page.evaluate(() => !window.dispatchEvent(new Event("beforeunload", { cancelable: true })));
  await open("Open a program", program("G1 F600 X10\nM2\n", "left.ngc"));
  assert.equal(await asks(), false);
  await caretTo("Control+Home");
  await after_(() => page.keyboard.type("(1)"));
  assert.equal(await asks(), true);
  await after_(() => page.keyboard.press("Control+z"));
  assert.equal(await asks(), false);
});

test("another program in place of what was written can be undone, with its name and its subprograms", async () => {
  const main = program("o<line> call [7]\nM2\n", "main.ngc");
  await open("Open a program", main, program("o<line> sub\nG1 F300 X#1\no<line> endsub\nM2\n", "line.ngc"));
  const time = await shownTime();
  await after_(() => choose("Example program", "star.ngc"));
  assert.notEqual(await shownTime(), time);
  await caretTo();
  await after_(() => page.keyboard.press("Control+z"));
  assert.equal(await written(), "o<line> call [7]");
  assert.equal(await page.locator("h1").textContent(), "main.ngc");
  assert.equal(await shownTime(), time);
});

test("from the keyboard an example is opened by Enter, by no arrow key", async () => {
  await open("Open a program", program("G1 F600 X10\nM2\n", "keys.ngc"));
  await page.locator('[aria-label="Example program"]').focus();
  await page.keyboard.press("ArrowDown");
  await settled();
  assert.equal(await written(), "G1 F600 X10");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await after_(() => page.keyboard.press("Enter"));
  assert.equal(await page.locator("h1").textContent(), "butterfly.ngc");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".menu-list:visible").count(), 0);
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

test("a file that cannot be read is told until another is chosen, whatever is planned meanwhile", async () => {
  const input = page.locator('input[aria-label^="Open a program"]');
  const isTold = (): Promise<boolean> => page.evaluate(() => document.querySelector(".refusal")?.textContent === "gone.ngc cannot be read: it is gone");
  await open("Open a program", program("M2\n", "there.ngc"));
  await input.setInputFiles(slowProgram("meanwhile.ngc"));
  await page.waitForFunction(() => document.querySelector("[data-test=status]")?.textContent === "planning\u2026");
  await page.evaluate(() => {
    const { text } = Blob.prototype;
    Blob.prototype.text = () => {
      Blob.prototype.text = text;
      return Promise.reject(new Error("it is gone"));
    };
  });
  await input.setInputFiles(program("M2\n", "gone.ngc"));
  await page.locator(".refusal:visible").waitFor();
  assert.ok(await isTold());
  assert.match(await status(), /^planning/);
  await planned();
  assert.ok(await isTold());
  await open("Open a program", program("M2\n", "found.ngc"));
  assert.equal(await page.locator(".refusal:visible").count(), 0);
});

test("a machine file that cannot be read is told beside a program that can", async () => {
  await page.evaluate(() => {
    const { text } = Blob.prototype;
    Blob.prototype.text = function (this: File) {
      return this.name === "gone.toml" ? Promise.reject(new Error("it is gone")) : text.call(this);
    };
  });
  await page.locator('input[aria-label^="Open a machine"]').setInputFiles(program("", "gone.toml"));
  await open("Open a program", program("G1 F600 X10\nM2\n", "beside.ngc"));
  assert.equal(await page.locator(".refusal:visible").textContent(), "gone.toml cannot be read: it is gone");
  await after_(() => choose("Example machine", "table.toml"));
  assert.equal(await page.locator(".refusal:visible").count(), 0);
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
  await other.evaluate(() => (window as unknown as { fail: () => void }).fail());
  assert.equal(await estimate.textContent(), "not planned");
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
