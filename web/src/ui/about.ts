// What this page is made of.
import { h, table } from "./dom.ts";

declare const KERF_LICENCES: readonly { name: string; version: string; licence: string; text: string }[];

const KEYS: readonly (readonly [where: string, key: string, does: string])[] = [
  ["anywhere", "space", "plays and pauses"],
  ["", "comma, dot", "step back and on by a tick"],
  ["", "F", "fits the cut"],
  ["", "1 to 4", "look from the top, the front, the right, a corner"],
  ["in the path", "arrow keys", "turn it; with Shift they move it"],
  ["", "plus, minus", "zoom"],
  ["in the charts", "left, right", "move the instant; with Shift what is seen"],
  ["", "up, down, plus, minus", "zoom about the instant"],
  ["", "Home, End", "go to the first and the last instant"],
  ["in the program", "up, down", "step by a line"],
  ["on the tabs", "left, right, Home, End", "choose"],
];

export function aboutBox(isReport: boolean): HTMLDialogElement {
  const dialog = h("dialog", { class: "about", "aria-label": "About this page" });
  const close = h("button", { type: "button", click: () => dialog.close() }, "Close");
  dialog.append(
    h("h2", {}, "Kerf"),
    h("p", {}, `${isReport ? "A report" : "The playground"} of Kerf, a motion kernel for CNC machines: Apache License 2.0. It loads nothing and sends nothing; ${isReport ? "all that it shows is in this file" : "what is typed or opened stays here"}.`),
    h("h3", {}, "Keys"),
    table(["where", "key", "does"], KEYS, "keys"),
    h("h3", {}, "With"),
    ...KERF_LICENCES.map(({ name, version, licence, text }) => h("details", {}, h("summary", {}, `${name} ${version}, ${licence}`), h("pre", {}, text))),
    close,
  );
  return dialog;
}
