// SPDX-License-Identifier: BSD-2-Clause
#include "language/names.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "diagnostics/problem.h"
#include "explain/rule_text.h"
#include "sim/sourced_files.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::language {
namespace {

namespace fs = std::filesystem;

Name::Kind KindOf(const Word& word) {
  switch (word.kind) {
    case WordKind::kRuleName:
      return Name::Kind::kRule;
    case WordKind::kVariable:
      return Name::Kind::kVariable;
    case WordKind::kAttribute:
      return Name::Kind::kAttribute;
    case WordKind::kFunction:
      return Name::Kind::kValue;
    case WordKind::kValue:
      return IsOperatorName(word) ? Name::Kind::kOperator : Name::Kind::kValue;
  }
  return Name::Kind::kValue;
}

bool IsWordEnd(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("(){}\";,").find(c) != std::string_view::npos;
}

/// Adds names of rules outside of rules: "excise go*west".
void AddInCommands(const Document& document, const std::string& rule, std::vector<Use>& uses) {
  for (std::size_t at = document.code().find(rule); at != std::string::npos; at = document.code().find(rule, at + 1)) {
    const std::size_t end = at + rule.size();
    if (at > 0 && !IsWordEnd(document.code()[at - 1])) continue;
    if (end < document.code().size() && !IsWordEnd(document.code()[end])) continue;
    if (document.RuleAt(at) == nullptr) uses.push_back({document.path(), {at, end}, false});
  }
}

bool IsConstant(const std::string& text) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) != 0) return false;
  return std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_*$%&?/:").find(c) != std::string_view::npos;
  });
}

Diagnostic Refusal(std::string message, std::string hint = {}) {
  return NewProblem(std::move(message), std::move(hint));
}

bool IsCommandWord(const std::string& attribute, const std::string& path) {
  if (path.find("output-link.") == std::string::npos) return false;
  if (vocabulary::FindCommand(attribute) != nullptr) return true;
  const std::size_t begin = path.find("output-link.") + std::string_view("output-link.").size();
  return vocabulary::FindCommand(path.substr(begin, path.find('.', begin) - begin)) != nullptr;
}

}  // namespace

std::optional<Name> NameAt(const Document& document, std::size_t offset) {
  const DocumentRule* rule = document.RuleAt(offset);
  if (rule == nullptr) return std::nullopt;
  const std::size_t inside = offset - rule->span.begin;
  for (const Word& word : rule->words->words) {
    if (!word.span.Holds(inside)) continue;
    const Span span{rule->span.begin + word.span.begin, rule->span.begin + word.span.end};
    return Name{KindOf(word), word.text, word.path, span, rule->span};
  }
  return std::nullopt;
}

std::vector<Use> UsesOf(const Program& program, const Name& name, const fs::path& file) {
  std::vector<Use> uses;
  for (const std::shared_ptr<const Document>& document : program.documents) {
    if (name.kind == Name::Kind::kVariable && document->path() != file) continue;
    for (const DocumentRule& rule : document->rules()) {
      if (name.kind == Name::Kind::kVariable && rule.span != name.rule) continue;
      bool is_first = true;
      for (const Word& word : rule.words->words) {
        if (word.text != name.text || KindOf(word) != name.kind) continue;
        if (name.kind == Name::Kind::kValue && word.path != name.path) continue;
        bool defines = false;
        switch (name.kind) {
          case Name::Kind::kRule:
            defines = true;
            break;
          case Name::Kind::kVariable:
            defines = is_first;
            break;
          case Name::Kind::kAttribute:
            defines = word.in_actions;
            break;
          case Name::Kind::kOperator:
            defines = word.in_actions && word.path.ends_with("operator.name");
            break;
          case Name::Kind::kValue:
            defines = word.in_actions;
            break;
        }
        is_first = false;
        uses.push_back(
            {document->path(), {rule.span.begin + word.span.begin, rule.span.begin + word.span.end}, defines});
      }
    }
    if (name.kind == Name::Kind::kRule) AddInCommands(*document, name.text, uses);
  }
  return uses;
}

