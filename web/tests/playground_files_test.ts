// What opens a program or a machine file in the playground, and what is said where that cannot be read.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import type { JSHandle } from "playwright-core";
import { clock } from "../src/units.ts";
import { after_, caretTo, choose, folder, open, page, planned, program, said, shownTime, slowProgram, status, timeOf, timesOfLines, written } from "./playground.ts";

const slow = "[path]\nmax_velocity_mm_s = 5\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = 1000\n";
const rightMachine = (): Promise<void> => after_(() => choose("Example machine", "table.toml"));

test("a program that is opened beside a faulty machine file is the one that is written on", async () => {
  await open("Open a machine file", program("[path]\nmax_velocty_mm_s = 5\n", "wrong.toml"));
  await open("Open a program", program("G1 F600 X5\nM2\n", "other.ngc"));
  assert.equal(await written(), "G1 F600 X5");
  assert.equal((await timesOfLines()).join(""), "", "no times of the program before");
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
  await after_(() => drop(".strip", [["dropped.toml", slow]]));
  assert.match((await page.locator(".what").textContent()) ?? "", /^dropped\.toml/);
  assert.equal(await written(), "o<line> call [7]");
  await rightMachine();
});

test("a tool table that the machine file names is opened with it, or dropped later", async () => {
  const part = program("T1 M6\nG43 H1\nG1 F600 X5 Z2\nM2\n", "tooled.ngc");
  const machine = program(`${slow}[tools]\nfile = "shop.tbl"\n`, "tooled.toml");
  const table: readonly [string, string] = ["shop.tbl", "T1 P1 Z30 D6\n"];
  const listed = program(table[1], table[0]);
  const native_s = timeOf("--machine", machine, part);
  await open("Open a program", part);
  await open("Open a machine file", machine);
  assert.equal(await status(), "not planned");
  assert.match((await page.locator(".refusal:visible").textContent()) ?? "", /^shop\.tbl: error: .*: open it here, too/);
  await after_(() => drop(".strip", [table]));
  assert.equal(await written(), "T1 M6");
  assert.equal(await shownTime(), clock(native_s));

  await rightMachine();
  await open("Open a machine file", listed, machine);
  assert.equal(await shownTime(), clock(native_s));
  await rightMachine();
  await after_(() => drop(".strip", [table, ["tooled.toml", `${slow}[tools]\nfile = "../tables/shop.tbl"\n`]]));
  assert.equal(await written(), "T1 M6");
  assert.equal(await shownTime(), clock(native_s));
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
  await page.waitForTimeout(400);
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

test("the console says nothing", async () => {
  await planned();
  assert.deepEqual(said, []);
});
