// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, textOf, type Child, type View } from "../dom/view";
import { filterField, passes, table as plainTable } from "../panels/parts";
import { digits } from "./chart";

/** Text, a number, or a view that is sorted by its text. */
export type TableCell = string | number | View;

const MOST_ROWS = 2000, FILTERED_FROM = 20;

const plain = (cell: TableCell): string | number => (typeof cell === "object" ? textOf(cell) : cell);

/**
 * The rows that pass a filter, sorted by a column: numbers by value, texts in natural order. Equal rows keep their
 * order. `by` -1: not sorted.
 */
export function arranged(rows: readonly (readonly TableCell[])[], by: number, isRising: boolean, filter: string): (readonly TableCell[])[] {
  const shown = filter === "" ? [...rows] : rows.filter((row) => passes(filter, row.map(plain).join(" ")));
  if (by < 0) return shown;
  const sorted = shown.map((row, at) => ({ row, at, key: plain(row[by] ?? "") }));
  sorted.sort((a, b) => {
    const less = typeof a.key === "number" && typeof b.key === "number" ? a.key - b.key : String(a.key).localeCompare(String(b.key), undefined, { numeric: true });
    return (isRising ? less : -less) || a.at - b.at;
  });
  return sorted.map(({ row }) => row);
}

/** Columns with only numbers and empty cells. */
export function numberColumns(columns: number, rows: readonly (readonly TableCell[])[]): boolean[] {
  return Array.from({ length: columns }, (_, c) => rows.some((row) => typeof row[c] === "number") && rows.every((row) => typeof row[c] === "number" || row[c] === ""));
}

/** A table that is sorted by a press on a column's head; long ones can be filtered. */
export function table(columns: readonly string[], rows: readonly (readonly TableCell[])[], caption: string): View {
  const isNumber = numberColumns(columns.length, rows);
  return h("div.table", {
    foreign: true,
    mounted: (place) => {
      let by = -1, isRising = true, filter = "";
      const draw = (): void => {
        const shown = arranged(rows, by, isRising, filter), few = shown.slice(0, MOST_ROWS);
        const told = few.length < shown.length ? ` (the first ${few.length} of ${shown.length})` : filter === "" ? "" : ` (${shown.length} of ${rows.length})`;
        const head = (name: string, c: number): View => h(`th${isNumber[c] === true ? ".number" : ""}`, { attributes: { scope: "col", "aria-sort": c !== by ? "none" : isRising ? "ascending" : "descending" } },
          button([name, h("span.way", { attributes: { "aria-hidden": "true" } }, c !== by ? "" : isRising ? " ▲" : " ▼")], () => {
            isRising = by === c ? !isRising : true;
            by = c;
            draw();
          }, {}, "button.sort"));
        patch(place, [
          rows.length >= FILTERED_FROM && filterField(`Filter: ${caption}`, filter, (words) => {
            filter = words;
            draw();
          }),
          h("div.scroll", { attributes: { tabindex: 0, role: "region", "aria-label": caption } },
            plainTable(columns.map(head), few.map((row): Child => h("tr", null, row.map((cell, c): Child => h(`td${isNumber[c] === true ? ".number" : ""}`, null, typeof cell === "number" ? digits(cell) : cell)))), { caption: caption + told })),
        ]);
      };
      draw();
    },
  });
}

/** A folded part. Its content is created when it is opened for the first time. */
export function fold(title: string, make: () => Child): View {
  return h("details", {
    on: { toggle: (event) => {
      const details = event.currentTarget as HTMLDetailsElement, inside = details.querySelector(".inside");
      if (details.open && inside !== null && inside.childNodes.length === 0) patch(inside, [make()]);
    } },
  }, h("summary", null, title), h("div.inside", { foreign: true }));
}
