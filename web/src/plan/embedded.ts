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

// What base64 of a zlib stream stands for.
export async function inflatedText(base64: string): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class EmbeddedSource implements PlanSource {
  private readonly document: Document;

  constructor(document: Document) {
    this.document = document;
  }

  async open(show: (shown: Shown) => void): Promise<void> {
    const plans: Plan[] = [];
    for (const element of this.document.querySelectorAll('script[type="application/x-kerf-plan"]')) {
      plans.push(new Plan(decodePlan(await inflatedText(element.textContent ?? ""))));
      element.remove(); // its text is large
    }
    const [first, ...others] = plans;
    if (!first) throw new Error("there is no plan in this page");
    const runs = plans.findIndex((plan) => plan.motion !== null);
    show({ plans: [first, ...others], base: Math.max(0, runs) });
  }
}
