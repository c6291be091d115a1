// Why what was chosen or written is not what is shown.
import { h } from "./dom.ts";

export class Refusal {
  readonly element = h("div", { class: "refusal", role: "alert", hidden: true });
  private unread: readonly string[] = [];
  private refused: readonly string[] = [];

  // A file that was chosen cannot be read. Stays until something else is chosen or written.
  showUnread(why: string): void {
    this.unread = [why];
    this.show();
  }

  dropUnread(): void {
    this.unread = [];
    this.show();
  }

  // By the kernel, of the present order; empty: it is not.
  showRefused(why: readonly string[]): void {
    this.refused = why;
    this.show();
  }

  get text(): string {
    return [...this.unread, ...this.refused].join("\n");
  }

  private show(): void {
    this.element.hidden = this.text === "";
    this.element.textContent = this.text;
  }
}
