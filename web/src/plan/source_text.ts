// The text of a long program, whose numbers stand apart.
import type { Decoded, Numbers } from "./decode.ts";

const MARKS = 8; // bytes 1 to 8: a number of 0 to 7 decimals
const MOST = 18; // characters of a number, with sign and point
const PIECE = 1 << 18; // bytes of a step
const WHOLE = 2 ** 31; // below it, numbers are divided as integers: of a long program there are millions

// Writes a number of so many decimals, given without its point. Returns where it ends.
function write(number: number, decimals: number, into: Uint8Array, at: number): number {
  if (number < 0) into[at++] = 0x2d;
  let rest = Math.abs(number);
  let size = 1;
  for (let power = 10; power <= rest; power *= 10) ++size;
  size = Math.max(size, decimals + 1);
  const end = at + size + (decimals > 0 ? 1 : 0);
  for (let place = end - 1, digit = 0; digit < size; --place, ++digit) {
    if (digit === decimals && decimals > 0) into[place--] = 0x2e;
    const less = rest < WHOLE ? (rest / 10) | 0 : Math.floor(rest / 10);
    into[place] = 0x30 + (rest - 10 * less);
    rest = less;
  }
  return end;
}

// A text with one byte for each number, being written out.
class Writing {
  source = new Uint8Array();
  at = 0; // where it ends
  private readonly stores: (Float64Array | undefined)[] = [];
  private readonly taken = new Uint32Array(256 * MARKS);

  get soFar(): Uint8Array {
    return this.source.subarray(0, this.at);
  }

  // numbers: by "source.X3", of the letter X and 3 decimals.
  *read(numbers: Numbers, textLength: number): Generator<Uint8Array> {
    let count = 0;
    for (const name of numbers.keys()) {
      const [, letter, decimals] = /^source\.([A-Za-z])(\d)$/.exec(name) ?? [];
      if (letter === undefined) continue;
      const values = numbers.get(name)!;
      this.stores[letter.charCodeAt(0) * MARKS + Number(decimals)] = values;
      count += values.length;
      yield this.soFar;
    }
    this.source = new Uint8Array(textLength + count * MOST);
  }

  // False: a byte that stands for no number.
  add(text: Uint8Array): boolean {
    const { source, stores, taken } = this;
    let { at } = this;
    for (const byte of text) {
      if (byte === 0 || byte > MARKS) {
        source[at++] = byte;
        continue;
      }
      const store = at > 0 ? source[at - 1]! * MARKS + byte - 1 : 0;
      const number = stores[store]?.[taken[store]!++];
      if (number === undefined) return false;
      at = write(number, byte - 1, source, at);
    }
    this.at = at;
    return true;
  }
}

function* sourceOf(text: Uint8Array, numbers: Numbers): Generator<Uint8Array, Uint8Array> {
  const writing = new Writing();
  yield* writing.read(numbers, text.length);
  for (let begin = 0; begin < text.length; begin += PIECE) {
    if (!writing.add(text.subarray(begin, begin + PIECE))) return text; // bytes that are the program's own
    yield writing.soFar;
  }
  return writing.soFar;
}

export const hasSource = ({ bytes }: Decoded): boolean => bytes.has("source") || bytes.has("source.text");

// The program's text, to the byte, made in steps, each of which gives what there is so far; empty: it is not in the plan.
export function* sourceIn({ numbers, bytes }: Decoded): Generator<Uint8Array, Uint8Array> {
  const text = bytes.get("source.text");
  return text ? yield* sourceOf(text, numbers) : (bytes.get("source") ?? new Uint8Array());
}
