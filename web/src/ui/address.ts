// The fragment of the URL, which keeps what is shown.
import { toFragment, type Store } from "../state.ts";

const PAUSE_MS = 250; // between two changes: each costs as much as a frame may, and browsers refuse more

export class Address {
  private readonly store: Store;
  private isOld = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(store: Store) {
    this.store = store;
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
    const fragment = toFragment(this.store.state);
    if (this.store.state.hover === null && location.hash.slice(1) !== fragment) history.replaceState(null, "", `#${fragment}`);
  }
}
