// What a frame does while the instant moves, counted: times are those of the machine.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { goTo, markedLine, openReport, pocket, textOf } from "./report.ts";

test("while the instant moves the page is laid out once a frame", async () => {
  const { page, said } = await openReport([pocket], "#tab=answer");
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const layouts = async (): Promise<number> => (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "LayoutCount")!.value;
  await page.waitForTimeout(500); // until all of the page stands
  const before = await layouts();
  await page.evaluate(async () => {
    const scrub = document.querySelector<HTMLInputElement>(".scrub")!;
    for (let i = 1; i <= 20; ++i) {
      scrub.value = String(4000 * i);
      scrub.dispatchEvent(new Event("input"));
      await new Promise((resolve) => requestAnimationFrame(resolve));
    }
  });
  const made = (await layouts()) - before;
  assert.ok(made <= 30, `${made} layouts of 20 frames`);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("after another tab the program stands still, and comes up with the instant when it is seen again", async () => {
  const { page, said } = await openReport([pocket], "#tick=20000");
  const before = await markedLine(page);
  await page.locator("[data-tab=answer]").click();
  await goTo(page, 90_000);
  const line = /line (\d+)$/.exec(await textOf(page, "instant"))![1]!;
  assert.equal(await markedLine(page), before);
  await page.locator("[data-tab=program]").click();
  await page.waitForFunction((text) => document.querySelector(".editor")!.shadowRoot!.querySelector(".cm-now")?.textContent !== text, before);
  assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[Number(line) - 1]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the program's text goes to lines that are not seen a few times a second, and ends where the instant is", async () => {
  const { page, said } = await openReport([pocket]);
  const moves = await page.evaluate(async () => {
    const scrub = document.querySelector<HTMLInputElement>(".scrub")!;
    const marked = (): string => document.querySelector(".editor")!.shadowRoot!.querySelector(".cm-now")?.textContent ?? "";
    let count = 0;
    for (let i = 1; i <= 60; ++i) {
      const before = marked();
      scrub.value = String(i % 2 === 0 ? 3000 + i : 100_000 - i);
      scrub.dispatchEvent(new Event("input"));
      count += marked() === before ? 0 : 1;
    }
    return count;
  });
  assert.ok(moves <= 3, `${moves} of 60 instants`);
  const line = Number(/line (\d+)$/.exec(await textOf(page, "instant"))![1]);
  assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[line - 1]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the line of the instant stands at its place in the charts", async () => {
  const { page, said } = await openReport([pocket], "#tick=20000");
  const last = Number(await page.locator(".scrub").getAttribute("max"));
  const off = async (tick: number): Promise<number> => {
    const over = (await page.locator(".u-over").first().boundingBox())!;
    const line = await page.locator(".now-line").evaluate((element) => element.getBoundingClientRect().left);
    return Math.abs(line - over.x - (tick / last) * over.width);
  };
  assert.ok((await off(20_000)) <= 1);
  await goTo(page, 90_000);
  assert.ok((await off(90_000)) <= 1);
  await page.setViewportSize({ width: 1600, height: 900 });
  await page.waitForTimeout(500);
  assert.ok((await off(90_000)) <= 1);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the address follows the instant without being written each time", async () => {
  const { page, said } = await openReport([pocket]);
  const written = await page.evaluate(async () => {
    let count = 0;
    const replace = history.replaceState.bind(history);
    history.replaceState = (...words) => {
      ++count;
      replace(...words);
    };
    const scrub = document.querySelector<HTMLInputElement>(".scrub")!;
    for (let i = 1; i <= 30; ++i) {
      scrub.value = String(1000 * i);
      scrub.dispatchEvent(new Event("input"));
    }
    await new Promise((resolve) => setTimeout(resolve, 600));
    return count;
  });
  assert.ok(written >= 1 && written <= 2, `${written} times`);
  assert.match(page.url(), /tick=30000/);
  assert.deepEqual(said, []);
  await page.context().close();
});
