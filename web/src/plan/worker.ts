// The worker that plans: first comes the module, then orders one by one.
import makeKernel, { type Kernel } from "kerf-kernel";
import type { Order, Reply } from "./browser_kernel.ts";

let kernel: Promise<Kernel> | null = null;

// The kernel's loader does not hear of a module that cannot be instantiated.
function instantiated(module: WebAssembly.Module): Promise<Kernel> {
  return new Promise((resolve, reject) => {
    const running = makeKernel({
      locateFile: (name) => name, // nothing is loaded
      toldPath: (document) => reply(document, true),
      told(told) {
        self.postMessage(told satisfies Reply, { transfer: [told.lines.buffer] });
      },
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(module, imports).then(done).catch(reject);
        return {};
      },
    });
    running.then(resolve, reject);
  });
}

function planned(running: Kernel, order: Order): Uint8Array<ArrayBuffer> {
  const bytes = new TextEncoder().encode(JSON.stringify(order));
  const at = running._malloc(bytes.length);
  running.HEAPU8.set(bytes, at);
  const answer = running._kerf_plan(at, bytes.length);
  running._free(at);
  return running.HEAPU8.slice(answer, answer + running._kerf_plan_bytes());
}

function reply(bytes: Uint8Array<ArrayBuffer>, isPathAlone: boolean): void {
  self.postMessage({ bytes, isPathAlone } satisfies Reply, { transfer: [bytes.buffer] });
}

self.onmessage = async ({ data }: MessageEvent<WebAssembly.Module | Order>) => {
  if (data instanceof WebAssembly.Module) {
    kernel = instantiated(data);
    kernel.catch(() => undefined); // told to whom orders a plan
    return;
  }
  try {
    reply(planned(await kernel!, data), false);
  } catch (error) {
    self.postMessage({ failure: String(error) } satisfies Reply);
  }
};
