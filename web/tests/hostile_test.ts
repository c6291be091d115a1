// Programs that mean harm, or are out of all measure.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openReport, pocket, programFile, textOf } from "./report.ts";

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

test("its policy lets in its own script and style, and nothing else", async () => {
  const { page } = await openReport([pocket]);
  const policy = (await page.locator("meta[http-equiv=Content-Security-Policy]").getAttribute("content")) ?? "";
  const hash = "'sha256-[A-Za-z0-9+/]{43}='";
  assert.match(policy, new RegExp(`^default-src 'none'; script-src ${hash}; style-src ${hash}; base-uri 'none'; form-action 'none'$`));
  await page.context().close();
});

test("bears a line of ten million characters and a million errors", async () => {
  const { page, said } = await openReport([programFile(`G21 G90 F3000\n(${"x".repeat(10_000_000)})\n${"G1 Xq\n".repeat(1_000_000)}M30\n`)]);
  assert.match(await textOf(page, "failed"), /error/);
  assert.ok((await page.locator(".cm-content").textContent())!.length < 2_000_000, "only what is seen is drawn");
  assert.deepEqual(said, []);
  await page.context().close();
});
