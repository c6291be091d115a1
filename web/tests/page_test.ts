// Reports as their readers meet them: opened from disk in Chromium without a network, beside what kerf says in JSON and in
// its trace.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium, type Browser, type Page } from "playwright-core";
import { clock, lengthText } from "../src/units.ts";

const KERF = process.env["KERF"] ?? "";
const SOURCE = process.env["KERF_SOURCE"] ?? "";
const folder = mkdtempSync(join(tmpdir(), "kerf-page-"));
const MM = { length: "mm", time: "min" } as const;

let browser: Browser;
before(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    // The path is drawn by the processor where there is no graphics card.
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])],
  });
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

interface Opened {
  readonly page: Page;
  readonly said: string[]; // by the console: nothing is to be
  readonly size: number;
}

function kerf(...words: string[]): { status: number; out: string } {
  try {
    return { status: 0, out: execFileSync(KERF, words, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 }) };
  } catch (error) {
    const failed = error as { status: number; stdout: string };
    return { status: failed.status, out: failed.stdout };
  }
}

async function openFile(file: string, fragment = ""): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, offline: true });
  const page = await context.newPage();
  const said: string[] = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (!request.url().startsWith("file:") && !request.url().startsWith("blob:")) said.push(`asked for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href + fragment);
  await page.waitForSelector("header", { timeout: 30_000 });
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return { page, said, size: statSync(file).size };
}

let count = 0;
async function openReport(words: readonly string[], fragment = ""): Promise<Opened> {
  const file = join(folder, `${++count}.html`);
  kerf("report", "-q", ...words, "-o", file);
  return openFile(file, fragment);
}

function programFile(text: string | Buffer, name = `${++count}.ngc`): string {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
}

interface TraceRow {
  readonly t_s: number;
  readonly line: number;
  readonly v: number;
  readonly x: number;
  readonly limit: string;
}

function traceOf(program: string): TraceRow[] {
  const file = join(folder, "trace.csv");
  kerf("dry-run", "-q", program, "--trace", file, "--explain-speed");
  return readFileSync(file, "utf8")
    .trim()
    .split("\n")
    .slice(1)
    .map((row) => {
      const words = row.split(",");
      return { t_s: Number(words[0]), line: Number(words[1]), v: Number(words[3]), x: Number(words[6]), limit: words[words.length - 1]! };
    });
}

const textOf = async (page: Page, name: string): Promise<string> => (await page.locator(`[data-test="${name}"]`).first().textContent()) ?? "";
const shown = (text: string): string => text.replaceAll("\u2212", "-").replaceAll("\u2009", "");

// The scrubber is how a hand on the keyboard moves the instant.
async function goTo(page: Page, tick: number): Promise<void> {
  await page.locator(".scrub").evaluate((input, value) => {
    (input as HTMLInputElement).value = String(value);
    input.dispatchEvent(new Event("input"));
  }, tick);
}

// What the editor marks as the present line: its number in the text.
async function markedLine(page: Page): Promise<string> {
  return (await page.locator(".cm-now").first().textContent()) ?? "";
}

const shipped = readdirSync(join(SOURCE, "programs")).filter((name) => name.endsWith(".ngc"));

describe("a report of a shipped program", () => {
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

      // The split adds up, and its rapids are those of the trace.
      const parts = await page.locator('[data-test^="time-"]').allTextContents();
      assert.ok(parts.length >= 2);

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
});
