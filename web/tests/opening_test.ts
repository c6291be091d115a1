// In which order a long program comes to be seen.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { linesInSteps, linesOf } from "../src/views/planned_lines.ts";
import { fragmentOf, goTo, markedLine, openReport, programFile, textOf, traceOf } from "./report.ts";

interface Noted extends Window {
  noted: string[]; // what has happened
  text: string; // the longest that was decoded
}

// Notes in the page when the path is drawn and when a long text is decoded; the first of them moves the instant.
function note(): void {
  const page = window as unknown as Noted;
  page.noted = [];
  page.text = "";
  const { decode } = TextDecoder.prototype;
  TextDecoder.prototype.decode = function (...words) {
    const text = decode.apply(this, words);
    if (text.length > 100_000) {
      const lines = document.querySelector(".program-view > div")?.shadowRoot?.querySelectorAll(".cm-line").length;
      page.noted.push(`text beside ${document.querySelectorAll("header").length} header and ${lines ? "lines" : "no line"}`);
      page.text = text;
    }
    return text;
  };
  const drawn = new MutationObserver(() => {
    if (!document.querySelector(".path-view canvas[data-vertices]")) return;
    drawn.disconnect();
    page.noted.push("path");
    const scrub = document.querySelector<HTMLInputElement>(".scrub")!;
    if (!location.hash.includes("tick")) scrub.value = "5000";
    scrub.dispatchEvent(new Event("input"));
  });
  drawn.observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["data-vertices"] });
}

const longProgram = (): string => programFile(`G21 G90 F6000\n${Array.from({ length: 8000 }, (_, i) => `G1 X${((i % 40) / 8).toFixed(3)} Y${(i / 1000).toFixed(3)}`).join("\n")}\nM2\n`);

test("answer and path of a long program are seen before its first lines, and these before the whole text is made", async () => {
  const program = longProgram();
  const { page, said } = await openReport([program], "", note);
  await page.waitForFunction(() => (window as unknown as Noted).noted.length === 3);
  assert.deepEqual(await page.evaluate(() => (window as unknown as Noted).noted), ["path", "text beside 1 header and no line", "text beside 1 header and lines"]);
  assert.equal(await page.evaluate(() => (window as unknown as Noted).text), readFileSync(program, "utf8"));
  // The instant was moved before there was a text.
  const lines = readFileSync(program, "utf8").split("\n");
  const lineAt = traceOf(program).map(({ line }) => line);
  await page.locator(".cm-now").waitFor();
  assert.equal(await markedLine(page), lines[lineAt[5000]! - 1]);
  await goTo(page, lineAt.length - 2);
  assert.equal(await markedLine(page), lines[lineAt[lineAt.length - 2]! - 1]);
  assert.deepEqual(said, []);
  await page.context().close();
});

test("the line of the instant in the address is marked once the text is there, and one that is chosen is gone to", async () => {
  const program = longProgram();
  const lineAt = traceOf(program).map(({ line }) => line);
  const { page, said } = await openReport([program], "#tick=9000", note);
  await page.locator(".cm-now").waitFor();
  assert.equal(await markedLine(page), readFileSync(program, "utf8").split("\n")[lineAt[9000]! - 1]);
  await page.locator(".cm-line").nth(3).click();
  const chosen = /line (\d+)$/.exec(await textOf(page, "instant"))![1];
  assert.match(await fragmentOf(page), new RegExp(`tick=${lineAt.indexOf(Number(chosen))}`));
  assert.deepEqual(said, []);
  await page.context().close();
});

test("lines that are made in steps are those that are made at once", () => {
  const row = "G1 X1.234 Y5.678\n";
  for (const text of ["", "\n", "G1", "G1\n\n", row.repeat(200_000), `${row.repeat(200_000)}M2`, "X".repeat(3_000_000)]) {
    const steps = linesInSteps(text);
    let step = steps.next();
    while (!step.done) step = steps.next();
    assert.ok(step.value.eq(linesOf(text)), `${text.length} characters`);
  }
});
