// What is wrong with a program, or may be: each message once.
import { lastPart, type Plan } from "./plan.ts";

const CUT_OFF = "E0012"; // after the largest number of errors the rest of a program is not read

export interface Messages {
  readonly errors: readonly string[];
  readonly warnings: readonly string[];
  readonly first: string; // the first error, without its place
  readonly isCutOff: boolean; // there may be more errors
}

export function messagesOf({ header }: Plan): Messages {
  const { report, diagnostics } = header;
  type Diagnostic = (typeof diagnostics)[number];
  const place = ({ file, line }: Diagnostic, named: string): string => (file === report.file ? `line ${line}` : `line ${line} of ${named}`);
  const text = (one: Diagnostic): string => `${one.severity} ${one.id}, ${place(one, lastPart(one.file))}: ${one.message}. ${one.remedy}`;
  const of = (severity: "error" | "warning"): string[] => diagnostics.filter((one) => one.severity === severity).map(text);
  // The report repeats those that have a place in the program: errors with their number, warnings with their line.
  const repeated = new Set(diagnostics.map((one) => `${place(one, one.file)}: ${one.message}`));
  return {
    errors: [...of("error"), ...report.errors.filter((one) => one.id === undefined).map((one) => one.message)],
    warnings: [...of("warning"), ...report.warnings.filter((one) => !repeated.has(one))],
    first: report.errors[0]?.message ?? "",
    isCutOff: diagnostics.some((one) => one.id === CUT_OFF),
  };
}

const several = (count: number, word: string): string => `${count} ${word}${count === 1 ? "" : "s"}`;
export const errorCount = ({ errors, isCutOff }: Messages): string => `${several(errors.length, "error")}${isCutOff ? " or more" : ""}`;

// "2 errors, 1 warning"; empty without messages.
export function countText(messages: Messages): string {
  const { errors, warnings } = messages;
  return [...(errors.length > 0 ? [errorCount(messages)] : []), ...(warnings.length > 0 ? [several(warnings.length, "warning")] : [])].join(", ");
}
