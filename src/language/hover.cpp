// SPDX-License-Identifier: BSD-2-Clause
#include "language/hover.h"

#include <cstdio>
#include <set>

#include "debugger/percept_help.h"
#include "explain/rule_slips.h"
#include "language/soar_help.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::language {
namespace {

std::string Join(const std::set<std::string>& words, std::size_t most = 6) {
  std::string text;
  std::size_t told = 0;
  for (const std::string& word : words) {
    if (told++ == most) return text + " and " + std::to_string(words.size() - most) + " more";
    text += (text.empty() ? "`" : ", `") + (word.empty() ? "any" : word) + "`";
  }
  return text;
}

const explain::RuleText* FindRule(const Program& program, const std::string& name) {
  for (const std::shared_ptr<const Document>& document : program.documents)
    for (const DocumentCommand& command : document->commands())
      for (const explain::RuleText& text : command.read->texts)
        if (text.name == name) return &text;
  return nullptr;
}

std::string HoverRule(const Program& program, const std::string& name, const LastRun* run) {
  std::string text = "**rule** `" + name + "`";
  if (const explain::RuleText* rule = FindRule(program, name)) {
    if (!rule->proposes.empty()) text += "  \nproposes " + Join(rule->proposes);
    if (!rule->applies.empty()) text += "  \napplies " + Join(rule->applies);
    if (!rule->works_on.empty()) text += "  \nworks in a substate on " + Join(rule->works_on);
    if (!rule->says.empty()) text += "  \ngives the command " + Join(rule->says);
    std::set<std::string> made;
    for (const explain::RuleAttribute& action : rule->actions)
      if (action.attribute != "operator" && explain::IsConstantAttribute(action.attribute))
        made.insert("^" + action.attribute);
    if (!made.empty()) text += "  \nmakes " + Join(made);
    if (!rule->calls.empty()) text += "  \ncalls " + Join(rule->calls);
    text += "  \n" + std::to_string(rule->conditions.size()) + " conditions";
    // An element that a rule creates is not tested.
    if (!rule->actions.empty() || rule->calls.empty())
      text += ", " + std::to_string(rule->actions.size()) + " actions that make or remove elements";
  } else {
    text += "  \nthe kernel refuses it: see the problems";
  }
  if (run != nullptr)
    if (const std::string firings = TellFirings(*run, name); !firings.empty()) text += "  \n" + firings;
  return text;
}

std::string HoverCommand(const Name& name) {
  constexpr std::string_view kOutput = "io.output-link.";
  const std::size_t at = name.path.find(kOutput);
  if (at == std::string::npos) return {};
  const std::string below = name.path.substr(at + kOutput.size());
  const std::size_t dot = below.find('.');
  const vocabulary::CommandRow* command = vocabulary::FindCommand(below.substr(0, dot));
  if (command == nullptr) return {};
  if (dot == std::string::npos) {
    std::string text = "**command** `" + name.text + "`  \n" + std::string(command->meaning);
    for (const vocabulary::ParameterRow& one : command->parameters) {
      const std::string range = vocabulary::DescribeRange(one.unit, one.min, one.max, one.words);
      text += "  \n`^" + std::string(one.name) + "` " + std::string(one.meaning) +
              (range.empty() ? "" : " (" + range + ")");
    }
    if (!command->ends.empty()) text += "  \nIt is complete: " + std::string(command->ends);
    return text;
  }
  const auto tell = [&](const vocabulary::ParameterRow& one) {
    const std::string range = vocabulary::DescribeRange(one.unit, one.min, one.max, one.words);
    return "**parameter** of `" + std::string(command->name) + "`  \n" + std::string(one.meaning) +
           (range.empty() ? "" : "  \n" + range);
  };
  for (const vocabulary::ParameterRow& one : command->parameters)
    if (one.name == name.text) return tell(one);
  for (const vocabulary::ParameterRow& one : vocabulary::PlaceParameters())
    if (one.name == name.text) return tell(one);
  return {};
}

std::string HoverAttribute(const Program& program, const Document& document, const Name& name) {
  constexpr std::string_view kInput = "io.input-link.";
  if (const std::size_t at = name.path.find(kInput); at != std::string::npos) {
    const std::string path = name.path.substr(at + kInput.size());
    const std::string about = debugger::DescribePercept(path);
    if (!about.empty()) return "**percept** `" + path + "`  \n" + about;
  }
  if (std::string about = HoverCommand(name); !about.empty()) return about;
  std::set<std::string> made, tested;
  for (const Use& use : UsesOf(program, name, document.path())) {
    const Document* of = program.Find(use.file);
    const DocumentRule* rule = of == nullptr ? nullptr : of->RuleAt(use.span.begin);
    if (rule != nullptr) (use.defines ? made : tested).insert(rule->words->name);
  }
  std::string text = "**attribute** `^" + name.text + "`";
  if (const std::string_view meaning = MeaningOfAttribute(name.text); !meaning.empty()) {
    text += "  \n" + std::string(meaning);
  } else if (explain::IsArchitectureAttribute(name.text)) {
    text += "  \nSoar knows this attribute";
  }
  if (!made.empty()) text += "  \nmade by " + Join(made);
  if (!tested.empty()) text += "  \ntested by " + Join(tested);
  if (made.empty() && !explain::IsArchitectureAttribute(name.text)) text += "  \nno rule makes it";
  return text;
}

std::string HoverOperator(const Program& program, const std::string& name) {
  std::set<std::string> proposes, applies;
  for (const std::shared_ptr<const Document>& document : program.documents)
    for (const DocumentCommand& command : document->commands())
      for (const explain::RuleText& rule : command.read->texts) {
        if (rule.proposes.contains(name)) proposes.insert(rule.name);
        if (rule.applies.contains(name)) applies.insert(rule.name);
      }
  std::string text = "**operator** `" + name + "`";
  text += proposes.empty() ? "  \nno rule proposes it" : "  \nproposed by " + Join(proposes);
  text += applies.empty() ? "  \nno rule applies it by name" : "  \napplied by " + Join(applies);
  return text;
}

std::string Seconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", seconds);
  return text;
}

}  // namespace

std::string TellFirings(const LastRun& run, const std::string& rule) {
  if (!run.has_firings) return {};
  const std::string in = " in " + run.file.filename().string();
  const auto found = run.rules.find(rule);
  if (found == run.rules.end()) return "never fired" + in;
  const LastRun::Firings& firings = found->second;
  if (firings.count == 1) return "fired once" + in + ", at " + Seconds(firings.first_s);
  return "fired " + std::to_string(firings.count) + " times" + in + ", from " + Seconds(firings.first_s) + " to " +
         Seconds(firings.last_s);
}

std::string Hover(const Program& program, const Document& document, const Name& name, const LastRun* run) {
  switch (name.kind) {
    case Name::Kind::kRule:
      return HoverRule(program, name.text, run);
    case Name::Kind::kOperator:
      return HoverOperator(program, name.text);
    case Name::Kind::kAttribute:
      return HoverAttribute(program, document, name);
    case Name::Kind::kVariable:
      if (name.path.starts_with('<'))
        return "**variable** `" + name.text + "`  \nno condition leads to it from a state";
      return "**variable** `" + name.text + "`  \n" + (name.path.empty() ? "the state" : "`^" + name.path + "`");
    case Name::Kind::kValue:
      return {};
  }
  return {};
}

}  // namespace soarbox::language
