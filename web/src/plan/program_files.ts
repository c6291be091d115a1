// Which of several files is the program.
import type { TextFile } from "./browser_kernel.ts";

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

// As `O<name> call`, or as M98 and G65 of the Fanuc dialect name it.
function calls(text: string, { name }: TextFile): boolean {
  const stem = name.replace(/\.[^.]*$/, "");
  const number = /^o?0*(\d+)$/i.exec(stem)?.[1];
  const calls = [`o\\s*<\\s*${literal(stem)}\\s*>\\s*call`, `(m\\s*98|g\\s*65)[^\\n]*<\\s*${literal(stem)}\\s*>`];
  if (number) calls.push(`(m\\s*98|g\\s*65)[^\\n]*p\\s*0*${number}(?!\\d)`);
  return new RegExp(calls.join("|"), "i").test(text);
}

// The first that no other calls, and after it the others as they were.
export function programFirst(files: readonly [TextFile, ...TextFile[]]): readonly [TextFile, ...TextFile[]] {
  const isCalled = (file: TextFile): boolean => files.some((other) => other !== file && calls(other.text, file));
  const program = files.find((file) => !isCalled(file)) ?? files[0];
  return [program, ...files.filter((file) => file !== program)];
}
