// Takes the pictures of docs/ anew: look at them before they are committed.
//   node web/pictures.mjs      after ./test web and scripts/build_playground, which install and make what this needs
import { execFileSync } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const folder = mkdtempSync(join(tmpdir(), "kerf-pictures-"));
const PICTURES = [
  { name: "report", program: "butterfly", fragment: "colour=limit&tick=2500" },
  { name: "report-dark", program: "pocket", fragment: "theme=dark&tick=30000&track=x", tab: "answer" },
];

const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])],
});
for (const { name, program, fragment, tab } of PICTURES) {
  const file = join(folder, `${name}.html`);
  execFileSync(join(root, "kerf"), ["report", "-q", join(root, "programs", `${program}.ngc`), "-o", file]);
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  await page.goto(`${pathToFileURL(file).href}#${fragment}`);
  await page.waitForSelector("header");
  if (tab) await page.locator(`[data-tab=${tab}]`).click();
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(root, "docs", `${name}.png`) });
  await page.close();
}
const playground = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await playground.goto(`${pathToFileURL(join(root, "web", "dist", "index.html")).href}#colour=limit&tick=20000`);
await playground.waitForSelector("header", { timeout: 60_000 });
await playground.locator("[data-tab=machine]").click();
await playground.waitForTimeout(1000);
await playground.screenshot({ path: join(root, "docs", "playground.png") });
await browser.close();
