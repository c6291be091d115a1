// Opens reports as their readers meet them: from disk in Chromium without a network, beside what kerf says in JSON and in its
// trace.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium, type Browser, type Page } from "playwright-core";

const KERF = process.env["KERF"] ?? "";
export const SOURCE = process.env["KERF_SOURCE"] ?? "";
const folder = mkdtempSync(join(tmpdir(), "kerf-page-"));
export const MM = { length: "mm", time: "min" } as const;

let browser: Browser | null = null; // once a report is opened
const running = async (): Promise<Browser> =>
  (browser ??= await chromium.launch({
    executablePath: "/usr/bin/chromium",
    // The path is drawn by the processor where there is no graphics card.
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])],
  }));
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

export interface Opened {
  readonly page: Page;
  readonly said: string[]; // by the console: nothing is to be
  readonly size: number;
}

export function kerf(...words: string[]): { status: number; out: string } {
  try {
    return { status: 0, out: execFileSync(KERF, words, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 }) };
  } catch (error) {
    const failed = error as { status: number; stdout: string };
    return { status: failed.status, out: failed.stdout };
  }
}

// before: is run in the page before its own script.
async function openFile(file: string, fragment: string, before: () => void): Promise<Opened> {
  const context = await (await running()).newContext({ viewport: { width: 1280, height: 720 }, offline: true });
  const page = await context.newPage();
  const said: string[] = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (!request.url().startsWith("file:") && !request.url().startsWith("blob:")) said.push(`asked for ${request.url()}`);
  });
  await page.addInitScript(before);
  await page.goto(pathToFileURL(file).href + fragment);
  await page.waitForSelector("header", { timeout: 30_000 });
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return { page, said, size: statSync(file).size };
}

let count = 0;
export function makeReport(words: readonly string[]): string {
  const file = join(folder, `${++count}.html`);
  kerf("report", "-q", ...words, "-o", file);
  return file;
}

export const openReport = (words: readonly string[], fragment = "", before = (): void => undefined): Promise<Opened> => openFile(makeReport(words), fragment, before);

export function programFile(text: string | Buffer, name = `${++count}.ngc`): string {
  const file = join(folder, name);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
  return file;
}

export interface TraceRow {
  readonly t_s: number;
  readonly line: number;
  readonly v: number;
  readonly xyz: readonly number[];
  readonly limit: string;
}

export function traceOf(program: string): TraceRow[] {
  const file = join(folder, "trace.csv");
  kerf("dry-run", "-q", program, "--trace", file, "--explain-speed");
  return readFileSync(file, "utf8")
    .trim()
    .split("\n")
    .slice(1)
    .map((row) => {
      const words = row.split(",");
      return { t_s: Number(words[0]), line: Number(words[1]), v: Number(words[3]), xyz: words.slice(6, 9).map(Number), limit: words[words.length - 1]! };
    });
}

export const textOf = async (page: Page, name: string): Promise<string> => (await page.locator(`[data-test="${name}"]`).first().textContent()) ?? "";
export const shown = (text: string): string => text.replaceAll("\u2212", "-").replaceAll("\u2009", "");

// The page keeps its view in the address, a moment after the last change.
export async function fragmentOf(page: Page): Promise<string> {
  await page.waitForTimeout(400);
  return new URL(page.url()).hash;
}

// The scrubber is how a hand on the keyboard moves the instant.
export async function goTo(page: Page, tick: number): Promise<void> {
  await page.locator(".scrub").evaluate((input, value) => {
    (input as HTMLInputElement).value = String(value);
    input.dispatchEvent(new Event("input"));
  }, tick);
}

// What the editor marks as the present line, to which it goes at most ten times a second.
export async function markedLine(page: Page): Promise<string> {
  await page.waitForTimeout(200);
  return (await page.locator(".cm-now").first().textContent()) ?? "";
}

export const pocket = join(SOURCE, "programs", "pocket.ngc");
