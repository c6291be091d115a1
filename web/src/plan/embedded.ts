// Plans that kerf has put into the page: base64 of zlib.
import { decodePlan } from "./decode.ts";
import { Plan } from "./plan.ts";
import type { PlanSource, Shown } from "./source.ts";

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// What base64 of a zlib stream stands for. The bytes go straight into the stream: a blob or a response between would send
// them to another process and back.
export async function inflatedText(base64: string): Promise<Uint8Array<ArrayBuffer>> {
  const { readable, writable } = new DecompressionStream("deflate");
  const writer = writable.getWriter();
  const written = Promise.all([writer.write(bytesOf(base64)), writer.close()]);
  const parts: Uint8Array[] = [];
  let size = 0;
  const reader = readable.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    size += part.value.length;
  }
  await written;
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

// The plans stand after the script, which begins while the browser still reads them.
async function allRead(document: Document): Promise<void> {
  if (document.readyState !== "loading") return;
  await new Promise((resolve) => document.addEventListener("DOMContentLoaded", resolve, { once: true }));
}

export class EmbeddedSource implements PlanSource {
  private readonly document: Document;

  constructor(document: Document) {
    this.document = document;
  }

  async open(show: (shown: Shown) => void): Promise<void> {
    await allRead(this.document);
    const plans: Plan[] = [];
    for (const element of this.document.querySelectorAll('script[type="application/x-kerf-plan"]')) {
      plans.push(new Plan(decodePlan(await inflatedText(element.textContent ?? ""))));
      element.remove(); // its text is large
    }
    const [first, ...others] = plans;
    if (!first) throw new Error("there is no plan in this page");
    const runs = plans.findIndex((plan) => plan.cycle_s !== undefined);
    show({ plans: [first, ...others], base: Math.max(0, runs) });
  }
}
