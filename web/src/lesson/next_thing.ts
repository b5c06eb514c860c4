// SPDX-License-Identifier: BSD-2-Clause
import type { PlaceInfo } from "../app/api";

type Lessons = PlaceInfo["lessons"];

/** The number that a lesson's name begins with, "2" of "02-operators". */
export const numberOf = (name: string): string => /^\D*0*(\d+)/.exec(name)?.[1] ?? "";

/**
 * The next lesson: the first one after `last` that is not passed; if there is none, the first of all that is not
 * passed.
 */
export function nextLesson({ lessons }: Pick<PlaceInfo, "lessons">, last = ""): string {
  const at = lessons.findIndex((one) => one.name === last);
  return (lessons.slice(at + 1).find((one) => !one.is_passed) ?? lessons.find((one) => !one.is_passed))?.name ?? "";
}

export interface Thing { label: string; what: string; goesOn: boolean }

function lessonThing(lessons: Lessons, name: string): Thing | null {
  const found = lessons.find((one) => one.name === name);
  if (found === undefined) return null;
  const isFirst = lessons[0] === found && lessons.every((one) => !one.is_passed);
  return { label: isFirst ? "Begin with lesson 1" : `Lesson ${numberOf(name)}: ${found.title}`, what: `lesson:${name}`, goesOn: false };
}

/** The next steps of a user, the most likely first: a lesson that was begun, the lesson after the last passed one, the
 * first lesson, or the open world. `open`: the current lesson or world, with its title; `last`: the one that was
 * opened last in this browser.
 */
export function nextThings({ lessons }: Pick<PlaceInfo, "lessons">, open: { what: string; title: string } | null, last: string): Thing[] {
  const things: (Thing | null)[] = [], lessonOf = (what: string): Lessons[number] | undefined => lessons.find((one) => what === `lesson:${one.name}`);
  const goOn = open === null ? null : { label: `Go on with ${open.title}`, what: open.what, goesOn: true }, begun = lessonOf(open?.what ?? last);
  if (goOn !== null && begun?.is_passed !== true) things.push(goOn);
  else if (open === null && begun !== undefined && !begun.is_passed) things.push({ label: `Go on with ${begun.title}`, what: `lesson:${begun.name}`, goesOn: false });
  const next = nextLesson({ lessons }, begun?.name);
  if (begun === undefined || begun.is_passed) things.push(lessonThing(lessons, next));
  if (goOn !== null && begun?.is_passed === true) things.push(goOn);
  return things.filter((one) => one !== null);
}
