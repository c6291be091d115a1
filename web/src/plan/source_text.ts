// The text of a long program, whose numbers stand apart.
import type { Numbers } from "./decode.ts";

const MARKS = 8; // bytes 1 to 8: a number of 0 to 7 decimals
const MOST = 18; // characters of a number, with sign and point
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

// text: with one byte for each number. numbers: by "source.X3", of the letter X and 3 decimals.
export function sourceOf(text: Uint8Array, numbers: Numbers): Uint8Array {
  const stores: (Float64Array | undefined)[] = [];
  let count = 0;
  for (const name of numbers.keys()) {
    const [, letter, decimals] = /^source\.([A-Za-z])(\d)$/.exec(name) ?? [];
    if (letter === undefined) continue;
    const values = numbers.get(name)!;
    stores[letter.charCodeAt(0) * MARKS + Number(decimals)] = values;
    count += values.length;
  }
  const taken = new Uint32Array(256 * MARKS);
  const source = new Uint8Array(text.length + count * MOST);
  let at = 0;
  for (const byte of text) {
    if (byte === 0 || byte > MARKS) {
      source[at++] = byte;
      continue;
    }
    const store = at > 0 ? source[at - 1]! * MARKS + byte - 1 : 0;
    const number = stores[store]?.[taken[store]!++];
    if (number === undefined) return text; // bytes that are the program's own
    at = write(number, byte - 1, source, at);
  }
  return source.subarray(0, at);
}
