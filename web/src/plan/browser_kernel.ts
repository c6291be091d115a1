// Plans computed in the browser: the kernel as WebAssembly, in a worker of its own.
import { decodePlan, isPlan } from "./decode.ts";
import { Plan } from "./plan.ts";
import type { Part, Progress } from "./source.ts";

export interface TextFile {
  readonly name: string;
  readonly text: string;
}

export interface Order {
  readonly files: readonly [TextFile, ...TextFile[]]; // the program, then its subprograms
  readonly machine: readonly [TextFile, ...TextFile[]]; // its file, then those that it names; an empty text: the default machine
  readonly profile: string;
  readonly feed_override: number; // share of the programmed feedrates
  readonly part?: Part; // of its ticks, with nothing before it; else all of it
}

// refused: what is wrong with the machine file, or within kerf.
export type Answer = { readonly plan: Plan; readonly took_s: number } | { readonly refused: readonly string[] };

// What is planned since the last time: line, ticks, line, ticks, ...; the line that is run now; all ticks and the path's length so far.
// left_s < 0: not known.
export interface Told {
  readonly lines: Uint32Array<ArrayBuffer>;
  readonly line: number;
  readonly ticks: number;
  readonly path_mm: number;
  readonly left_s: number;
}

// What the worker answers. isPathAlone: the rest follows.
export type Reply = Told | { readonly bytes: Uint8Array<ArrayBuffer>; readonly isPathAlone: boolean } | { readonly failure: string };

// Who waits for a plan that takes a while: is shown how far it is, and its path once that is known.
export interface Waiting {
  showPath(plan: Plan): void;
  showProgress(progress: Progress): void;
}

// A plan that is there by then comes without its path before it.
const PATIENCE_MS = 500;

function answerOf(bytes: Uint8Array, order: Order, took_s: number): Answer {
  if (isPlan(bytes)) return { plan: new Plan(decodePlan(bytes), order.files[0].text), took_s };
  return JSON.parse(new TextDecoder().decode(bytes)) as { refused: string[] };
}

// All that was told of one plan.
class SoFar {
  private readonly lines = new Map<number, number>();

  with({ lines, line, ticks, path_mm, left_s }: Told): Progress {
    for (let i = 0; i < lines.length; i += 2) this.lines.set(lines[i]!, (this.lines.get(lines[i]!) ?? 0) + lines[i + 1]!);
    return { ticks, path_mm, left_s: left_s < 0 ? null : left_s, line, lines: this.lines };
  }
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

  // The order that is being worked on, if there is one, gets no answer.
  stop(): void {
    if (!this.abandon) return;
    this.abandon();
    this.worker?.terminate();
    this.worker = null;
  }

  // null: a newer order has taken its place, or it was stopped.
  plan(order: Order, waits: Waiting): Promise<Answer | null> {
    this.stop();
    const worker = (this.worker ??= this.start());
    const began_ms = performance.now();
    return new Promise((resolve) => {
      let waiting: ReturnType<typeof setTimeout> | undefined;
      const soFar = new SoFar();
      const passed_ms = (): number => performance.now() - began_ms;
      const end = (answer: Answer | null): void => {
        clearTimeout(waiting);
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
        if ("failure" in data) {
          fail(data.failure);
        } else if ("lines" in data) {
          waits.showProgress(soFar.with(data));
        } else if (data.isPathAlone) {
          waiting = setTimeout(() => {
            const answer = answerOf(data.bytes, order, 0);
            if ("plan" in answer) waits.showPath(answer.plan);
          }, PATIENCE_MS - passed_ms());
        } else {
          end(answerOf(data.bytes, order, passed_ms() / 1000));
        }
      };
      worker.onerror = (event) => fail(event.message);
      worker.postMessage(order);
    });
  }

  private start(): Worker {
    const worker = new Worker(this.script);
    worker.postMessage(this.module);
    return worker;
  }
}
