// What emscripten makes of web/kernel.
declare module "kerf-kernel" {
  import type { Told } from "./browser_kernel.ts";
  export interface Kernel {
    readonly HEAPU8: Uint8Array<ArrayBuffer>; // anew after memory has grown
    _malloc(bytes: number): number;
    _free(at: number): void;
    _kerf_plan(order: number, bytes: number): number;
    _kerf_plan_bytes(): number;
  }
  interface Options {
    locateFile(name: string): string;
    toldPath(document: Uint8Array<ArrayBuffer>): void; // before it plans
    told(told: Told): void; // while it plans
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void): object;
  }
  export default function makeKernel(options: Options): Promise<Kernel>;
}
