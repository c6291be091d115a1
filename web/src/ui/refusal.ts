// Why what was chosen or written is not what is shown.
import { h } from "./dom.ts";

export class Refusal {
  readonly element = h("div", { class: "refusal", role: "alert", hidden: true });
  private readonly unread = new Map<string, string>();
  private refused: readonly string[] = [];

  // A file of this kind that was chosen cannot be read. Stays until another of that kind is chosen, or written in its place.
  showUnread(kind: string, why: string): void {
    this.unread.set(kind, why);
    this.show();
  }

  dropUnread(kind: string): void {
    this.unread.delete(kind);
    this.show();
  }

  // By the kernel, of the present order; empty: it is not.
  showRefused(why: readonly string[]): void {
    this.refused = why;
    this.show();
  }

  get text(): string {
    return [...this.unread.values(), ...this.refused].join("\n");
  }

  private show(): void {
    this.element.hidden = this.text === "";
    this.element.textContent = this.text;
  }
}
