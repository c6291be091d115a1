// Plans that kerf has put into the page: base64 of zlib.
import { decodePlan } from "./decode.ts";
import { Plan } from "./plan.ts";
import type { PlanSource } from "./source.ts";

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class EmbeddedSource implements PlanSource {
  private readonly document: Document;

  constructor(document: Document) {
    this.document = document;
  }

  async plans(): Promise<Plan[]> {
    const plans: Plan[] = [];
    for (const element of this.document.querySelectorAll('script[type="application/x-kerf-plan"]')) {
      plans.push(new Plan(decodePlan(await inflated(bytesOf(element.textContent ?? "")))));
      element.remove(); // its text is large
    }
    return plans;
  }
}
