// Builds the page without data: one HTML file with its script and style in it, which may load nothing.
//   node build.mjs                      writes ../build/web/page.html
//   node build.mjs playground KERNEL    writes dist/index.html, with the kernel in it; KERNEL: the folder of kernel.mjs
//   node build.mjs tests                writes node_modules/.tests
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const output = join(here, "..", "build", "web");

// The libraries that a bundle has in it: src/ui/about.ts shows their licences.
function npmLicences(inputs) {
  const packages = JSON.parse(readFileSync(join(here, "package-lock.json"), "utf8")).packages;
  const bundled = Object.entries(packages).filter(([path]) => path !== "" && inputs.some((input) => input.startsWith(`${path}/`)));
  return bundled.map(([path, entry]) => {
    const name = path.replace("node_modules/", "");
    const text = readFileSync(join(here, "LICENSES", `${name.replace("/", "-").replace("@", "")}.txt`), "utf8");
    return { name, version: entry.version, licence: entry.license, text };
  });
}

// The same of what the kernel in the browser is made of: Debian's packages say it themselves.
const KERNEL_PACKAGES = [
  ["Boost", "libboost-dev", "BSL-1.0"],
  ["Eigen", "libeigen3-dev", "MPL-2.0"],
  ["expected", "libexpected-dev", "CC0-1.0"],
  ["fast_float", "libfast-float-dev", "MIT"],
  ["fmt", "libfmt-dev", "MIT"],
  ["JSON for Modern C++", "nlohmann-json3-dev", "MIT"],
  ["spdlog", "libspdlog-dev", "MIT"],
  ["toml++", "libtomlplusplus-dev", "MIT"],
  ["Emscripten, with musl and libc++", "emscripten", "MIT, Apache-2.0 with LLVM exceptions"],
];

function kernelLicences() {
  return KERNEL_PACKAGES.map(([name, debian, licence]) => {
    const version = execFileSync("dpkg-query", ["-W", "-f=${Version}", debian], { encoding: "utf8" });
    return { name, version, licence, text: readFileSync(`/usr/share/doc/${debian}/copyright`, "utf8") };
  });
}

const shared = {
  absWorkingDir: here,
  bundle: true,
  format: "esm",
  logLevel: "warning",
  loader: { ".html": "text" },
};

async function bundled(entry, options = {}) {
  const result = await build({
    ...shared,
    ...options,
    entryPoints: [entry],
    format: "iife",
    target: ["chrome100", "firefox113", "safari16.4"],
    minify: true,
    legalComments: "none",
    metafile: true,
    write: false,
  });
  return { text: result.outputFiles[0].text.trim(), inputs: Object.keys(result.metafile.inputs) };
}

const hash = (text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;

// kernel: none in a report.
async function pageOf(entry, { define = {}, kernel = null }) {
  const { text: style } = await bundled("src/style.css");
  const { inputs } = await bundled(entry, { define: { ...define, KERF_LICENCES: "[]" } });
  const licences = [...npmLicences(inputs), ...(kernel ? kernelLicences() : [])];
  const { text } = await bundled(entry, { define: { ...define, KERF_LICENCES: JSON.stringify(licences) } });
  const script = text.replaceAll("</script", "<\\/script"); // an end tag within the script would end it
  const compiles = kernel ? " 'wasm-unsafe-eval'" : "";
  const works = kernel ? "; worker-src blob:" : "";
  const policy = `default-src 'none'; script-src ${hash(script)}${compiles}${works}; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`;
  const data = kernel ? `<script type="application/x-kerf-kernel">${deflateSync(kernel, { level: 9 }).toString("base64")}</script>\n` : "";
  return readFileSync(join(here, "src", "page.html"), "utf8")
    .replace("KERF_POLICY", () => policy)
    .replace("KERF_STYLE", () => style)
    .replace("<script>KERF_SCRIPT", () => `${data}<script>${script}`);
}

function write(folder, name, page) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, name), page);
  console.log(`${name}: ${(page.length / 1e6).toFixed(2)} MB`);
}

async function buildPage() {
  write(output, "page.html", await pageOf("src/main.ts", {}));
}

async function buildPlayground(folder) {
  const texts = (place, names) => names.map((name) => ({ name, text: readFileSync(join(here, "..", place, name), "utf8") }));
  const { text: worker } = await bundled("src/plan/worker.ts", {
    alias: { "kerf-kernel": join(folder, "kernel.mjs") },
    define: { "import.meta.url": '""' }, // where a kernel would be loaded from
  });
  const define = {
    KERF_WORKER: JSON.stringify(worker),
    KERF_EXAMPLES: JSON.stringify(texts("programs", ["pocket.ngc", "butterfly.ngc", "star.ngc", "scroll.ngc", "raster.ngc"])),
    KERF_MACHINES: JSON.stringify(texts("programs/machines", ["table.toml", "sigmoid-butterfly.toml", "quintic.toml"])),
  };
  write(join(here, "dist"), "index.html", await pageOf("src/playground.ts", { define, kernel: readFileSync(join(folder, "kernel.wasm")) }));
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
    define: { KERF_LICENCES: "[]" },
  });
}

const [what = "page", folder] = process.argv.slice(2);
await { page: buildPage, playground: () => buildPlayground(folder), tests: buildTests }[what]();
