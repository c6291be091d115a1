// The smallest and the largest value of any range of a series, at once.

export interface MinMax {
  min: number;
  max: number;
}

// Level k has the minimum and maximum of each 4^k neighbours.
export class Pyramid {
  private readonly mins: Float32Array[] = [];
  private readonly maxs: Float32Array[] = [];
  readonly length: number;

  // Of equal length; one and the same where a column is a single tick.
  constructor(min: Float32Array, max: Float32Array) {
    this.length = min.length;
    this.mins.push(min);
    this.maxs.push(max);
    while (this.mins[this.mins.length - 1]!.length > 4) {
      const [below, above] = [this.mins[this.mins.length - 1]!, this.maxs[this.maxs.length - 1]!];
      const size = Math.ceil(below.length / 4);
      const mins = new Float32Array(size).fill(Infinity);
      const maxs = new Float32Array(size).fill(-Infinity);
      for (let i = 0; i < below.length; ++i) {
        const at = i >> 2;
        if (below[i]! < mins[at]!) mins[at] = below[i]!;
        if (above[i]! > maxs[at]!) maxs[at] = above[i]!;
      }
      this.mins.push(mins);
      this.maxs.push(maxs);
    }
  }

  // Of columns from <= i < to, clamped to those there are; of none: NaN.
  range(from: number, to: number): MinMax {
    let low = Math.max(0, Math.floor(from));
    let high = Math.min(this.length, Math.ceil(to));
    const found = { min: Infinity, max: -Infinity };
    if (low >= high) return { min: NaN, max: NaN };
    for (let level = 0; low < high; ++level) {
      const [mins, maxs] = [this.mins[level]!, this.maxs[level]!];
      const take = (i: number): void => {
        if (mins[i]! < found.min) found.min = mins[i]!;
        if (maxs[i]! > found.max) found.max = maxs[i]!;
      };
      if (level === this.mins.length - 1) {
        for (; low < high; ++low) take(low);
        break;
      }
      while (low < high && low % 4 !== 0) take(low++);
      while (low < high && high % 4 !== 0) take(--high);
      low /= 4;
      high /= 4;
    }
    return found;
  }
}
