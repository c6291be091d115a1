// Who writes in the playground: what stays where it is, what is said of a run that is no more of the text, and what opens a file.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { SOURCE, after_, caretTo, open, page, planned, program, said, written } from "./playground.ts";

const pocket = join(SOURCE, "programs", "pocket.ngc");
const settled = (ms = 400): Promise<void> => page.waitForTimeout(ms);

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

test("the console says nothing", async () => {
  await planned();
  assert.deepEqual(said, []);
});
