import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";

interface Audit {
  readonly metadata?: { readonly vulnerabilities: { readonly total: number } };
  readonly vulnerabilities?: Readonly<Record<string, unknown>>;
}

test("nothing that is shipped has a known vulnerability, where the registry answers", (context) => {
  const words = ["audit", "--omit=dev", "--json", "--fetch-retries=0", "--fetch-timeout=15000"];
  const { stdout } = spawnSync("npm", words, { cwd: join(process.env["KERF_SOURCE"] ?? "", "web"), encoding: "utf8", timeout: 60_000 });
  let audit: Audit = {};
  try {
    audit = JSON.parse(stdout) as Audit;
  } catch {
    // no answer at all
  }
  if (!audit.metadata) {
    context.skip("the registry does not answer");
    return;
  }
  assert.equal(audit.metadata.vulnerabilities.total, 0, Object.keys(audit.vulnerabilities ?? {}).join(", "));
});
