// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import { filterField, passes } from "../panels/parts";
import { cssColor, kindColor, teamColor } from "../scene/looks";
import { plainText, type Cell, type Column, type RowAction, type Spans, type Table, type TableRow } from "./document";

/** Maximum number of rows that are drawn; the filter finds the others. */
const MOST_ROWS = 400;

interface Uses {
  spans(spans: Spans): Child[];
  press(action: RowAction, row: TableRow): void;
  redraw(): void;
}
interface TableState { filter: string; group: number; sortedBy: number; isDescending: boolean; folds: Map<string, boolean> }

const spansOf = (cell: Cell): Spans => (typeof cell === "object" && "s" in cell ? cell.s : (cell as Spans));
const numberOf = (cell: Cell | undefined): number | undefined => (typeof cell === "object" && "s" in cell ? cell.n : undefined);
const leadsOn = (spans: Spans): boolean => typeof spans !== "string" && spans.some((span) => typeof span !== "string" && (typeof span[0] === "number" || (span[2] ?? null) !== null));

/** Tables of documents: filters, groups, sorting and folded rows. */
export class TableViews {
  private readonly states = new Map<string, TableState>();

  constructor(private readonly uses: Uses) {}

  view(table: Table): Child[] {
    let state = this.states.get(table.key);
    if (state === undefined) this.states.set(table.key, (state = { filter: "", group: 0, sortedBy: -1, isDescending: false, folds: new Map() }));
    const rows = this.shown(table, state), bar = this.bar(table, state);
    if (rows.length === 0 && table.none !== undefined) return [bar, h("div.empty", null, h("p", null, table.none[0], " ", h("span.quiet", null, table.none[1])))];
    const isWide = (i: number): string => (table.columns[i]?.wide === true ? ".wide" : "");
    const drawn = rows.slice(0, MOST_ROWS);
    return [bar, h("table", { key: table.key }, table.caption !== undefined && h("caption", null, table.caption),
      table.headless !== true && h("thead", null, h("tr", null, table.columns.map((column, i) => this.head(table, state, column, i)))),
      h("tbody", null, drawn.map((row) => this.row(table, state, row, isWide)))),
    rows.length > drawn.length && h("p.quiet", null, `and ${rows.length - drawn.length} more`)];
  }

  private bar(table: Table, state: TableState): Child {
    if (table.filter === undefined && table.groups === undefined) return false;
    return h("div.row", { key: `bar ${table.key}` }, table.groups !== undefined && h("select", { value: String(state.group), attributes: { "aria-label": table.groups_hint }, on: { change: (event) => {
      state.group = Number((event.target as HTMLSelectElement).value);
      this.uses.redraw();
    } } }, table.groups.map((group, i) => h("option", { attributes: { value: i } }, group))),
    table.filter !== undefined && filterField(table.filter, state.filter, (text) => {
      state.filter = text;
      this.uses.redraw();
    }));
  }

  private head(table: Table, state: TableState, column: Column, i: number): View {
    const isSorted = state.sortedBy === i, label = [column.title, isSorted && h("span", { attributes: { "aria-hidden": true } }, state.isDescending ? " ▾" : " ▴")];
    const what = `th${column.number === true ? ".number" : ""}${column.wide === true ? ".wide" : ""}`;
    return h(what, { attributes: { scope: "col", title: column.hint, "aria-sort": isSorted ? (state.isDescending ? "descending" : "ascending") : undefined } },
      table.sorts !== true ? label : button(label, () => {
        // Numbers are sorted in descending order first; a third press restores the original order.
        const first = column.number === true, isOver = isSorted && state.isDescending !== first;
        state.isDescending = isSorted ? !state.isDescending : first;
        state.sortedBy = isOver ? -1 : i;
        this.uses.redraw();
      }, {}, "button.link.sort"));
  }

