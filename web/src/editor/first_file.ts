// SPDX-License-Identifier: BSD-2-Clause
import type { Contents } from "../run/contents";

export const fileName = (path: string): string => path.split("/").at(-1) ?? path;

/** The file that the editor shows by default: the one with this name if there is one, otherwise the rules of the selected agent. */
export function firstFile(contents: Contents, wanted = ""): string {
  const files = contents.edit?.files ?? [], agent = contents.moment?.agent ?? "";
  return (files.find((one) => fileName(one.file) === wanted) ?? files.find((one) => one.is_rules && one.agent === agent) ?? files.find((one) => one.is_rules) ?? files[0])?.file ?? "";
}
