// Two fingers on the charts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { spanAfter } from "../src/views/chart_touch.ts";
import { fragmentOf, openReport, pocket } from "./report.ts";

test("what is under each finger stays under it", () => {
  const span = { from: 1000, to: 2000 };
  const at = (share: number, { from, to }: { from: number; to: number }): number => from + share * (to - from);
  const [before, now] = [{ first: 0.2, second: 0.6 }, { first: 0.1, second: 0.9 }];
  const after = spanAfter(span, before, now)!;
  assert.ok(Math.abs(at(now.first, after) - at(before.first, span)) < 1e-9);
  assert.ok(Math.abs(at(now.second, after) - at(before.second, span)) < 1e-9);
  assert.deepEqual(spanAfter(span, before, before), span);
});

test("fingers that lie on each other or change places zoom no further", () => {
  const span = { from: 0, to: 100 };
  assert.equal(spanAfter(span, { first: 0.4, second: 0.41 }, { first: 0.1, second: 0.9 }), null);
  assert.equal(spanAfter(span, { first: 0.2, second: 0.6 }, { first: 0.5, second: 0.51 }), null);
  assert.equal(spanAfter(span, { first: 0.2, second: 0.6 }, { first: 0.6, second: 0.2 }), null);
});

test("the charts zoom where two fingers part", async () => {
  const { page, said } = await openReport([pocket]);
  await page.locator(".time-view .charts").evaluate((charts) => {
    const { left, top, width } = charts.querySelector(".u-over")!.getBoundingClientRect();
    const finger = (type: string, pointerId: number, share: number): void =>
      void charts.dispatchEvent(new PointerEvent(type, { pointerId, pointerType: "touch", clientX: left + share * width, clientY: top + 10, bubbles: true }));
    finger("pointerdown", 1, 0.4);
    finger("pointerdown", 2, 0.6);
    finger("pointermove", 1, 0.2);
    finger("pointermove", 2, 0.8);
    finger("pointerup", 1, 0.2);
    finger("pointerup", 2, 0.8);
    finger("pointerleave", 2, 0.8);
  });
  const [from, to] = new URLSearchParams((await fragmentOf(page)).slice(1)).get("span")!.split(",").map(Number);
  const last = Number(await page.locator(".scrub").getAttribute("max"));
  assert.ok(Math.abs((to! - from!) / last - 1 / 3) < 0.01 && Math.abs((from! + to!) / 2 / last - 0.5) < 0.01, `${from} to ${to} of ${last}`);
  assert.deepEqual(said, []);
  await page.context().close();
});
