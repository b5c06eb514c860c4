// SPDX-License-Identifier: BSD-2-Clause
#include "language/complete.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "cli/command.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::language {
namespace {

using What = Proposal::Kind;

bool EndsWord(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("(){}^").find(c) != std::string_view::npos;
}

/// "superstate.superstate.io" and "io" are the same kind of object.
std::string_view Kindly(std::string_view path) {
  constexpr std::string_view kAbove = "superstate.";
  while (path.starts_with(kAbove)) path.remove_prefix(kAbove.size());
  return path == "superstate" ? std::string_view() : path;
}

std::string_view LastStep(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string_view Parent(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

class Completer {
 public:
  Completer(const Program& program, const Document& document) : program_(program), document_(document) {}

  Proposals At(std::size_t offset) {
    const std::string& text = document_.text();
    std::size_t begin = offset;
    while (begin > 0 && !EndsWord(text[begin - 1])) --begin;
    const DocumentRule* rule = RuleBefore(offset);
    if (rule == nullptr) {
      found_.replaced = {begin, offset};
      if (text.substr(document_.lines().Begin(document_.lines().LineOf(begin)),
                      begin - document_.lines().Begin(document_.lines().LineOf(begin)))
              .find_first_not_of(" \t") == std::string::npos)
        AddSoarCommands();
      return std::move(found_);
    }
    if (begin < offset && text[begin] == '<' && text.substr(begin, offset - begin).find('>') == std::string::npos) {
      found_.replaced = {begin, offset};
      AddVariables(*rule);
      return std::move(found_);
    }
    // Parse only up to here, because the rest may be incomplete.
    const RuleWords words = ReadWords(std::string_view(text).substr(rule->span.begin, offset - rule->span.begin));
    const RuleWords& whole = *rule->words;
    if (begin > 0 && text[begin - 1] == '^') {
      const std::size_t dot = text.substr(begin, offset - begin).rfind('.');
      const std::size_t from = dot == std::string::npos ? begin : begin + dot + 1;
      found_.replaced = {from, offset};
      AddAttributes(ObjectAt(words, whole, begin, from, rule->span.begin));
      return std::move(found_);
    }
    found_.replaced = {begin, offset};
    if (begin > 0 && text[begin - 1] == '(' && words.arrow != std::string::npos) {
      AddFunctions();
      AddVariables(*rule);
      return std::move(found_);
    }
    AddValues(words, begin - rule->span.begin);
    AddVariables(*rule);
    return std::move(found_);
  }

 private:
  const DocumentRule* RuleBefore(std::size_t offset) const {
    const DocumentRule* last = nullptr;
    for (const DocumentRule& rule : document_.rules())
      if (rule.span.begin < offset) last = &rule;
    if (last == nullptr || offset > last->span.end) return nullptr;
    // The rule ends after its last bracket.
    int depth = 0;
    const std::string& code = document_.code();
    for (std::size_t at = last->span.begin; at < std::min(offset, code.size()); ++at) {
      if (code[at] == '{') ++depth;
      if (code[at] == '}' && --depth == 0) return nullptr;
    }
    return last;
  }

  /// Returns the path of the object whose attribute is typed at `from`; the ^ is before `begin`.
  static std::string ObjectAt(const RuleWords& words, const RuleWords& whole, std::size_t begin, std::size_t from,
                              std::size_t rule) {
    if (from > begin) {
      // The part before the dot.
      for (auto word = words.words.rbegin(); word != words.words.rend(); ++word)
        if (word->span.end + rule == from - 1) return word->path;
    }
    // The clause's variable is the last one after a bracket.
    std::string head;
    for (const Word& word : words.words) {
      if (word.kind == WordKind::kVariable && word.span.end + rule < begin) {
        const auto known = whole.paths.find(word.text);
        if (IsHead(words, word)) head = known == whole.paths.end() ? word.text : known->second;
      }
    }
    return head;
  }

  static bool IsHead(const RuleWords& words, const Word& word) { return words.heads.contains(word.span.begin); }

  void Add(What kind, std::string text, std::string detail, std::string about) {
    if (!told_.insert(text).second) return;
    found_.list.push_back({kind, std::move(text), std::move(detail), std::move(about)});
  }

  void AddAttributes(const std::string& path) {
    const std::string_view kind = Kindly(path);
    constexpr std::string_view kInput = "io.input-link", kOutput = "io.output-link";
    if (kind.starts_with(kInput)) {
      const std::string_view below = kind.size() > kInput.size() ? kind.substr(kInput.size() + 1) : std::string_view();
      for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) {
        if (Parent(row.path) != below) continue;
        Add(What::kPercept, std::string(row.Attribute()), DescribeRow(row), std::string(row.meaning));
      }
    } else if (kind == kOutput) {
      for (const vocabulary::CommandRow& row : vocabulary::Commands())
        Add(What::kCommand, std::string(row.name), "command", std::string(row.meaning));
    } else if (kind.starts_with(kOutput) && Parent(kind) == kOutput) {
      AddParameters(LastStep(kind));
    }
    if (kind.empty()) {
      for (const char* one : {"io", "operator", "superstate", "impasse", "attribute", "choices", "item", "type", "name",
                              "reward-link", "smem", "epmem", "quiescence", "item-count", "non-numeric"})
        Add(What::kAttribute, one, "Soar", "");
    } else if (kind == "io") {
      Add(What::kAttribute, "input-link", "Soar", "What the agent perceives");
      Add(What::kAttribute, "output-link", "Soar", "The commands that it gives");
    } else if (LastStep(kind) == "operator") {
      Add(What::kAttribute, "name", "Soar", "The operator's name");
    }
    std::map<std::string, int> same, any;
    for (const std::shared_ptr<const Document>& document : program_.documents)
      for (const DocumentRule& rule : document->rules())
        for (const Word& word : rule.words->words) {
          if (word.kind != WordKind::kAttribute || word.text.empty()) continue;
          ++any[word.text];
          const std::string_view parent = Kindly(Parent(word.path));
          // Objects that are values of the same attribute count as one kind.
          if (parent == kind ||
              (!kind.empty() && LastStep(parent) == LastStep(kind) && !LastStep(kind).starts_with('<')))
            ++same[word.text];
        }
    AddCounted(same.empty() ? any : same);
  }

  void AddCounted(const std::map<std::string, int>& counts) {
    for (const auto& [text, count] : counts)
      Add(What::kAttribute, text, "used " + std::to_string(count) + (count == 1 ? " time" : " times"), "");
  }

  static std::string DescribeRow(const vocabulary::PerceptRow& row) {
    const std::string range = vocabulary::DescribeRange(row.unit, row.min, row.max, row.words);
    return range.empty() ? std::string(vocabulary::NameOf(row.type)) : range;
  }

  void AddParameters(std::string_view command) {
    const vocabulary::CommandRow* row = vocabulary::FindCommand(command);
    if (row == nullptr) return;
    const auto add = [&](const vocabulary::ParameterRow& one) {
      Add(What::kCommand, std::string(one.name), vocabulary::DescribeRange(one.unit, one.min, one.max, one.words),
          std::string(one.meaning));
    };
    for (const vocabulary::ParameterRow& one : row->parameters) add(one);
    if (row->place != vocabulary::TakesPlace::kNo)
      for (const vocabulary::ParameterRow& one : vocabulary::PlaceParameters()) add(one);
    Add(What::kCommand, "status", "one of: complete error interrupted", "How the command went");
    Add(What::kCommand, "reason", "", "Why it did not go as it should");
  }

  void AddValues(const RuleWords& words, std::size_t begin) {
    const Word* attribute = nullptr;
    for (const Word& word : words.words)
      if (word.kind == WordKind::kAttribute && word.span.end <= begin) attribute = &word;
    if (attribute == nullptr) return;
    const std::string_view path = Kindly(attribute->path);
    if (path == "operator.name" || path.ends_with(".operator.name")) {
      for (const std::shared_ptr<const Document>& document : program_.documents)
        for (const DocumentRule& rule : document->rules())
          for (const Word& word : rule.words->words)
            if (IsOperatorName(word)) Add(What::kOperator, word.text, "operator", "");
    }
    constexpr std::string_view kInput = "io.input-link.", kOutput = "io.output-link.";
    if (path.starts_with(kInput))
      for (const vocabulary::PerceptRow& row : vocabulary::Percepts())
        if (row.path == path.substr(kInput.size())) AddWords(row.words, row.meaning);
    if (path.starts_with(kOutput)) {
      const vocabulary::CommandRow* row = vocabulary::FindCommand(Parent(path.substr(kOutput.size())));
      if (row != nullptr)
        for (const vocabulary::ParameterRow& one : row->parameters)
          if (one.name == attribute->text) AddWords(one.words, one.meaning);
      if (attribute->text == "status") AddWords("complete error interrupted", "");
    }
    for (const std::shared_ptr<const Document>& document : program_.documents)
      for (const DocumentRule& rule : document->rules())
        for (const Word& word : rule.words->words)
          if (word.kind == WordKind::kValue && LastStep(word.path) == attribute->text)
            Add(What::kValue, word.text, "", "");
  }

  void AddWords(std::string_view words, std::string_view about) {
    while (!words.empty()) {
      const std::size_t blank = std::min(words.find(' '), words.size());
      if (blank > 0) Add(What::kValue, std::string(words.substr(0, blank)), "", std::string(about));
      words.remove_prefix(std::min(blank + 1, words.size()));
    }
  }

  void AddVariables(const DocumentRule& rule) {
    for (const Word& word : rule.words->words)
      if (word.kind == WordKind::kVariable)
        Add(What::kVariable, word.text, word.path.starts_with('<') ? "" : word.path.empty() ? "state" : word.path, "");
  }

  void AddFunctions() {
    for (const char* name : {"write",
                             "crlf",
                             "halt",
                             "interrupt",
                             "make-constant-symbol",
                             "capitalize-symbol",
                             "abs",
                             "div",
                             "mod",
                             "min",
                             "max",
                             "sqrt",
                             "sin",
                             "cos",
                             "atan2",
                             "int",
                             "float",
                             "round-off",
                             "cmd",
                             "exec",
                             "log",
                             "concat",
                             "strlen",
                             "ifeq",
                             "deep-copy",
                             "link-stm-to-ltm",
                             "rand-int",
                             "rand-float",
                             "dont-learn",
                             "force-learn",
                             "timestamp",
                             "wait",
                             "size",
                             "sum"})
      Add(What::kFunction, name, "function", "");
  }

  void AddSoarCommands() {
    for (const cli::CommandInfo& command : cli::Commands())
      Add(What::kSoarCommand, std::string(command.name), std::string(command.usage), std::string(command.summary));
    Add(What::kSoarCommand, "source", "FILE", "Load a file of rules");
  }

  const Program& program_;
  const Document& document_;
  Proposals found_;
  std::set<std::string> told_;
};

}  // namespace

Proposals Complete(const Program& program, const Document& document, std::size_t offset) {
  return Completer(program, document).At(std::min(offset, document.text().size()));
}

}  // namespace soarbox::language
