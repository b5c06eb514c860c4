// SPDX-License-Identifier: BSD-2-Clause
import { createElement, render, type ComponentChild } from "preact";

/** A view is a plain value that functions create without a DOM. patch() puts it into the page with Preact. Texts only become text nodes. */
export interface View {
  readonly tag: string;
  readonly classes: string;
  readonly props: Props;
  readonly children: readonly Child[];
}
export type Child = View | string | number | false | null | undefined | readonly Child[];

export interface Props {
  /** Distinguishes siblings that are added and removed. */
  key?: string;
  /** Of form fields: set only when it differs, so that the caret stays. */
  value?: string;
  checked?: boolean;
  open?: boolean;
  on?: Partial<{ [K in keyof HTMLElementEventMap]: (event: HTMLElementEventMap[K]) => void }>;
  /** Called once when the element is in the page, and after each later patch. */
  mounted?: (element: HTMLElement) => void;
  patched?: (element: HTMLElement) => void;
  /** A custom property or another style, by name; set by script. */
  style?: Readonly<Record<string, string>>;
  /** The children of this element are created elsewhere. */
  foreign?: boolean;
  /** False or undefined: none. In names with "aria-" or "data-", false is the word. */
  attributes?: Readonly<Record<string, string | number | boolean | undefined>>;
}

/** `what`: "div", or with classes "div.row.quiet". */
export function h(what: string, props?: Props | null, ...children: Child[]): View {
  const [tag = "div", ...classes] = what.split(".");
  return { tag, classes: classes.join(" "), props: props ?? {}, children };
}

/** A button with a word on it. */
export function button(label: Child, press: () => void, more: Props = {}, what = "button"): View {
  return h(what, { ...more, attributes: { type: "button", ...more.attributes }, on: { ...more.on, click: press } }, label);
}

const TURNS = /[\u202a-\u202e\u2066-\u2069]/g;
/** Marks that change the direction of text would also affect the text after a name. They are shown as visible marks. */
function withoutTurns(text: string): string {
  return text.replace(TURNS, "\ufffd");
}

/** The readable text of a view; for tests and accessible names. */
export function textOf(child: Child): string {
  if (typeof child === "string") return withoutTurns(child);
  if (typeof child === "number") return String(child);
  if (child === false || child === null || child === undefined) return "";
  return (Array.isArray(child) ? (child as readonly Child[]) : (child as View).children).map(textOf).join("");
}

/** Elements for which `mounted` has been called. */
const inPage = new WeakSet<Element>();

function nodeOf(child: Child): ComponentChild {
  if (typeof child === "string") return withoutTurns(child);
  if (Array.isArray(child)) return (child as readonly Child[]).map(nodeOf);
  if (typeof child !== "object" || child === null) return child;
  const { tag, classes, props, children } = child as View, { on, mounted, patched } = props, given: Record<string, unknown> = { ...props.attributes };
  if (classes !== "") given["class"] = classes;
  if (on !== undefined) for (const type in on) given[`on${type}`] = on[type as keyof HTMLElementEventMap];
  for (const name of ["key", "value", "checked", "open", "style"] as const) if (props[name] !== undefined) given[name] = props[name];
  if (mounted !== undefined || patched !== undefined) given["ref"] = (element: HTMLElement | null) => {
    if (element === null) return;
    if (inPage.has(element)) return patched?.(element);
    inPage.add(element);
    mounted?.(element);
  };
  return props.foreign === true ? createElement(tag, given) : createElement(tag, given, ...children.map(nodeOf));
}

/** Updates the children of an element to match a view. Unchanged nodes are kept, so focus, caret and scrolling stay. */
export function patch(parent: Element, children: readonly Child[]): void {
  render(children.map(nodeOf), parent);
}

/** Empties an element that may show a view, so that all nodes of the next view are new. */
export function clear(parent: Element): void {
  render(null, parent);
  parent.replaceChildren();
}
