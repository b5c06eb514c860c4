// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/link.h"

namespace sml {

namespace {

char LetterOf(smlRunStepSize step) {
  switch (step) {
    case sml_PHASE:
      return 'p';
    case sml_ELABORATION:
      return 'e';
    case sml_DECIDE:
      return 'd';
    case sml_UNTIL_OUTPUT:
      return 'o';
  }
  return 'd';
}

}  // namespace

std::string RunLine(const RunSpec& spec) {
  std::string line = "run";
  if (spec.self) line += " --self";
  if (spec.step == sml_UNTIL_OUTPUT && !spec.forever && spec.count == 1) {
    line += " --output";
  } else if (!spec.forever) {
    line += " -";
    line += LetterOf(spec.step);
  }
  if (spec.interleave_given && !spec.self) {
    line += " -i ";
    line += LetterOf(spec.interleave);
  }
  const bool counted = !spec.forever && !(spec.step == sml_UNTIL_OUTPUT && spec.count == 1);
  if (counted) line += " " + std::to_string(spec.count);
  return line;
}

}  // namespace sml
