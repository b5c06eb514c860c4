// SPDX-License-Identifier: BSD-2-Clause
import { MapMode, RangeSet, StateEffect, StateField, type EditorState, type Extension, type Text } from "@codemirror/state";
import { Decoration, EditorView, gutter, GutterMarker, keymap, type DecorationSet } from "@codemirror/view";

/** The stops of the text that is shown. Lines count from 1. */
export interface ShownStops {
  /** Whether this text is a script that can stop at lines. */
  readonly can: boolean;
  readonly lines: readonly number[];
  /** The line at which it is stopped; 0: none. */
  readonly stoppedLine: number;
}

class StopMarker extends GutterMarker {
  /** A stop stays when text around it is removed. */
  override mapMode = MapMode.Simple;
  constructor(private readonly isStopped: boolean, private readonly isStop: boolean) {
    super();
  }
  override eq(other: StopMarker): boolean {
    return other.isStopped === this.isStopped && other.isStop === this.isStop;
  }
  override toDOM(): Node {
    const mark = document.createElement("span");
    mark.className = `${this.isStop ? "stop-set" : ""} ${this.isStopped ? "stop-here" : ""}`.trim();
    mark.textContent = this.isStopped ? "▶" : "●";
    return mark;
  }
}
const STOP = new StopMarker(false, true), HERE = new StopMarker(true, false), STOP_HERE = new StopMarker(true, true);

interface Stops { readonly can: boolean; readonly stops: RangeSet<GutterMarker>; readonly stopped: DecorationSet; readonly all: RangeSet<GutterMarker> }

const shown = StateEffect.define<ShownStops>();
const NONE: Stops = { can: false, stops: RangeSet.empty, stopped: Decoration.none, all: RangeSet.empty };

/** Stops move with their lines while the text changes. */
const field = StateField.define<Stops>({
  create: () => NONE,
  update: (now, transaction) => {
    for (const effect of transaction.effects) if (effect.is(shown)) return stopsOf(effect.value, transaction.newDoc);
    if (!transaction.docChanged) return now;
    return { can: now.can, stops: now.stops.map(transaction.changes), stopped: now.stopped.map(transaction.changes), all: now.all.map(transaction.changes) };
  },
  provide: (self) => EditorView.decorations.from(self, (stops) => stops.stopped),
});

function stopsOf({ can, lines, stoppedLine }: ShownStops, doc: Text): Stops {
  if (!can) return NONE;
  const inText = [...new Set(lines)].filter((line) => line >= 1 && line <= doc.lines).sort((a, b) => a - b);
  const here = stoppedLine >= 1 && stoppedLine <= doc.lines ? stoppedLine : 0;
  const marked = [...new Set(here === 0 ? inText : [...inText, here])].sort((a, b) => a - b);
  return {
    can, stops: RangeSet.of(inText.map((line) => STOP.range(doc.line(line).from))),
    stopped: here === 0 ? Decoration.none : Decoration.set([Decoration.line({ class: "stopped-line" }).range(doc.line(here).from)]),
    all: RangeSet.of(marked.map((line) => (line !== here ? STOP : inText.includes(line) ? STOP_HERE : HERE).range(doc.line(line).from))),
  };
}

/** The lines of the stops in the text as it is now. */
export function stopLines(state: EditorState): number[] {
  const lines = new Set<number>(), { doc } = state;
  for (const cursor = state.field(field).stops.iter(); cursor.value !== null; cursor.next()) lines.add(doc.lineAt(cursor.from).number);
  return [...lines].sort((a, b) => a - b);
}

/** The change of a state after which these stops are shown. */
export const showing = (stops: ShownStops): StateEffect<ShownStops> => shown.of(stops);

/** A column to the left of the text: a click sets a stop, another click removes it. F9 does the same at the caret. */
export function lineStops(toggle: (line: number, isOn: boolean) => void): Extension {
  const toggleAt = (view: EditorView, position: number): boolean => {
    if (!view.state.field(field).can) return false;
    const line = view.state.doc.lineAt(position).number;
    toggle(line, !stopLines(view.state).includes(line));
    return true;
  };
  return [
    field,
    gutter({
      class: "cm-stops", markers: (view) => view.state.field(field).all,
      domEventHandlers: { mousedown: (view, block) => toggleAt(view, block.from) },
    }),
    EditorView.editorAttributes.of((view) => (view.state.field(field, false)?.can === true ? { class: "can-stop" } : null)),
    keymap.of([{ key: "F9", run: (view) => toggleAt(view, view.state.selection.main.head) }]),
  ];
}