std::vector<Use> DefinitionsOf(const Program& program, const Document& document, std::size_t offset) {
  const std::optional<Name> name = NameAt(document, offset);
  if (!name) {
    const std::string_view line = document.lines().Line(document.lines().LineOf(offset));
    const std::string sourced = sim::NameSourcedBy(line);
    if (sourced.empty()) {
      // A rule that a command names.
      for (const std::shared_ptr<const Document>& one : program.documents)
        for (const DocumentRule& rule : one->rules()) {
          if (rule.words->name.empty()) continue;
          const std::size_t at = line.find(rule.words->name);
          const std::size_t column = offset - document.lines().Begin(document.lines().LineOf(offset));
          if (at == std::string_view::npos || column < at || column > at + rule.words->name.size()) continue;
          const Span& span = rule.words->name_span;
          return {{one->path(), {rule.span.begin + span.begin, rule.span.begin + span.end}, true}};
        }
      return {};
    }
    fs::path file = (document.path().parent_path() / sourced).lexically_normal();
    for (const Document::Sourced& one : document.sourced())
      if (one.line == static_cast<int>(document.lines().LineOf(offset)) + 1)
        file = (document.path().parent_path() / one.file).lexically_normal();
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {};
    return {{file, {0, 0}, true}};
  }
  std::vector<Use> uses = UsesOf(program, *name, document.path());
  std::erase_if(uses, [](const Use& use) { return !use.defines; });
  return uses;
}

std::string WhyNotRenamed(const Name& name) {
  if (name.kind == Name::Kind::kValue) return "only rules, variables, attributes and operators can be renamed";
  if (name.kind != Name::Kind::kAttribute) return {};
  if (explain::IsArchitectureAttribute(name.text)) return "Soar itself gives ^" + name.text + " its name";
  if (IsCommandWord(name.text, name.path))
    return "^" + name.text + " is part of a command, and bodies know it by this name";
  if (vocabulary::IsPerceptAttribute(name.text) && name.path.find("input-link") != std::string::npos)
    return "^" + name.text + " is a percept: the world gives it its name";
  return {};
}

Result<Renaming> Rename(const Program& program, const Document& document, std::size_t offset, const std::string& to) {
  const std::optional<Name> name = NameAt(document, offset);
  if (!name) return Refusal("there is no name here", "put the cursor on a rule's name, a variable or an attribute");
  if (std::string why = WhyNotRenamed(*name); !why.empty()) return Refusal(std::move(why));
  Renaming renaming;
  renaming.text = to;
  if (name->kind == Name::Kind::kVariable) {
    std::string bare = to;
    if (bare.size() > 2 && bare.front() == '<' && bare.back() == '>') bare = bare.substr(1, bare.size() - 2);
    if (!IsConstant("v" + bare) || bare.empty()) return Refusal("a variable is a name between < and >, such as <s>");
    renaming.text = "<" + bare + ">";
  } else if (name->kind == Name::Kind::kAttribute && to.starts_with('^')) {
    renaming.text = to.substr(1);
  }
  if (name->kind != Name::Kind::kVariable && !IsConstant(renaming.text))
    return Refusal("'" + to + "' is not a name", "use letters, digits, - and *, and begin with a letter");
  if (renaming.text == name->text) return Refusal("this is its name already");
  Name taken = *name;
  taken.text = renaming.text;
  const bool must_be_new = name->kind == Name::Kind::kVariable || name->kind == Name::Kind::kRule;
  if (must_be_new && !UsesOf(program, taken, document.path()).empty())
    return Refusal(renaming.text + " is taken", "two names would become one");
  renaming.uses = UsesOf(program, *name, document.path());
  if (name->kind == Name::Kind::kAttribute) {
    // The same word below the links belongs to the world and is unchanged.
    std::erase_if(renaming.uses, [&](const Use& use) {
      const Document* of = program.Find(use.file);
      const std::optional<Name> there = of == nullptr ? std::nullopt : NameAt(*of, use.span.begin + 1);
      return there && !WhyNotRenamed(*there).empty();
    });
  }
  // Keeps bars around names.
  for (Use& use : renaming.uses) {
    const Document* of = program.Find(use.file);
    if (of == nullptr || use.span.end - use.span.begin != name->text.size() + 2 || of->text()[use.span.begin] != '|')
      continue;
    ++use.span.begin;
    --use.span.end;
  }
  return renaming;
}

}  // namespace soarbox::language
