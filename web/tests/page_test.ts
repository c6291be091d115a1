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
    args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])],
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

// Texts on the page that are less than 4.5 to 1 from their ground (WCAG 2, 1.4.3). Runs in the page.
function faintWords(): string[] {
  const numbers = (colour: string): number[] => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]: number[]): number => {
    const linear = [r!, g!, b!].map((part) => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * linear[0]! + 0.7152 * linear[1]! + 0.0722 * linear[2]!;
  };
  const roots: (Document | ShadowRoot)[] = [document, ...[...document.querySelectorAll("*")].flatMap((element) => (element.shadowRoot ? [element.shadowRoot] : []))];
  const faint: string[] = [];
  for (const element of roots.flatMap((root) => [...root.querySelectorAll<HTMLElement>("*")])) {
    const words = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE && node.textContent!.trim() !== "").map((node) => node.textContent!.trim());
    if (words.length === 0 || !element.checkVisibility() || /^(script|style|noscript|option)$/i.test(element.tagName)) continue;
    let opacity = 1;
    let ground: number[] | null = null;
    for (let at: Element | null = element; at; at = at.parentElement ?? (at.getRootNode() as ShadowRoot).host ?? null) {
      const style = getComputedStyle(at);
      opacity *= Number(style.opacity);
      const colour = numbers(style.backgroundColor);
      if (!ground && style.backgroundColor.startsWith("rgb") && (colour[3] ?? 1) > 0.5) ground = colour;
    }
    const style = getComputedStyle(element);
    const [above, below] = [light(numbers(style.color)), light(ground ?? [255, 255, 255])];
    const ratio = (Math.max(above, below) + 0.05) / (Math.min(above, below) + 0.05);
    if (ratio < 4.5 || opacity < 0.99) faint.push(`${words[0]}: ${ratio.toFixed(2)}, opacity ${opacity}`);
  }
  return faint;
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

const pocket = join(SOURCE, "programs", "pocket.ngc");

