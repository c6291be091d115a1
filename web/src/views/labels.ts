// Names of places that do not lie over each other.
export const LINE_PX = 15;

interface Label {
  readonly left: number;
  readonly width: number;
  readonly y: number; // of its middle
}

export class Labels {
  private readonly taken: Label[] = [];

  // Where that label may stand: where it wants to, or above those that are there already.
  freeY({ left, width, y }: Label): number {
    const beside = this.taken.filter((one) => left < one.left + one.width && one.left < left + width).sort((a, b) => b.y - a.y);
    let free = y;
    for (const one of beside) {
      if (Math.abs(one.y - free) < LINE_PX) free = one.y - LINE_PX;
    }
    this.taken.push({ left, width, y: free });
    return free;
  }
}
