// Plans computed in the browser: the kernel as WebAssembly, in a worker of its own.
import { decodePlan } from "./decode.ts";
import { Plan } from "./plan.ts";

export interface TextFile {
  readonly name: string;
  readonly text: string;
}

// What would be otherwise: shares of the machine's limits and of feedrates, and P and Q in place of those of each G64, as G64
// reads them: without Q it is P, without P all stays.
export interface WhatIf {
  readonly velocity: number;
  readonly acceleration: number;
  readonly jerk: number;
  readonly feed: number;
  readonly rapid: number;
  readonly corner_tolerance_mm: number | null;
  readonly merge_tolerance_mm: number | null;
}

export const AS_IT_IS: WhatIf = { velocity: 1, acceleration: 1, jerk: 1, feed: 1, rapid: 1, corner_tolerance_mm: null, merge_tolerance_mm: null };

export interface Order {
  readonly files: readonly [TextFile, ...TextFile[]]; // the program, then its subprograms
  readonly machine: TextFile; // an empty text: the default machine
  readonly profile: string;
  readonly whatIf: WhatIf;
}

// The text without P and Q of G64, so that the machine's tolerances hold; every other character keeps its place.
export function withoutTolerances(text: string): string {
  const words = /(\([^)\n]*\)|;.*)|(G64(?![\d.]))((?:\s*[PQ]\s*(?:[-+.\d]+|\[[^\]\n]*\]|#\d+|#<[^>\n]*>))+)/gi;
  return text.replace(words, (all, comment?: string, code?: string) => (comment === undefined ? code!.padEnd(all.length) : all));
}

// As web/kernel reads it.
function toldOrder({ files, machine, profile, whatIf }: Order): object {
  const told = whatIf.corner_tolerance_mm !== null ? files.map(({ name, text }) => ({ name, text: withoutTolerances(text) })) : files;
  return { files: told, machine, profile, what_if: whatIf };
}

// refused: what is wrong with the machine file, or within kerf.
export type Answer = { readonly plan: Plan; readonly took_s: number } | { readonly refused: readonly string[] };

// What the worker answers.
export type Reply = { readonly bytes: Uint8Array<ArrayBuffer> } | { readonly failure: string };

const MAGIC = "KERFPLAN";

function answerOf(bytes: Uint8Array, order: Order, took_s: number): Answer {
  if (new TextDecoder().decode(bytes.subarray(0, MAGIC.length)) === MAGIC) return { plan: new Plan(decodePlan(bytes), order.files[0].text), took_s };
  return JSON.parse(new TextDecoder().decode(bytes)) as { refused: string[] };
}

export class BrowserKernel {
  private readonly script: string; // the worker's, as a URL
  private readonly module: WebAssembly.Module;
  private worker: Worker | null = null;
  private abandon: (() => void) | null = null; // of the order that is being worked on

  constructor(script: string, module: WebAssembly.Module) {
    this.script = script;
    this.module = module;
  }

  // null: a newer order has taken its place.
  plan(order: Order): Promise<Answer | null> {
    if (this.abandon) {
      this.abandon();
      this.worker?.terminate();
      this.worker = null;
    }
    const worker = (this.worker ??= this.start());
    const began_ms = performance.now();
    return new Promise((resolve) => {
      const end = (answer: Answer | null): void => {
        this.abandon = null;
        resolve(answer);
      };
      this.abandon = () => end(null);
      const fail = (why: string): void => {
        worker.terminate();
        this.worker = null;
        end({ refused: [`The kernel has failed: ${why}`] });
      };
      worker.onmessage = ({ data }: MessageEvent<Reply>) => {
        if ("failure" in data) fail(data.failure);
        else end(answerOf(data.bytes, order, (performance.now() - began_ms) / 1000));
      };
      worker.onerror = (event) => fail(event.message);
      worker.postMessage(toldOrder(order));
    });
  }

  private start(): Worker {
    const worker = new Worker(this.script);
    worker.postMessage(this.module);
    return worker;
  }
}