describe("the three views are one", () => {
  test("a line that is clicked moves the instant to where it begins", async () => {
    const { page, said } = await openReport([pocket]);
    const first = traceOf(pocket).findIndex((row) => row.line === 16);
    await page.locator(".cm-line", { hasText: "G1 X-11. Y0. F1200." }).click();
    assert.match(await textOf(page, "instant"), new RegExp(`tick ${first}, line 16$`));
    assert.equal(await markedLine(page), "G1 X-11. Y0. F1200.");
    assert.match(page.url(), new RegExp(`tick=${first}`));
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("a place on the path that is pointed at shows its line and instant, and goes again", async () => {
    const { page, said } = await openReport([pocket], "#tick=1000");
    const before = await textOf(page, "instant");
    const box = (await page.locator(".path-view").boundingBox())!;
    // Somewhere along this row the pointer crosses the path.
    let hit = "";
    for (let x = 0.3; x < 0.8 && hit === ""; x += 0.01) {
      await page.mouse.move(box.x + x * box.width, box.y + 0.5 * box.height);
      const tip = page.locator(".tip");
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
      if (await tip.isVisible()) hit = (await tip.textContent()) ?? "";
    }
    const line = /^line (\d+) /.exec(hit)![1]!;
    assert.match(await textOf(page, "instant"), new RegExp(`line ${line}$`));
    assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[Number(line) - 1]);
    const [, x] = /X (\S+)/.exec(shown(hit))!;
    const tick = Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]);
    assert.ok(Math.abs(Number(x) - traceOf(pocket)[tick]!.x) < 0.002, `${x} at tick ${tick}`);
    await page.mouse.move(box.x + 2, box.y + 2);
    await page.waitForFunction(() => document.querySelector<HTMLElement>(".tip")!.hidden);
    assert.equal(await textOf(page, "instant"), before);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("an instant that is clicked in the chart marks its line", async () => {
    const { page, said } = await openReport([pocket]);
    const over = (await page.locator(".u-over").first().boundingBox())!;
    await page.mouse.click(over.x + 0.4 * over.width, over.y + 10);
    const [, tick, line] = /tick (\d+), line (\d+)$/.exec(await textOf(page, "instant"))!;
    const trace = traceOf(pocket);
    assert.ok(Math.abs(Number(tick) / (trace.length - 1) - 0.4) < 0.003);
    assert.equal(trace[Number(tick)]!.line, Number(line));
    assert.equal(await markedLine(page), readFileSync(pocket, "utf8").split("\n")[Number(line) - 1]);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("the codes in force at the instant are those that explain names before the next line", async () => {
    const { page, said } = await openReport([pocket]);
    const trace = traceOf(pocket);
    for (const line of [7, 10, 16, 44]) {
      await goTo(page, trace.findIndex((row) => row.line === line) + 5);
      // What a block sets is in force before the next one.
      const block = JSON.parse(kerf("explain", pocket, "--line", String(line + 1), "--json").out).block as { codes: string[] };
      const shownCodes = (await textOf(page, "codes")).split(" ");
      for (const code of shownCodes) assert.ok(block.codes.includes(code), `${code} in ${block.codes.join(" ")}`);
      assert.ok(shownCodes.length >= 8);
    }
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("play goes on in time, and space stops it", async () => {
    const { page, said } = await openReport([pocket], "#tick=20000");
    await page.locator("body").press("Space");
    await page.waitForFunction(() => Number(document.querySelector<HTMLElement>(".instant")!.dataset["tick"]) > 20100);
    await page.locator("body").press("Space");
    const stopped = await textOf(page, "instant");
    await page.waitForTimeout(150);
    assert.equal(await textOf(page, "instant"), stopped);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("the chart zooms to what is dragged over, down to ticks, and back", async () => {
    const { page, said } = await openReport([pocket]);
    const over = (await page.locator(".u-over").first().boundingBox())!;
    await page.mouse.move(over.x + 0.3 * over.width, over.y + 10);
    await page.mouse.down();
    await page.mouse.move(over.x + 0.5 * over.width, over.y + 12, { steps: 4 });
    await page.waitForTimeout(100); // uPlot takes a move with the next frame
    await page.mouse.up();
    await page.mouse.move(over.x + 0.5 * over.width, over.y + 10);
    // The middle of what is seen is now at 0.4 of the whole.
    const tick = Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]);
    const all = traceOf(pocket).length - 1;
    assert.ok(Math.abs(tick / all - 0.4) < 0.003, `${tick} of ${all}`);
    await page.locator("button", { hasText: /^all$/ }).click();
    await page.mouse.move(over.x + 0.5 * over.width, over.y + 10);
    assert.ok(Math.abs(Number(/tick (\d+)/.exec(await textOf(page, "instant"))![1]) / all - 0.5) < 0.003);
    assert.deepEqual(said, []);
    await page.context().close();
  });
});

describe("the page", () => {
  test("shows a hostile program as text", async () => {
    const attack = "<img src=x onerror=document.title='owned'>";
    const text = `G21 G90 F3000\n(</script><script>document.title='owned'</script>)\n(MSG, ${attack})\n;${attack}\n(${attack})\nG1 X10\nM30\n`;
    const name = "<img src=x onerror=alert`3`>.ngc";
    const { page, said } = await openReport([programFile(text.replaceAll("()", ""), name)], `#view=<b>&tick=1e9&plan=7`);
    assert.equal(await page.locator("h1").textContent(), name);
    assert.equal(await page.title(), `${name} \u2013 Kerf`);
    assert.equal(await page.locator("img").count(), 0);
    assert.ok((await page.locator(".cm-content").textContent())!.includes("</script><script>document.title='owned'</script>"));
    await page.locator("[data-tab=answer]").click();
    assert.ok((await page.locator("[data-test=by-operation]").textContent())!.includes(attack));
    assert.ok((await page.locator("[data-test=told]").textContent())!.includes(attack));
    assert.equal(await page.locator("img").count(), 0);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("has no place for a script that is not its own", async () => {
    const { page } = await openReport([pocket]);
    const ran = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "document.title = 'owned'";
      document.body.append(script);
      return document.title;
    });
    assert.notEqual(ran, "owned");
    await page.context().close();
  });

  test("bears a line of ten million characters and a hundred errors", async () => {
    const { page, said } = await openReport([programFile(`G21 G90 F3000\n(${"x".repeat(10_000_000)})\n${"G1 Xq\n".repeat(2000)}M30\n`)]);
    assert.match(await textOf(page, "failed"), /error/);
    assert.ok((await page.locator(".cm-content").textContent())!.length < 2_000_000, "only what is seen is drawn");
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("shows an error at its line, with what to do", async () => {
    const program = programFile("G21 G90\nG1 X10 F-100\nM30\n");
    const { page, said } = await openReport([program]);
    const diagnostic = (await page.locator(".cm-diagnostic").first().textContent())!;
    assert.ok(diagnostic.includes("E0120"));
    const [{ remedy }] = JSON.parse(kerf("check", "--format", "json", program).out).diagnostics;
    assert.ok(diagnostic.includes(remedy));
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("says by how much a program does not fit, and how far the offset may move", async () => {
    const { page, said } = await openReport([programFile("G21 G90 F6000\nG1 X520\nG1 X-100\nM30\n")]);
    // The travel of X is -500 to 500.
    assert.equal(await textOf(page, "fit-verdict"), "does not fit");
    assert.ok(shown(await textOf(page, "extents")).includes("X -100.000 to 520.000, over by 20.000"));
    await page.locator("[data-tab=answer]").click();
    assert.ok(shown(await textOf(page, "offsets")).includes("-400.000 to -20.000"));
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("says between which values the work offset in force would fit", async () => {
    const text = "G21 G90 G55 F6000\nG1 X20\nG1 X-100\nM30\n";
    const machine = programFile(readFileSync(join(SOURCE, "programs/machines/table.toml"), "utf8") + "\n[offsets.g55]\nx_mm = 50\n", "offset.toml");
    const { page, said } = await openReport([programFile(text), "--machine", machine]);
    await page.locator("[data-tab=answer]").click();
    // The path is at X -50 to 70 with G55 at 50; the travel is -500 to 500, so G55 may be at -400 to 480.
    const offsets = shown(await textOf(page, "offsets"));
    assert.ok(offsets.includes("G55 between") && offsets.includes("-400.000 to 480.000"), offsets);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("tells tool changes, dwells and rapids apart", async () => {
    const machine = programFile('[program]\ntool_change_s = 3\n' + readFileSync(join(SOURCE, "programs/machines/table.toml"), "utf8").replace(/^\[program\]$/m, ""), "changer.toml");
    const text = "G21 G90 F6000\nT1 M6\n(rough)\nG1 X10\nG4 P2\nT2 M6\n(finish)\nG1 X20\nG0 X0\nM30\n";
    const { page, said } = await openReport([programFile(text), "--machine", machine]);
    const seconds = async (name: string): Promise<number> => parseFloat(await textOf(page, name));
    assert.ok(Math.abs((await seconds("time-toolChange")) - 6) < 0.02, await textOf(page, "time-toolChange"));
    assert.ok(Math.abs((await seconds("time-rest")) - 2) < 0.02, await textOf(page, "time-rest"));
    await page.locator("[data-tab=answer]").click();
    const tools = (await page.locator("[data-test=by-tool] tbody tr td:first-child").allTextContents()).filter((name) => name !== "no tool");
    assert.deepEqual(tools, ["T1", "T2"]);
    assert.deepEqual(await page.locator("[data-test=by-operation] tbody tr td:first-child").allTextContents(), ["before the first heading", "rough", "finish"]);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("says that the text was left out, and works without it", async () => {
    const { page, said } = await openReport(["--no-source", pocket]);
    await goTo(page, 30_000);
    assert.match((await page.locator(".program-view .empty").textContent())!, /not in this report. The tool is in line 44\./);
    assert.doesNotMatch((await page.locator(".what").textContent())!, /text/);
    assert.deepEqual(said, []);
    await page.context().close();
  });

  test("shows inches, feeds per second and the dark theme, and keeps them in the address", async () => {
    const { page, said } = await openReport([pocket]);
    await page.locator("button", { hasText: /^inch$/ }).click();
    await page.locator("button", { hasText: /^\/s$/ }).click();
    await page.locator("select[aria-label=Theme]").selectOption("dark");
    await page.locator("[data-test=colour]").selectOption("limit");
    // 27 mm are 1.0630 in.
    assert.ok(shown(await textOf(page, "extents")).includes("X -1.0630 to 1.0630"));
    assert.match((await page.locator(".chart-name").first().textContent())!, /in\/s/);
    const fragment = new URL(page.url()).hash;
    const again = await openReport([pocket], fragment);
    assert.equal(await again.page.evaluate(() => document.documentElement.dataset["theme"]), "dark");
    assert.match((await again.page.locator(".legend-title").textContent())!, /limits the feed/);
    assert.ok(shown(await textOf(again.page, "extents")).includes("1.0630"));
    assert.deepEqual([...said, ...again.said], []);
    await page.context().close();
    await again.page.context().close();
  });

  test("sets two machines side by side", async () => {
    const machines = ["table", "sigmoid-wm"].map((name) => join(SOURCE, `programs/machines/${name}.toml`));
    const wm = join(SOURCE, "programs", "wm.ngc");
    const { page, said } = await openReport([wm, "--machine", machines[0]!, "--machine", machines[1]!]);
    const times = machines.map((machine) => clock(JSON.parse(kerf("dry-run", "--json", wm, "--machine", machine).out).cycle_time_s));
    const select = page.locator("select[aria-label=Program]");
    assert.deepEqual(await select.locator("option").allTextContents(), [`wm.ngc, table.toml: ${times[0]}`, `wm.ngc, sigmoid-wm.toml: ${times[1]}`]);
    assert.equal(await textOf(page, "cycle-time"), times[0]);
    await select.selectOption("1");
    assert.equal(await textOf(page, "cycle-time"), times[1]);
    await page.locator("[data-tab=answer]").click();
    const seconds = machines.map((machine) => JSON.parse(kerf("dry-run", "--json", wm, "--machine", machine).out).cycle_time_s as number);
    const difference = shown(await page.locator("[data-test=side-by-side] tbody tr:nth-child(2) td:last-child").textContent() ?? "");
    assert.equal(parseFloat(difference).toFixed(3), (seconds[1]! - seconds[0]!).toFixed(3));
    await page.locator("[data-test=side-by-side] button").first().click();
    assert.equal(await textOf(page, "cycle-time"), times[0]);
    assert.equal(await select.inputValue(), "0");
    assert.deepEqual(said, []);
    await page.context().close();
  });

  for (const theme of ["light", "dark"]) {
    test(`is legible in the ${theme} theme: 4.5 to 1`, async () => {
      const { page } = await openReport([pocket], `#theme=${theme}&colour=limit`);
      const found: string[] = [];
      for (const tab of ["program", "answer"]) {
        await page.locator(`[data-tab=${tab}]`).click();
        found.push(...(await page.evaluate(faintWords)));
      }
      assert.deepEqual(found, []);
      await page.context().close();
    });
  }

  test("names the licences of what it is made of", async () => {
    const { page } = await openReport([pocket]);
    await page.locator("button", { hasText: "About" }).click();
    const about = (await page.locator("dialog").textContent())!;
    for (const name of ["three", "uplot", "@codemirror/view", "MIT"]) assert.ok(about.includes(name), name);
    assert.match(about, /Permission is hereby granted/);
    await page.context().close();
  });

  test("is small for a butterfly", async () => {
    const { page, size } = await openReport([join(SOURCE, "programs", "butterfly.ngc")]);
    assert.ok(size <= 2_000_000, `${size} bytes`);
    await page.context().close();
  });
});

describe("a program of many lines", () => {
  test("keeps every peak, and draws at most 300,000 vertices", async () => {
    const lines = ["G21 G90 G64 P0.01 F6000"];
    for (let i = 0; i < 60_000; ++i) lines.push(`G1 X${(100 * Math.cos(i / 50) + i / 1000).toFixed(3)} Y${(80 * Math.sin(i / 37)).toFixed(3)}`);
    const program = programFile([...lines, "M30", ""].join("\n"));
    const json = JSON.parse(kerf("dry-run", "--json", program).out);
    assert.ok(json.ticks > 200_000, "more ticks than a report has columns");
    const { page, said } = await openReport([program]);
    assert.equal(await textOf(page, "cycle-time"), clock(json.cycle_time_s));
    assert.match((await page.locator(".note").textContent())!, /finest level of this report is \d+ ticks/);
    for (const colour of ["feed", "limit", "jerk"]) {
      await page.locator("[data-test=colour]").selectOption(colour);
      for (const side of ["top", "iso"]) {
        await page.locator(`[data-side=${side}]`).click();
        await page.waitForTimeout(50);
        const vertices = Number(await page.locator(".path-view canvas").first().getAttribute("data-vertices"));
        assert.ok(vertices > 10_000 && vertices <= 300_000, `${vertices} vertices`);
      }
    }
    assert.deepEqual(said, []);
    await page.context().close();
  });
});
