// SPDX-License-Identifier: BSD-2-Clause

/** Signs and words of rules that a beginner meets first, in plain words. A `code` in backquotes is an example. */
const WORDS: Readonly<Record<string, string>> = {
  "sp": "**sp** begins a rule (a *soar production*): its name, conditions, `-->`, and actions, all between { and }.",
  "state": "**state** says that the first condition looks at a state: a situation in which the agent decides. Each rule begins with `(state <s> …)`.",
  "-->": "**-->** stands between conditions and actions: if all conditions above it match, the actions below it happen.",
  "write": "**write** prints: `(write |Good day, | <name> (crlf))`. What is printed is shown in the panel Output and over the agent's head.",
  "crlf": "**crlf** begins a new line in what write prints.",
  "halt": "**halt** stops the agent for good.",
  "^superstate": "**^superstate** is nil in the top state, where an agent begins. In a substate, which an impasse creates, it is the state in which the impasse arose. `^superstate nil` therefore means: only in the top state.",
  "^io": "**^io** leads out of the mind: `^io.input-link` holds what the agent perceives, `^io.output-link` takes its commands.",
  "^input-link": "**^input-link** holds what the agent perceives now. It changes by itself, each decision.",
  "^output-link": "**^output-link** takes commands: what an applied operator puts there, the body does.",
  "^operator": "**^operator** in a condition: the operator that is selected. After `-->` with a `+`: one that is proposed.",
  "^name": "**^name** is what an operator or a thing is called; rules that apply an operator test it.",
  "^impasse": "**^impasse** says in a substate why no operator could be selected: tie, conflict, no-change or constraint-failure.",
  "^type": "**^type** of a substate is state; `^impasse` and `^attribute` describe the impasse.",
  "nil": "**nil** means nothing: there is no such thing.",
  "+": "**+** after an operator proposes it: it may be selected. Without a sign other preferences follow: > better, < worse, = indifferent, - rejected, ! required, ~ prohibited.",
  "=": "**=** after an operator: it is indifferent, so Soar may choose by chance among those that are.",
  ">": "**>** after a proposed operator: it is the best, or better than the one that follows.",
  "<": "**<** after a proposed operator: it is the worst, or worse than the one that follows.",
  "-": "**-** before a condition: there is no such thing. After a value in an action: the value is removed.",
  "!": "**!** after an operator: it must be selected.",
  "~": "**~** after an operator: it must not be selected.",
  "<>": "**<>** means: not equal to.",
  "<=>": "**<=>** means: of the same type.",
};

/** The explained words at a position of a line, with their range; null: none. */
export function wordAt(line: string, column: number): { from: number; to: number; about: string } | null {
  const comment = line.search(/(^|\s)#/);
  if (comment >= 0 && column > comment) return null;
  for (const found of line.matchAll(/-->|<=>|<>|<[\w-]+>|\^?[A-Za-z*][\w*-]*|[-+=<>!~]|\|[^|]*\|?|\./g)) {
    const from = found.index, to = from + found[0].length;
    if (column < from || column > to) continue;
    if (column === to && to < line.length && /[^\s()]/.test(line[to]!)) continue;
    // In a path, "^io.input-link" is one attribute after the other.
    const word = /^[A-Za-z]/.test(found[0]) && line[from - 1] === "." ? `^${found[0]}` : found[0], about = Object.hasOwn(WORDS, word) ? WORDS[word] : undefined;
    if (about !== undefined) return { from, to, about: about.replaceAll(/\*([^*]+)\*(?!\*)/g, (all, text: string, at: number) => (about[at - 1] === "*" || about[at + all.length] === "*" ? all : text)) };
  }
  return null;
}