  private shown(table: Table, state: TableState): readonly TableRow[] {
    let rows = table.rows;
    if (table.groups !== undefined && state.group > 0) rows = rows.filter((row) => ((row.g ?? -1) >> state.group) & 1);
    if (state.filter !== "") rows = rows.filter((row) => passes(state.filter, `${row.c.map((cell) => plainText(spansOf(cell))).join(" ")} ${row.hint ?? ""}`));
    if (state.sortedBy >= 0) {
      const column = state.sortedBy, sign = state.isDescending ? -1 : 1;
      rows = [...rows].sort((a, b) => {
        const x = numberOf(a.c[column]), y = numberOf(b.c[column]);
        return sign * (x !== undefined && y !== undefined ? x - y : plainText(spansOf(a.c[column] ?? "")).localeCompare(plainText(spansOf(b.c[column] ?? ""))));
      });
    }
    let hiddenBelow = -1;
    return rows.filter((row) => {
      const depth = row.depth ?? 0;
      if (hiddenBelow >= 0 && depth > hiddenBelow) return false;
      hiddenBelow = row.open !== undefined && !(state.folds.get(row.k) ?? row.open) ? depth : -1;
      return true;
    });
  }

  private row(table: Table, state: TableState, row: TableRow, wide: (i: number) => string): View {
    // The first cell without its own action gets the action of the row.
    const pressed = table.press === undefined || (table.press.argument !== undefined && row.a?.[table.press.argument - 1] === undefined) ? -1
      : row.c.findIndex((cell) => !leadsOn(spansOf(cell)) && plainText(spansOf(cell)) !== "");
    const anyPress = table.press !== undefined && pressed < 0 && row.a === undefined && table.press.argument === undefined ? 0 : pressed;
    const isOpen = row.open === undefined ? undefined : (state.folds.get(row.k) ?? row.open);
    return h(`tr${row.chosen === true ? ".chosen" : ""}`, { key: row.k, attributes: { title: row.hint, "aria-selected": table.press === undefined ? undefined : String(row.chosen === true) } }, row.c.map((cell, i) => {
      const spans = spansOf(cell), column = table.columns[i], bar = typeof cell === "object" && "s" in cell ? cell.bar : undefined;
      const sign = i === 0 && row.sign !== undefined && signView(row.sign);
      const content = i === anyPress && table.press !== undefined
        ? this.pressed(table.press, row, spans, sign)
        : [sign, this.uses.spans(spans)];
      const fold = i === 0 && isOpen !== undefined && button(isOpen ? "▾" : "▸", () => {
        state.folds.set(row.k, !isOpen);
        this.uses.redraw();
      }, { attributes: { "aria-expanded": String(isOpen), "aria-label": `${isOpen ? "Fold" : "Unfold"} ${plainText(spans)}` } }, "button.fold");
      return h(`td${column?.number === true ? ".number" : ""}${bar === undefined ? "" : ".bar"}${wide(i)}`, { style: {
        ...(i === 0 && row.depth !== undefined ? { "padding-left": `${0.4 + 0.9 * row.depth}em` } : {}), ...(bar === undefined ? {} : { "--bar": `${Math.abs(bar) * 100}%` }) } }, fold, content);
    }));
  }

  /** Cells with their own actions stay next to the cell with the action of the row. */
  private pressed(press: RowAction, row: TableRow, spans: Spans, sign: Child): Child {
    const all = typeof spans === "string" ? [spans] : spans;
    const own = all.filter((span) => !leadsOn([span])), others = all.filter((span) => leadsOn([span]));
    return [button([sign, this.uses.spans(own)], () => this.uses.press(press, row), { attributes: { "aria-pressed": String(row.chosen === true) } }, "button.link.row-press"), this.uses.spans(others)];
  }
}

/** The colour of a body, as in the picture. */
function signView([team, kind, isForeign]: readonly [string, string, boolean]): View {
  const color = cssColor(team === "" ? kindColor(kind) : teamColor(team));
  return h(`i.team${isForeign ? ".foreign" : ""}`, { style: { [isForeign ? "color" : "background"]: color } });
}
