// SPDX-License-Identifier: BSD-2-Clause
// Commands and functions of old versions of Soar that Soar 9.6 no longer has, with their replacements.
#include "explain/former_soar.h"

#include <span>

namespace soarbox::explain {
namespace {

struct Former {
  std::string_view word, now;
};

constexpr Former kFormerCommands[] = {
    {"o-support-mode", "leave it out: support is always what o-support-mode 4 made it"},
    {"attribute-preferences-mode", "leave it out: only operators have preferences"},
    {"attribute_preferences_mode", "leave it out: only operators have preferences"},
    {"set_learning_choice", "write chunk always, or chunk never"},
    {"save-backtraces", "write explain record all"},
    {"explain-backtraces", "write explain chunk NAME"},
    {"monitor", "a rule that prints is a monitor: (write |text|)"},
    {"soarnews", "leave it out"},
    {"run-til-output", "write run -o 1"},
    {"decision-cycle", "write run -d 1"},
    {"elaboration-cycle", "write run -e 1"},
    {"ask", "leave it out: decide indifferent-selection says how ties of indifferent operators end"},
    {"user-select", "write decide indifferent-selection --first, --last or --softmax"},
    {"exit", "leave it out: the world says when a run ends"},
    {"schedule", "leave it out: the world says when agents decide"},
    {"output-strings-destination", "leave it out"},
    {"format-watch", "write trace 1 to trace 5"},
    {"pgs", "write print --stack"},
    {"wm", "write print, or wm watch"},
};

constexpr Former kFormerFunctions[] = {
    {"tcl",
     "Soar has no Tcl any more: (write ...) prints, (cmd ...) gives a command, (exec NAME ...) calls a function of a "
     "client"},
    {"indiff", "an indifferent operator is written (<s> ^operator <o> =)"},
    {"indifferent", "an indifferent operator is written (<s> ^operator <o> =)"},
    {"accept", "agents perceive through ^io.input-link"},
    {"interface", "agents give commands on ^io.output-link"},
};

constexpr Former kFormerSyntax[] = {
    {"&", "parallel preferences (&) are gone, as all objects but operators hold several values: leave & out"},
    {"@", "reconsider preferences (@) are gone, as operators are reconsidered in each decision: leave @ out"},
    {"goal", "a goal is a state now: write (state <s> ...)"},
    {"impasse", "write (state <s> ^impasse ...)"},
    {"^problem-space", "there are no problem spaces any more: give the state a ^name"},
};

struct FormerOption {
  std::string_view command, option, now;
};
constexpr FormerOption kFormerOptions[] = {
    {"learn", "-off", "write chunk never"},
    {"learn", "off", "write chunk never"},
    {"learn", "-on", "write chunk always"},
    {"learn", "on", "write chunk always"},
    {"learn", "-bottom-up", "write chunk bottom-only on"},
    {"watch", "-level", "write trace and the level: trace 1"},
    {"indifferent-selection", "--random",
     "write decide indifferent-selection --softmax: without numbers it is as --random was"},
    {"indifferent-selection", "-random",
     "write decide indifferent-selection --softmax: without numbers it is as --random was"},
    {"indifferent-selection", "--ask", "nobody can be asked in a run: write decide indifferent-selection --softmax"},
    {"excise", "-all", "options have two dashes: excise --all"},
    {"excise", "-task", "options have two dashes: excise --task"},
};

std::string FindFormer(std::span<const Former> all, std::string_view word) {
  for (const Former& each : all)
    if (each.word == word) return std::string(each.now);
  return {};
}

}  // namespace

std::string FormerCommandHint(std::string_view command) {
  return FindFormer(kFormerCommands, command);
}

std::string FormerFunctionHint(std::string_view function) {
  return FindFormer(kFormerFunctions, function);
}

std::string FormerSyntaxHint(std::string_view found) {
  return FindFormer(kFormerSyntax, found);
}

std::string FormerOptionHint(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t begin = line.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  line.remove_prefix(begin);
  const std::string_view command = line.substr(0, line.find_first_of(kBlanks));
  for (const FormerOption& each : kFormerOptions) {
    if (each.command != command) continue;
    const std::size_t at = line.find(each.option, command.size());
    const std::size_t end = at + each.option.size();
    const bool is_word = at != std::string_view::npos && kBlanks.find(line[at - 1]) != std::string_view::npos &&
                         (end >= line.size() || kBlanks.find(line[end]) != std::string_view::npos);
    if (is_word) return std::string(each.now);
  }
  return {};
}

}  // namespace soarbox::explain
