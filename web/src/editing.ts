// A text that is written here, and the file that it is of. Another file in its place can be undone, as can what is typed.
import { defaultKeymap, history, historyKeymap, invertedEffects, isolateHistory } from "@codemirror/commands";
import { StateEffect, StateField, Text, type EditorState, type Extension, type TransactionSpec } from "@codemirror/state";
import { EditorView, keymap } from "@codemirror/view";
import type { TextFile } from "./plan/browser_kernel.ts";
import { linesOf } from "./views/planned_lines.ts";

// The file that is written, then what belongs to it.
export type Files = readonly [TextFile, ...TextFile[]];

interface Opened {
  readonly name: string;
  readonly text: Text; // as it was opened
  readonly others: readonly TextFile[];
}

const setOpened = StateEffect.define<Opened>();
const opened = StateField.define<Opened>({
  create: () => ({ name: "", text: Text.empty, others: [] }),
  update: (before, { effects }) => effects.reduce((last, effect) => (effect.is(setOpened) ? effect.value : last), before),
});
const undone = invertedEffects.of(({ effects, startState }) => (effects.some((effect) => effect.is(setOpened)) ? [setOpened.of(startState.field(opened))] : []));

const openedOf = ([{ name, text }, ...others]: Files): Opened => ({ name, text: linesOf(text), others });

// changed: is told the files after each change.
export function writing(first: Files, changed: (files: Files, isRewritten: boolean) => void): Extension {
  return [
    opened.init(() => openedOf(first)),
    undone,
    history(),
    keymap.of([...defaultKeymap, ...historyKeymap]),
    EditorView.updateListener.of(({ docChanged, startState, state }) => {
      if (docChanged || startState.field(opened) !== state.field(opened)) changed(filesOf(state), isRewritten(state));
    }),
  ];
}

function filesOf(state: EditorState): Files {
  const { name, others } = state.field(opened);
  return [{ name, text: state.doc.toString() }, ...others];
}

const isRewritten = (state: EditorState): boolean => !state.doc.eq(state.field(opened).text);

// Files beside those that are there, in place of others of their names.
export function adding(files: readonly TextFile[]): (state: EditorState) => TransactionSpec {
  const names = files.map(({ name }) => name);
  return (state) => {
    const before = state.field(opened);
    return { effects: setOpened.of({ ...before, others: [...before.others.filter(({ name }) => !names.includes(name)), ...files] }), annotations: isolateHistory.of("full") };
  };
}

// Others in place of the files that are there.
export function opening(files: Files): (state: EditorState) => TransactionSpec {
  const now = openedOf(files);
  return ({ doc }) => ({
    changes: { from: 0, to: doc.length, insert: now.text },
    selection: { anchor: 0 },
    effects: setOpened.of(now),
    annotations: isolateHistory.of("full"),
  });
}
