// Opens the playground as its visitors meet it: from disk in Chromium without a network, beside what kerf itself says.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium, type Browser, type Page } from "playwright-core";
import { timesOfLines as timesBeside } from "./lines.ts";

const KERF = process.env["KERF"] ?? "";
export const SOURCE = process.env["KERF_SOURCE"] ?? "";
export const folder = mkdtempSync(join(tmpdir(), "kerf-playground-"));
export const dist = join(SOURCE, "web", "dist", "index.html");

let browser: Browser;
export let page: Page; // the one that all tests of a file share
export const said: string[] = []; // by its console: nothing is to be

export async function newPage(): Promise<Page> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, offline: true });
  return context.newPage();
}

before(async () => {
  browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])],
  });
  page = await newPage();
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (!/^(file|blob):/.test(request.url())) said.push(`asked for ${request.url()}`);
  });
  await page.goto(pathToFileURL(dist).href);
  await planned();
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

export const timesOfLines = (): Promise<string[]> => timesBeside(page);
export const status = async (): Promise<string> => (await page.locator('[data-test="status"]').textContent()) ?? "";

export async function planned(): Promise<void> {
  await page.waitForFunction(() => /^planned|^not planned/.test(document.querySelector('[data-test="status"]')?.textContent ?? ""), null, { timeout: 120_000 });
}

// What is done begins another plan; waits until it is there.
export async function after_(doing: () => Promise<unknown>): Promise<void> {
  await page.evaluate(() => (document.querySelector('[data-test="status"]')!.textContent = ""));
  await doing();
  await planned();
}

export const open = (label: string, ...files: string[]): Promise<void> => after_(() => page.locator(`input[aria-label^="${label}"]`).setInputFiles(files));
export const program = (text: string, name: string): string => {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
};

export async function choose(label: "Example program" | "Example machine", name: string): Promise<void> {
  const menu = page.locator("details", { has: page.locator(`summary[aria-label="${label}"]`) });
  await menu.locator("summary").click();
  await menu.locator("button", { hasText: name }).click();
}

export const shownTime = async (): Promise<string> => (await page.locator('[data-test="cycle-time"]').textContent()) ?? "";

export function timeOf(...words: string[]): number {
  return (JSON.parse(execFileSync(KERF, ["dry-run", "--json", ...words], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] })) as { cycle_time_s: number }).cycle_time_s;
}

export const secondsOf = (text: string): number => text.replace(/ s$/, "").split(":").reduce((sum, part) => 60 * sum + Number(part), 0);

// Whose path is shown long before its times.
export const slowProgram = (name: string): string => {
  const lines = Array.from({ length: 5000 }, (_, i) => `G1 X${(80 * Math.sin(i * i)).toFixed(3)} Y${(60 * Math.cos(3 * i * i)).toFixed(3)}`);
  return program(["G21 G90 G61 F6000", ...lines, "M2", ""].join("\n"), name);
};

export const written = (): Promise<string> => page.locator(".program-view .cm-line").first().textContent().then((text) => text ?? "");

// The caret into the program, to where the keys take it.
export async function caretTo(...keys: string[]): Promise<void> {
  await page.locator("[data-tab=program]").click();
  await page.locator(".program-view .cm-content").focus();
  for (const key of keys) await page.keyboard.press(key);
}

// The editor shows a key a moment later; then it is to stay.
export async function keyIsThere(expected: string): Promise<void> {
  for (let i = 0; i < 40 && (await written()) !== expected; ++i) await page.waitForTimeout(25);
  assert.equal(await written(), expected);
}

export const compare = async (): Promise<void> => {
  await page.locator("[data-tab=difference]").click();
  await after_(() => page.locator("button", { hasText: "compare with this run" }).click());
};
