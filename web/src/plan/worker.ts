// The worker that plans: first comes the module, then orders one by one.
import makeKernel, { type Kernel } from "kerf-kernel";
import type { Order, Reply } from "./browser_kernel.ts";

const SHORT = 10_000; // characters of a program that is planned at once

let kernel: Promise<Kernel> | null = null;

function instantiated(module: WebAssembly.Module): Promise<Kernel> {
  return makeKernel({
    locateFile: (name) => name, // nothing is loaded
    told(lines, ticks, left_s) {
      self.postMessage({ lines, ticks, left_s } satisfies Reply, { transfer: [lines.buffer] });
    },
    instantiateWasm(imports, done) {
      void WebAssembly.instantiate(module, imports).then(done);
      return {};
    },
  });
}

function planned(running: Kernel, order: object): Uint8Array<ArrayBuffer> {
  const bytes = new TextEncoder().encode(JSON.stringify(order));
  const at = running._malloc(bytes.length);
  running.HEAPU8.set(bytes, at);
  const answer = running._kerf_plan(at, bytes.length);
  running._free(at);
  return running.HEAPU8.slice(answer, answer + running._kerf_plan_bytes());
}

async function answer(order: Order, isPathAlone: boolean): Promise<void> {
  if (isPathAlone && order.files[0].text.length < SHORT) return;
  const reply: Reply = await kernel!
    .then((running) => ({ bytes: planned(running, { ...order, path_alone: isPathAlone }), isPathAlone }))
    .catch((error: unknown) => ({ failure: String(error) }));
  self.postMessage(reply, "bytes" in reply ? { transfer: [reply.bytes.buffer] } : {});
}

self.onmessage = async ({ data }: MessageEvent<WebAssembly.Module | object>) => {
  if (data instanceof WebAssembly.Module) {
    kernel = instantiated(data);
    return;
  }
  await answer(data as Order, true);
  await answer(data as Order, false);
};
