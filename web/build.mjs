// Builds the page without data: one HTML file with its script and style in it, which may load nothing.
//   node build.mjs            writes ../build/web/page.html
//   node build.mjs tests      writes node_modules/.tests
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = join(here, "..", "build", "web");

// The name of the licence that each bundled package has, and its text: src/ui/about.ts shows them.
function licences() {
  const packages = JSON.parse(readFileSync(join(here, "package-lock.json"), "utf8")).packages;
  const bundled = Object.entries(packages).filter(([path, entry]) => path !== "" && !entry.dev && !entry.optional);
  return bundled.map(([path, entry]) => {
    const name = path.replace("node_modules/", "");
    const text = readFileSync(join(here, "LICENSES", `${name.replace("/", "-").replace("@", "")}.txt`), "utf8");
    return { name, version: entry.version, licence: entry.license, text };
  });
}

const shared = {
  absWorkingDir: here,
  bundle: true,
  format: "esm",
  logLevel: "warning",
  loader: { ".html": "text" },
  define: { KERF_LICENCES: JSON.stringify(licences()) },
};

async function bundled(entry) {
  const result = await build({
    ...shared,
    entryPoints: [entry],
    format: "iife",
    target: ["chrome100", "firefox113", "safari16.4"],
    minify: true,
    legalComments: "none",
    write: false,
  });
  return result.outputFiles[0].text;
}

const hash = (text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;

async function buildPage() {
  const style = (await bundled("src/style.css")).trim();
  // An end tag within the script would end it.
  const script = (await bundled("src/main.ts")).trim().replaceAll("</script", "<\\/script");
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`;
  const page = readFileSync(join(here, "src", "page.html"), "utf8")
    .replace("KERF_POLICY", () => policy)
    .replace("KERF_STYLE", () => style)
    .replace("KERF_SCRIPT", () => script);
  writeFileSync(join(output, "page.html"), page);
  console.log(`page.html: ${(page.length / 1e6).toFixed(2)} MB`);
}

async function buildTests() {
  const tests = readdirSync(join(here, "tests")).filter((name) => name.endsWith("_test.ts"));
  await build({
    ...shared,
    entryPoints: tests.map((name) => join("tests", name)),
    outdir: join("node_modules", ".tests"),  // from where they find playwright-core
    outExtension: { ".js": ".mjs" },
    platform: "node",
    target: "node18",
    packages: "external",
  });
}

mkdirSync(output, { recursive: true });
await (process.argv[2] === "tests" ? buildTests() : buildPage());
