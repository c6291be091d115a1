// The page's address, which brings back what was seen.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fragmentOf, openReport, pocket, programFile } from "./report.ts";

test("keeps the view in its address: instant, place of the eye, charts, colour, tab", async () => {
  const { page, said } = await openReport([pocket], "#tick=1000");
  const box = (await page.locator(".path-view").boundingBox())!;
  await page.mouse.move(box.x + 100, box.y + 60);
  await page.mouse.wheel(0, -480);
  await page.waitForTimeout(100);
  await page.locator("button", { hasText: /^near$/ }).click();
  await page.locator("select[aria-label^=Along]").selectOption("y");
  await page.locator("[data-tab=answer]").click();
  const hash = await fragmentOf(page);
  const words = new URLSearchParams(hash.slice(1));
  assert.deepEqual([words.get("tick"), words.get("track"), words.get("tab"), words.get("span")], ["1000", "y", "answer", "900,1100"]);
  assert.ok(words.get("view"));
  const again = await openReport([pocket], hash);
  await again.page.waitForTimeout(200);
  assert.equal(await fragmentOf(again.page), hash);
  assert.equal(await again.page.locator("[data-test=lines]").isVisible(), true);
  assert.equal(await again.page.locator("select[aria-label^=Along]").inputValue(), "y");
  const over = (await again.page.locator(".u-over").first().boundingBox())!;
  await again.page.mouse.move(over.x + 0.5 * over.width, over.y + 10);
  assert.ok(Math.abs(Number(await again.page.locator(".instant").getAttribute("data-tick")) - 1000) <= 1);
  assert.deepEqual([...said, ...again.said], []);
  await page.context().close();
  await again.page.context().close();
});

test("keeps a view of a button in its address, until it is the usual one again", async () => {
  const { page, said } = await openReport([pocket], "#tick=1000");
  const usual = await fragmentOf(page);
  await page.locator("[data-side=front]").click();
  const hash = await fragmentOf(page);
  const again = await openReport([pocket], hash);
  assert.equal(await fragmentOf(again.page), hash);
  await page.locator("[data-side=iso]").click();
  assert.equal(await fragmentOf(page), usual);
  assert.deepEqual([...said, ...again.said], []);
  await page.context().close();
  await again.page.context().close();
});

test("keeps the parts that are chosen in the legend and the speed of playing in its address", async () => {
  const { page, said } = await openReport([pocket], "#colour=limit");
  const dimmed = (at: typeof page): Promise<string[]> => at.locator(".legend.parts button.dimmed").allTextContents();
  await page.locator(".legend.parts button").nth(1).click();
  await page.locator(".legend.parts button").nth(2).click();
  await page.locator("select[aria-label^=Speed]").selectOption("0.25");
  const hash = await fragmentOf(page);
  const again = await openReport([pocket], hash);
  assert.equal(await fragmentOf(again.page), hash);
  assert.equal(await again.page.locator(".legend.parts button[aria-pressed=true]").count(), 2);
  assert.deepEqual(await dimmed(again.page), await dimmed(page));
  assert.equal(await again.page.locator("select[aria-label^=Speed]").inputValue(), "0.25");
  const picture = (at: typeof page): Promise<Buffer> => at.locator(".path-view canvas").first().screenshot();
  await page.mouse.move(1, 1);
  await page.waitForTimeout(200);
  assert.ok((await picture(again.page)).equals(await picture(page)), "the path is dimmed alike");
  const other = await openReport([pocket], "#colour=limit&shown=77");
  assert.equal(await other.page.locator(".legend.parts button.dimmed").count(), 0, "what this legend has not dims nothing");
  assert.deepEqual([...said, ...again.said, ...other.said], []);
  for (const { page: one } of [again, other]) await one.context().close();
  await page.context().close();
});

test("a report opens in the units of its program, or of --units, and the address names others", async () => {
  const feedUnit = async (words: readonly string[], fragment = ""): Promise<string> => {
    const { page } = await openReport(words, fragment);
    const name = (await page.locator(".chart-name").first().textContent())!;
    await page.context().close();
    return name;
  };
  const inch = programFile("G20 G90 F20\nG1 X1\nM2\n");
  assert.equal(await feedUnit([inch]), "feed, in/min");
  assert.equal(await feedUnit([inch, "--units", "mm/s"]), "feed, mm/s");
  assert.equal(await feedUnit([inch], "#length=mm&per=s"), "feed, mm/s");
  const { page } = await openReport([inch]);
  await page.locator("button", { hasText: /^mm$/ }).click();
  assert.equal(new URLSearchParams((await fragmentOf(page)).slice(1)).get("length"), "mm");
  await page.context().close();
});
