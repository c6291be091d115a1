// A number for each of some lines of a program, which may have millions of them.

// What a Map is, too.
export interface LineNumbers {
  get(line: number): number | undefined;
  forEach(each: (number: number, line: number) => void): void;
}

export class ByLine implements LineNumbers {
  private readonly numbers: Float64Array; // by line; NaN: none

  constructor(lastLine: number) {
    this.numbers = new Float64Array(lastLine + 1).fill(NaN);
  }

  get(line: number): number | undefined {
    const number = this.numbers[line];
    return number === undefined || Number.isNaN(number) ? undefined : number;
  }

  // line: a whole one, up to the last.
  set(line: number, number: number): void {
    this.numbers[line] = number;
  }

  // In the order of the lines.
  forEach(each: (number: number, line: number) => void): void {
    this.numbers.forEach((number, line) => {
      if (!Number.isNaN(number)) each(number, line);
    });
  }
}
