// The fragment of the URL, which keeps what is shown.
import { toFragment, type Store } from "../state.ts";
import type { Units } from "../units.ts";

const PAUSE_MS = 250; // between two changes: each costs as much as a frame may, and browsers refuse more

export class Address {
  private readonly store: Store;
  private readonly usual: Units;
  private isOld = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  // usual: the units that need no words.
  constructor(store: Store, usual: Units) {
    this.store = store;
    this.usual = usual;
  }

  // At once, or after the pause.
  keep(): void {
    this.isOld = true;
    if (this.timer !== undefined) return;
    this.write();
    this.timer = setTimeout(() => {
      this.timer = undefined;
      if (this.isOld) this.keep();
    }, PAUSE_MS);
  }

  private write(): void {
    this.isOld = false;
    const fragment = toFragment(this.store.state, this.usual);
    if (this.store.state.hover === null && location.hash.slice(1) !== fragment) history.replaceState(null, "", `#${fragment}`);
  }
}
