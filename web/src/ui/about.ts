// What this page is made of.
import { h } from "./dom.ts";

declare const KERF_LICENCES: readonly { name: string; version: string; licence: string; text: string }[];

export function aboutBox(): HTMLDialogElement {
  const dialog = h("dialog", { class: "about", "aria-label": "About this page" });
  const close = h("button", { type: "button", click: () => dialog.close() }, "Close");
  dialog.append(
    h("h2", {}, "Kerf"),
    h("p", {}, "A report of Kerf, a motion kernel for CNC machines: Apache License 2.0. It loads nothing and sends nothing; all that it shows is in this file."),
    h("p", {}, "Keys: space plays, comma and dot step by a tick, arrow keys in the program step by a line, F fits the cut, 1 to 4 are top, front, right and isometric."),
    h("h3", {}, "With"),
    ...KERF_LICENCES.map(({ name, version, licence, text }) => h("details", {}, h("summary", {}, `${name} ${version}, ${licence}`), h("pre", {}, text))),
    close,
  );
  return dialog;
}
