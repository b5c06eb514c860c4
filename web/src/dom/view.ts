// SPDX-License-Identifier: BSD-2-Clause

/** A view is a plain value that functions create without a DOM. patch() puts it into the page. Texts only become text nodes. */
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
  attributes?: Readonly<Record<string, string | number | boolean | undefined>>;
}

const SVG = "http://www.w3.org/2000/svg";
const SVG_TAGS = new Set(["svg", "path", "rect", "circle", "line", "g", "text", "title"]);

/** `what`: "div", or with classes "div.row.quiet". */
export function h(what: string, props?: Props | null, ...children: Child[]): View {
  const [tag = "div", ...classes] = what.split(".");
  return { tag, classes: classes.join(" "), props: props ?? {}, children };
}

/** A button with a word on it. */
export function button(label: Child, press: () => void, more: Props = {}, what = "button"): View {
  return h(what, { ...more, attributes: { type: "button", ...more.attributes }, on: { ...more.on, click: press } }, label);
}

type Flat = View | string;

const TURNS = /[\u202a-\u202e\u2066-\u2069]/g;
/** Marks that change the direction of text would also affect the text after a name. They are shown as visible marks. */
function withoutTurns(text: string): string {
  return text.replace(TURNS, "\ufffd");
}

function flatten(children: readonly Child[], into: Flat[] = []): Flat[] {
  for (const child of children) {
    if (child === false || child === null || child === undefined || child === "") continue;
    if (Array.isArray(child)) flatten(child as readonly Child[], into);
    else if (typeof child === "number") into.push(String(child));
    else into.push(typeof child === "string" ? withoutTurns(child) : (child as Flat));
  }
  // Neighbouring texts are one node, as the document has them.
  return into.reduce<Flat[]>((all, one) => {
    const last = all.at(-1);
    if (typeof one === "string" && typeof last === "string") all[all.length - 1] = last + one;
    else all.push(one);
    return all;
  }, []);
}

/** The readable text of a view; for tests and accessible names. */
export function textOf(child: Child): string {
  return flatten([child]).map((one) => (typeof one === "string" ? one : textOf(one.children))).join("");
}

interface Known { view: View; listeners: Set<string> }
const known = new WeakMap<Element, Known>();

function create(flat: Flat, document: Document): Node {
  if (typeof flat === "string") return document.createTextNode(flat);
  const element = SVG_TAGS.has(flat.tag) ? document.createElementNS(SVG, flat.tag) : document.createElement(flat.tag);
  known.set(element, { view: { tag: flat.tag, classes: "", props: {}, children: [] }, listeners: new Set() });
  update(element, flat);
  return element;
}

function update(element: Element, view: View): void {
  const state = known.get(element)!;
  const before = state.view;
  state.view = view;
  if (before.classes !== view.classes) element.setAttribute("class", view.classes);
  const was = before.props.attributes ?? {}, now = view.props.attributes ?? {};
  for (const name of Object.keys(was)) if (now[name] === undefined || now[name] === false) element.removeAttribute(name);
  for (const [name, value] of Object.entries(now)) {
    if (value === undefined || value === false || was[name] === value) continue;
    element.setAttribute(name, value === true ? "" : String(value));
  }
  const styles = (element as HTMLElement).style;
  for (const name of Object.keys(before.props.style ?? {})) if (view.props.style?.[name] === undefined) styles.removeProperty(name);
  for (const [name, value] of Object.entries(view.props.style ?? {}))
    if (before.props.style?.[name] !== value) styles.setProperty(name, value);
  for (const type of Object.keys(view.props.on ?? {})) {
    if (state.listeners.has(type)) continue;
    state.listeners.add(type);
    element.addEventListener(type, (event) => {
      const handler = known.get(element)?.view.props.on?.[type as keyof HTMLElementEventMap] as ((event: Event) => void) | undefined;
      handler?.(event);
    });
  }
  if (view.props.foreign !== true) patch(element, view.children);
  const field = element as HTMLInputElement;
  if (view.props.value !== undefined && field.value !== view.props.value) field.value = view.props.value;
  if (view.props.checked !== undefined) field.checked = view.props.checked;
  // The reader opens and closes it; the view only sets the initial state.
  if (view.props.open !== undefined && view.props.open !== before.props.open) (element as HTMLDetailsElement).open = view.props.open;
}

function fits(node: Node, flat: Flat): boolean {
  if (typeof flat === "string") return node.nodeType === 3;
  if (node.nodeType !== 1) return false;
  const state = known.get(node as Element);
  return state !== undefined && state.view.tag === flat.tag && state.view.props.key === flat.props.key;
}

let depth = 0;
const pending: (() => void)[] = [];

/** Updates the children of an element to match a view. Unchanged nodes are kept, so focus, caret and scrolling stay. */
export function patch(parent: Element, children: readonly Child[]): void {
  depth += 1;
  try {
    patchChildren(parent, children);
  } finally {
    depth -= 1;
  }
  // Calls `mounted` only after all nodes are in the page.
  if (depth === 0) for (const call of pending.splice(0)) call();
}

function patchChildren(parent: Element, children: readonly Child[]): void {
  const wanted = flatten(children);
  const keyed = new Map<string, Element>();
  for (const node of parent.children) {
    const key = known.get(node)?.view.props.key;
    if (key !== undefined) keyed.set(key, node);
  }
  let at: ChildNode | null = parent.firstChild;
  for (const flat of wanted) {
    const key = typeof flat === "string" ? undefined : flat.props.key;
    const elsewhere = key === undefined ? undefined : keyed.get(key);
    if (elsewhere !== undefined && elsewhere !== at && fits(elsewhere, flat)) parent.insertBefore(elsewhere, at), (at = elsewhere);
    if (at !== null && fits(at, flat)) {
      const node = at;
      at = at.nextSibling;
      if (typeof flat === "string") {
        if (node.nodeValue !== flat) node.nodeValue = flat;
      } else {
        update(node as unknown as Element, flat);
        if (flat.props.patched !== undefined) pending.push(() => flat.props.patched!(node as unknown as HTMLElement));
      }
      continue;
    }
    const made = create(flat, parent.ownerDocument);
    parent.insertBefore(made, at);
    if (typeof flat !== "string" && flat.props.mounted !== undefined) pending.push(() => flat.props.mounted!(made as HTMLElement));
  }
  while (at !== null) {
    const next: ChildNode | null = at.nextSibling;
    at.remove();
    at = next;
  }
}
