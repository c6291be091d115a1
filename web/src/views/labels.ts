// Names of places that do not lie over each other.
export const LINE_PX = 15;

interface Label {
  readonly left: number;
  readonly width: number;
  readonly y: number; // of its middle
}

// What lies over the view, from there to its lower right corner.
export interface Corner {
  readonly left: number;
  readonly top: number;
}

export class Labels {
  private readonly taken: Label[] = [];
  private readonly covered: Corner;

  constructor(covered: Corner = { left: Infinity, top: Infinity }) {
    this.covered = covered;
  }

  // Where that label may stand: where it wants to, or above what covers it and those that are there already.
  freeY({ left, width, y: wanted }: Label): number {
    const highest = left + width > this.covered.left ? this.covered.top - LINE_PX / 2 : Infinity;
    const y = Math.min(wanted, highest);
    const beside = this.taken.filter((one) => left < one.left + one.width && one.left < left + width).sort((a, b) => b.y - a.y);
    let free = y;
    for (const one of beside) {
      if (Math.abs(one.y - free) < LINE_PX) free = one.y - LINE_PX;
    }
    this.taken.push({ left, width, y: free });
    return free;
  }
}
