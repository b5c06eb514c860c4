// SPDX-License-Identifier: BSD-2-Clause
#include "explain/clarify_errors.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "diagnostics/read_text.h"
#include "explain/command_text.h"
#include "explain/former_soar.h"
#include "explain/kernel_error.h"
#include "explain/odd_characters.h"
#include "explain/rule_text.h"

namespace soarbox::explain {
namespace {

constexpr std::size_t kNowhere = std::string::npos;

struct SourceFile {
  std::vector<std::string> lines;  ///< The lines of the file.
  std::vector<std::string> code;   ///< The lines with comments blanked.

  const std::string& Line(int number) const {
    static const std::string kNone;
    return number >= 1 && number <= static_cast<int>(lines.size()) ? lines[static_cast<std::size_t>(number) - 1]
                                                                   : kNone;
  }
  const std::string& Code(int number) const {
    static const std::string kNone;
    return number >= 1 && number <= static_cast<int>(code.size()) ? code[static_cast<std::size_t>(number) - 1] : kNone;
  }
  int count() const { return static_cast<int>(lines.size()); }
};

std::vector<std::string> SplitLines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

SourceFile ReadSource(const std::string& text) {
  return {SplitLines(text), SplitLines(BlankComments(text))};
}

/// Whether a line begins with "sp {" or "gp {".
bool BeginsRule(const std::string& line) {
  return line.starts_with("sp {") || line.starts_with("sp{") || line.starts_with("gp {") || line.starts_with("gp{");
}

/// The name after a rule's opening brace, in this line or the next; empty if there is none.
std::string NameOfRule(const SourceFile& source, int line) {
  for (int at = line; at <= line + 1; ++at) {
    const std::string& text = source.Code(at);
    const std::size_t begin = text.find_first_not_of(" \t", at == line ? text.find('{') + 1 : 0);
    if (begin == kNowhere || text[begin] == '(') continue;
    return text.substr(begin, text.find_first_of(" \t(", begin) - begin);
  }
  return {};
}

/// The first line of the rule that contains `line`; 0 if no rule does.
int BeginOfRule(const SourceFile& source, int line) {
  for (int at = std::min(line, source.count()); at >= 1; --at)
    if (BeginsRule(source.Code(at))) return at;
  return 0;
}

/// The line after the rule that begins here: where the next rule begins, or the end of the file.
int EndOfRule(const SourceFile& source, int line) {
  int at = line + 1;
  while (at <= source.count() && !BeginsRule(source.Code(at))) ++at;
  return at;
}

void PointAt(Diagnostic& problem, const SourceFile& source, int line, std::size_t column, std::size_t length) {
  problem.line = line;
  problem.column = static_cast<int>(column) + 1;
  problem.excerpt = source.Line(line);
  problem.excerpt_length = static_cast<int>(length);
}

/// "The file ends within the rule": adds which rule, and what is not closed.
void ClarifyUnclosed(Diagnostic& problem, const SourceFile& source) {
  const int begin = BeginOfRule(source, problem.line);
  if (begin == 0) return;
  const int end = EndOfRule(source, begin);
  const std::string name = NameOfRule(source, begin);
  problem.line = begin;
  for (int at = begin; at < end; ++at) {
    const std::string& text = source.Code(at);
    if (std::count(text.begin(), text.end(), '|') % 2 == 0) continue;
    problem.message = "rule " + name + ": the text that starts here with | has no closing |";
    problem.hint = "close it with a second bar: |like this|";
    return PointAt(problem, source, at, text.rfind('|'), text.size() - text.rfind('|'));
  }
  problem.message = "rule " + name + " is not closed: } is missing";
  problem.hint = end <= source.count() ? "the next rule begins in line " + std::to_string(end) + "; put } before it"
                                       : "put } at its end";
}

/// Clarifies the error for a line outside rules that is not a command. Returns whether the line belongs to a rule, so
/// that the same mistake causes errors in the lines after it.
bool ClarifyCommand(Diagnostic& problem, const SourceFile& source, const KernelError& error) {
  const std::string line = Trimmed(source.Line(problem.line));
  const std::string word = line.substr(0, line.find_first_of(" \t{"));
  for (const char* mark : {"//", ";", "--", "/*", "%"}) {
    if (!line.starts_with(mark) || line.starts_with("-->")) continue;
    problem.message = std::string(mark) + " does not start a comment";
    problem.hint = "comments start with #";
    PointAt(problem, source, problem.line, source.Line(problem.line).find(mark), std::string_view(mark).size());
    return false;
  }
  if (line.starts_with('(') || line.starts_with("-->") || line.starts_with('}') || line.starts_with('^') ||
      line.starts_with("-(") || line.starts_with("-{")) {
    problem.message = "this line is outside any rule";
    problem.hint = "a rule is written sp {name conditions --> actions}; look at the brackets before this line";
    return true;
  }
  if (line.starts_with("sp{") || line.starts_with("gp{")) {
    problem.message = "a blank is missing between " + word + " and {";
    problem.hint = "write " + word + " " + line.substr(2);
    const std::size_t at = source.Line(problem.line).find_first_not_of(" \t");
    PointAt(problem, source, problem.line, at == kNowhere ? 0 : at, 3);
    return true;
  }
  if (line.find('{') != kNowhere && word != "sp" && word != "gp" && word.size() <= 6) {
    problem.message = "expected sp { here" + (word.empty() ? std::string() : ", found '" + word + "'");
    problem.hint = "a rule starts with sp {";
    const std::size_t at = source.Line(problem.line).find_first_not_of(" \t");
    PointAt(problem, source, problem.line, at == kNowhere ? 0 : at, std::max<std::size_t>(word.size(), 1));
    return false;
  }
  // The error for the line `quit` is "no such command 'exit'", because an alias is reported by its expansion.
  for (const std::string& name : {word, error.subject}) {
    const std::string now = FormerCommandHint(name);
    if (now.empty()) continue;
    problem.message = "Soar no longer has a command '" + word + "'";
    problem.hint = now;
    return false;
  }
  if (word == "indiff") {
    problem.message = "Soar no longer has a command 'indiff'";
    problem.hint = "it is indifferent-selection now: write indifferent-selection" + line.substr(word.size());
    return false;
  }
  const bool is_other_language = word == "if" || word == "when" || word == "then" || word == "rule";
  if (problem.hint.empty() || is_other_language) problem.hint = "a rule starts with sp {, a comment with #";
  return false;
}

/// Clarifies the error for "sp NAME" without a brace. Returns false if the line does not have this mistake. Kernels
/// read the lines after such a line as commands.
bool ClarifyMissingBrace(Diagnostic& problem, const SourceFile& source) {
  const std::string& line = source.Code(problem.line);
  if (!line.starts_with("sp ") && !line.starts_with("gp ")) return false;
  const std::string rest = Trimmed(line.substr(3));
  if (rest.empty() || rest.front() == '{' || rest.front() == '"') return false;
  if (rest.front() == '(') {
    problem.message = "a rule begins with sp {, not with sp (";
    problem.hint = "write sp {" + Trimmed(rest.substr(1));
    PointAt(problem, source, problem.line, line.find('('), 1);
    return true;
  }
  problem.message = "{ is missing after sp";
  problem.hint = "write sp {" + rest;
  PointAt(problem, source, problem.line, line.find(rest), rest.size());
  return true;
}

/// Clarifies the error for text after the closing brace of a rule: an additional brace, or another rule on the same
/// line.
void ClarifyTail(Diagnostic& problem, const SourceFile& source) {
  const std::string& first = source.Code(problem.line);
  if (first.find('\r') != kNowhere) {
    problem.message = "the lines of this file end with carriage returns alone";
    problem.hint = "save it with the line endings of Unix or Windows";
    return;
  }
  int depth = 0;
  bool is_quoted = false;
  for (int at = problem.line; at <= source.count(); ++at) {
    const std::string& text = source.Code(at);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '|') is_quoted = !is_quoted;
      if (is_quoted || (text[i] != '{' && text[i] != '}')) continue;
      depth += text[i] == '{' ? 1 : -1;
      if (depth > 0) continue;
      const std::size_t next = text.find_first_not_of(" \t", i + 1);
      if (next == kNowhere) return;
      const std::string name = NameOfRule(source, problem.line);
      problem.message = text[next] == '}'
                            ? "rule " + name + " has one } too many"
                            : "rule " + name + " is closed before this, and more follows in the same line";
      problem.hint = text[next] == '}' ? "remove it" : "begin the next rule in a line of its own";
      return PointAt(problem, source, at, next, 1);
    }
  }
}

bool BeginsComment(std::string_view found) {
  return found.starts_with("//") || found.starts_with("/*") || found == ";" || found == "--";
}

/// Verbs with which actions begin in other rule languages: "(make <s> ^x y)".
bool IsVerbOfOtherLanguages(std::string_view word) {
  return word == "make" || word == "modify" || word == "add" || word == "assert" || word == "remove" || word == "set";
}

/// The hint for text at the beginning of an action.
std::string HintForAction(const std::string& found) {
  if (found == "^") return "write attributes between ( and ), after the object that has them: (<s> ^attribute value)";
  if (found == "-") return "an action that removes an element ends with a minus: (<id> ^attribute value -)";
  if (BeginsComment(found)) return "comments start with #";
  if (found == "-->") return "a rule has one --> only";
  if (found == "else") return "there is no else: write another rule, with the opposite condition";
  if (found == "halt" || found == "write" || found == "crlf")
    return "write it between brackets: " +
           (found == "write" ? std::string("(write |hello| (crlf))") : "(" + found + ")");
  return {};
}

/// The hint for text in place of an action's value.
std::string HintForValue(const std::string& found, const std::string& before) {
  if (found == "{") return "braces join the tests of a condition; in an action, write the value alone";
  if (found == "=") return "write the value directly after its ^attribute, without =";
  if (found == ">" || found == ">=" || found == "<=" || found == "<>")
    return "an action makes elements and compares nothing: write the value alone";
  if (found == ",") return "blanks separate values, not commas";
  if (const std::size_t last = before.find_last_of(" \t(");
      found.find_first_not_of("+-*/") == kNowhere && last != kNowhere && before.rfind('(') != kNowhere) {
    const std::string first = Trimmed(before.substr(before.rfind('(') + 1));
    if (!first.empty() && first.find(' ') == kNowhere) return "the sign comes first: (" + found + " " + first + " ...)";
  }
  // "(make <s> ^operator <o> +)"
  if (const std::size_t open_verb = before.rfind('('); found == "^" && open_verb != kNowhere) {
    const std::string clause = Trimmed(before.substr(open_verb + 1));
    const std::size_t blank = clause.find(' ');
    if (blank != kNowhere && IsVerbOfOtherLanguages(clause.substr(0, blank)))
      return "an action needs no " + clause.substr(0, blank) + ": write (" + Trimmed(clause.substr(blank)) +
             " ^attribute value), with a - at its end to remove";
  }
  // "(state <s> ^operator <o> +)"
  const std::size_t word = before.rfind("(state ");
  if (found == "^" && word != kNowhere && before.find(')', word) == kNowhere)
    return "the word state belongs in conditions only: write (" + Trimmed(before.substr(word + 7)) + " ^...";
  // "(<out> ^move-to ^waypoint gate)"
  if (const std::string clause = Trimmed(before.substr(before.rfind('(') == kNowhere ? 0 : before.rfind('(') + 1));
      found == "^" && clause.rfind('^') != kNowhere && clause.find(' ', clause.rfind('^')) == kNowhere)
    return "write a value after " + clause.substr(clause.rfind('^')) + ": (" + clause +
           " <new>) (<new> ^attribute value)";
  // "(<command ^waypoint": the variable is not closed.
  const std::size_t open = before.rfind('<');
  if (found == "^" && open != kNowhere && before.find('>', open) == kNowhere) {
    const std::string name = Trimmed(before.substr(open + 1));
    if (!name.empty() && name.find(' ') == kNowhere) return "a variable ends with >: <" + name + ">";
  }
  return {};
}

/// The hint for text in place of a constant or variable in a condition.
std::string HintForTest(const std::string& found, const std::string& before, const std::string& after) {
  const char last = before.empty() ? ' ' : before.back();
  if (found == ",") {
    const bool is_decimal = std::isdigit(static_cast<unsigned char>(last)) != 0 && !after.empty() &&
                            std::isdigit(static_cast<unsigned char>(after.front())) != 0;
    return is_decimal ? "write a decimal point, not a comma" : "blanks separate what a rule tests, not commas";
  }
  if (found == "=" && last == '!') return "not equal is written <>";
  if (found == "^" && last == '!') return "a negation is written with a minus: -^attribute value";
  if (last == '!') return "not equal is written <>: <> " + found;
  if (found == "^" && last == '^') return "write one ^ only";
  if (found == "." && last == '>')
    return "bind it in a condition of its own, and compare with that: (<s> ^near <n>) (<a> ^range < <n>)";
  if (found == "." && last == '^') return "the ^ comes first: ^io.input-link";
  if (found == ".") {
    const std::size_t begin = before.find_last_of(" \t(");
    const std::string word = before.substr(begin == kNowhere ? 0 : begin + 1);
    if (!word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0)
      return "did you mean ^" + word + "?";
  }
  const std::string tests = Trimmed(before);
  const std::size_t open = tests.rfind(" < ");
  if (found == "^" && tests.ends_with(" >") && open != kNowhere)
    return "a choice is written <<" + tests.substr(open + 2, tests.size() - open - 3) + ">>";
  if (const std::size_t end = before.find_last_not_of(" \t");
      found == "^" && end != kNowhere && (before[end] == '<' || before[end] == '>' || before[end] == '='))
    return "the attribute comes first, then the relation and the value: ^range > 5";
  return {};
}

/// The hint for text at the beginning or end of a condition: words that join conditions in other languages.
std::string HintForJoin(const std::string& found, bool is_within) {
  if (found == "not" || found == "NOT")
    return is_within ? "a negation is written with a minus: -^attribute value"
                     : "a negation is written with a minus: -(<id> ^attribute value)";
  if (found == "and" || found == "AND" || found == "&&") return "write conditions one after another, without " + found;
  if (found == "or" || found == "OR") return "write two rules, or a choice between values: << a b >>";
  return {};
}

/// "sp {my first rule": the name ends at the blank. Suggests a name without blanks; empty if that is not the mistake.
std::string NameOfWords(const SourceFile& source, const Diagnostic& problem, const std::string& found) {
  const std::string& line = source.Code(problem.line);
  if (!BeginsRule(line) || found.empty() || std::isalnum(static_cast<unsigned char>(found.front())) == 0) return {};
  const std::size_t begin = line.find('{') + 1;
  std::istringstream words(line.substr(begin, line.find('(', begin) - begin));
  std::string name;
  for (std::string word; words >> word;) name += (name.empty() ? "" : "*") + word;
  return name;
}

/// Clarifies the error if the rule contains a character that `find` finds; `find` returns its position in a line, or
/// kNowhere. The message is the rule's name, `verdict` and the text of `describe`. Returns false if there is no such
/// character.
bool ClarifyCharacter(Diagnostic& problem, const SourceFile& source, std::size_t (*find)(std::string_view),
                      OddCharacter (*describe)(std::string_view, std::size_t), std::string_view verdict) {
  const int begin = BeginOfRule(source, problem.line);
  if (begin == 0 || problem.severity != Severity::kError) return false;
  for (int at = begin; at < EndOfRule(source, begin) && at <= problem.line; ++at) {
    const std::size_t column = find(source.Code(at));
    if (column == kNowhere) continue;
    OddCharacter odd = describe(source.Code(at), column);
    if (odd.is_blank) continue;  // Parsers read it as a blank, so it causes no error.
    problem.message = "rule " + NameOfRule(source, begin) + std::string(verdict) + odd.message;
    problem.hint = std::move(odd.hint);
    const std::string_view character = std::string_view(source.Code(at)).substr(column, odd.length);
    PointAt(problem, source, at, column,
            static_cast<int>(std::ranges::count_if(character, [](char c) { return (c & 0xc0) != 0x80; })));
    return true;
  }
  return false;
}

/// Adds a hint to "expected ... but found ...": for common mistakes, and for syntax of other languages.
void ClarifyFound(Diagnostic& problem, const SourceFile& source, const KernelError& error) {
  using Expected = KernelError::Expected;
  const std::string& found = error.found;
  if (error.at_end && error.Expects(Expected::kConditionOrArrow))
    problem.hint = "write --> between the conditions and the actions";
  if (found.empty()) return;
  if (error.Expects(Expected::kCondition)) {
    if (const std::string name = NameOfWords(source, problem, found); !name.empty())
      problem.hint = "a rule's name has no blanks: sp {" + name;
  }
  if (error.Expects(Expected::kName)) problem.hint = "give it one: sp {scout*propose*go";
  const std::string& line = source.Code(problem.line);
  const std::size_t column = static_cast<std::size_t>(std::max(problem.column, 1)) - 1;
  const char before = column > 0 && column <= line.size() ? line[column - 1] : ' ';
  if (error.Expects(Expected::kConditionOrArrow)) {
    if (found.size() > 1 && found.find_first_not_of("-=>") == kNowhere)
      problem.hint = "write --> between the conditions and the actions";
    if (before == '[' || found.front() == '[') problem.hint = "write conditions between ( and )";
    if (found == ")") problem.hint = "there is one ) too many before this";
    if (found == "^")
      problem.hint = "write attributes between ( and ), after the object that has them: (<w> ^attribute value)";
  }
  if (error.ExpectsAttribute() && std::isalpha(static_cast<unsigned char>(found[0])) != 0)
    problem.hint = "did you mean ^" + found + "?";
  if (found == ")" && error.Expects(Expected::kValue)) problem.hint = "write a value after each ^attribute";
  const std::string head = line.substr(0, std::min(column, line.size()));
  const std::string tail = line.substr(std::min(column + found.size(), line.size()));
  std::string hint;
  if (error.Expects(Expected::kAction)) hint = HintForAction(found);
  if (error.Expects(Expected::kValue)) hint = HintForValue(found, head);
  if (error.Expects(Expected::kConditionOrArrow)) hint = HintForJoin(found, false);
  if (error.ExpectsAttribute()) hint = HintForJoin(found, true);
  // (state <s> ^danger -)
  if (const std::string before = Trimmed(head); found == ")" && before.ends_with(" -") && error.ExpectsAttribute()) {
    const std::size_t caret = before.rfind('^');
    if (caret != kNowhere) {
      const std::string attribute = before.substr(caret, before.find(' ', caret) - caret);
      hint = "a condition that must not hold has the minus before it: -" + attribute;
    }
  }
  if (found == "-" && error.Expects(Expected::kAttributeOfAction)) hint = HintForAction(found);
  if (found == "state" && error.Expects(Expected::kCondition))
    hint = "write each condition between ( and ): (state <s> ...)";
  if (error.Expects(Expected::kTest)) hint = HintForTest(found, head, tail);
  const bool is_comment = BeginsComment(found) || Trimmed(head).ends_with(';');  // The parser skips a semicolon.
  if (error.Expects(Expected::kConditionOrArrow) && is_comment && Trimmed(line).find_first_not_of("-> ") != kNowhere)
    hint = "comments start with #";
  if (!hint.empty()) {
    problem.hint = std::move(hint);
    return;
  }
  if (found[0] == '"')
    problem.hint = found.find_first_not_of("\"0123456789.-") == kNowhere && found.size() > 2
                       ? "write the number without quotes: " + found.substr(1, found.size() - 2)
                       : "write text between bars: |I am going|";
  if (found == "<") problem.hint = "write a variable without blanks: <o>";
  if (const std::string now = FormerSyntaxHint(found); !now.empty()) problem.hint = now;
  if (found != "^") return;
  // "( <o> ^" in place of a value: the bracket before it was never closed.
  const std::size_t open = line.rfind('(', column);
  if (open == kNowhere || line.find('<', open) > column) return;
  // "(<out> ^move-to (<command> ^waypoint gate))"
  const std::string outer = Trimmed(line.substr(0, open));
  if (const std::size_t attribute = outer.rfind('^');
      attribute != kNowhere && outer.find(' ', attribute) == kNowhere && outer.rfind('(') != kNowhere) {
    const std::string inner = Trimmed(line.substr(open + 1, column - open - 1));
    problem.hint = "objects cannot be nested: write " + outer.substr(outer.rfind('(')) + " " + inner + ") (" + inner +
                   " ^attribute value)";
    return;
  }
  for (int at = problem.line; at >= 1; --at) {
    const std::string& text = source.Code(at);
    const std::size_t last = text.find_last_not_of(" \t", at == problem.line && open > 0 ? open - 1 : kNowhere);
    if (last == kNowhere || (at == problem.line && (open == 0 || last >= open))) continue;
    if (text[last] == ')' || text.substr(0, last + 1).ends_with("-->")) return;
    problem.message = error.rule + "a ) is missing at the end of this line";
    problem.hint = "close each ( with a )";
    return PointAt(problem, source, at, last, 1);
  }
}

/// Whether a rule has no arrow. Its actions are then parsed as conditions, which causes further errors.
bool LacksArrow(const Diagnostic& problem, const SourceFile& source) {
  const int begin = BeginOfRule(source, problem.line);
  if (begin == 0 || problem.severity != Severity::kError) return false;
  for (int at = begin; at < EndOfRule(source, begin); ++at)
    if (source.Code(at).find("->") != kNowhere || source.Code(at).find("=>") != kNowhere) return false;
  return true;
}

/// "constant sate is used where only a variable can match": `state` is missing or misspelt.
void ClarifyState(Diagnostic& problem, const KernelError& error) {
  const std::string& word = error.subject;
  if (error.kind != KernelError::Kind::kConstantAsId || word.empty()) return;
  const std::size_t bracket = word.find('<');
  if (bracket != kNowhere && bracket > 0) {
    problem.hint = "a blank is missing: " + word.substr(0, bracket) + " " + word.substr(bracket);
  } else if (const std::string now = FormerSyntaxHint(word); !now.empty()) {
    problem.hint = now;
  } else if (!Suggest(word, {"state"}).empty()) {
    problem.hint = "did you mean state?";
  } else {
    problem.hint = "write <" + word + "> for an object that other conditions lead to";
  }
}

/// The likely reason of an unbound variable.
enum class Unbound : std::uint8_t {
  kOther,
  kNoFirstCondition,  ///< The rule has no condition on a state.
  kNotBound,          ///< No reason is known.
};

/// "the action (<op> ^name go +) uses a variable that no condition binds": adds which variable, where, and a similar
/// one.
Unbound ClarifyUnbound(Diagnostic& problem, const SourceFile& source, const KernelError& error) {
  const std::vector<std::string> used = VariablesIn(error.subject);
  if (used.empty()) return Unbound::kOther;
  const int begin = BeginOfRule(source, problem.line);
  if (begin == 0) return Unbound::kOther;
  const std::string name = NameOfRule(source, begin);
  std::string conditions;
  std::set<std::string> others;
  int arrow = begin;
  const int end = EndOfRule(source, begin);
  for (int at = begin; at < end; ++at) {
    for (std::string& variable : VariablesIn(source.Code(at))) others.insert(std::move(variable));
    if (source.Code(at).find("-->") != kNowhere && arrow == begin) arrow = at;
    if (arrow == begin) conditions += source.Code(at) + "\n";
  }
  const std::string& variable = used.front();
  others.erase(variable);
  for (int at = arrow; at < end; ++at) {
    const std::size_t column = source.Code(at).find("(" + variable);
    if (column == kNowhere) continue;
    PointAt(problem, source, at, column + 1, variable.size());
    break;
  }
  problem.message = "rule " + name + ": no condition binds " + variable + ", which this action is about";
  for (int at = arrow; at < end; ++at) {
    const std::string& text = source.Code(at);
    const std::size_t open = text.find('(');
    const std::string id = open == kNowhere ? "" : text.substr(open + 1, text.find_first_of(" \t)", open) - open - 1);
    if (!IsIdentifier(id)) continue;
    problem.hint = id + " is the name of one object in one run: write a variable that a condition binds, such as <s>";
    PointAt(problem, source, at, open + 1, id.size());
    return Unbound::kOther;
  }
  const std::string_view near = Suggest(variable, {others.begin(), others.end()});
  if (conditions.find("(state " + variable) == kNowhere && conditions.find("(state") == kNowhere) {
    problem.hint = "the rule's first condition is missing: (state " + variable + " ^superstate nil ...)";
    return Unbound::kNoFirstCondition;
  }
  if (!near.empty()) {
    problem.hint = "did you mean " + std::string(near) + "?";
    return Unbound::kOther;
  }
  problem.hint = "bind it in a condition, or let another action lead to it: (<s> ^attribute " + variable + ")";
  return Unbound::kNotBound;
}

}  // namespace

void ClarifyErrors(std::vector<Diagnostic>& problems) {
  ClarifyErrors(problems, [](const std::string& file) { return ReadText(file).value_or(""); });
}

void ClarifyErrors(std::vector<Diagnostic>& problems, const TextOfFile& text_of) {
  std::map<std::string, SourceFile> files;
  using Kind = KernelError::Kind;
  std::vector<Diagnostic> kept;
  Kind last = Kind::kOther;  // Of the last problem that was kept.
  Unbound last_unbound = Unbound::kOther;
  bool outside = false;  // The last problem was text outside rules. Such a problem after it is not reported.
  std::set<std::string> unbound_rules;
  for (Diagnostic& problem : problems) {
    if (problem.file.empty() || problem.line == 0) {
      kept.push_back(std::move(problem));
      last = Kind::kOther;
      last_unbound = Unbound::kOther;
      continue;
    }
    const auto [at, is_new] = files.try_emplace(problem.file);
    if (is_new) at->second = ReadSource(text_of(problem.file));
    const SourceFile& source = at->second;
    // The parser's excerpt has blanks in place of "sp {". The line of the file replaces it.
    const std::string& line = source.Line(problem.line);
    const std::size_t first = problem.excerpt.find_first_not_of(' ');
    if (first != kNowhere && first <= line.size() && line.substr(first).starts_with(problem.excerpt.substr(first)))
      problem.excerpt = line;
    const KernelError error = ReadKernelError(problem.message);
    // Skips the parser's second error about the same word.
    if (error.kind == Kind::kReadAsString && !error.subject.empty() && !kept.empty() &&
        kept.back().severity == Severity::kError && kept.back().line == problem.line &&
        kept.back().file == problem.file)
      continue;
    // Skips the parser's error about an unclosed text that was already reported.
    if (!kept.empty() && last == Kind::kNotClosed && kept.back().file == problem.file &&
        kept.back().line == problem.line && kept.back().column == problem.column)
      continue;
    const Unbound unbound_before = std::exchange(last_unbound, Unbound::kOther);
    if (error.kind == Kind::kNotClosed && problem.column > 0 &&
        static_cast<std::size_t>(problem.column) <= line.size() &&
        line[static_cast<std::size_t>(problem.column) - 1] == '"') {
      problem.hint = "write text between bars: |I am going|";
      kept.push_back(std::move(problem));
      last = error.kind;
      continue;
    }
    const bool was_outside = std::exchange(outside, false);
    Kind reported = error.kind;
    if (error.kind == Kind::kUnexpectedEnd) {
      ClarifyUnclosed(problem, source);
    } else if (error.kind == Kind::kNoSuchCommand || error.kind == Kind::kTooManyToPrint) {
      outside = ClarifyCommand(problem, source, error);
      if (outside && was_outside) continue;
    } else if (const std::string now = FormerOptionHint(source.Code(problem.line));
               error.kind == Kind::kNoSuchOption && !now.empty()) {
      problem.hint = now;
    } else if (error.kind == Kind::kNoFile) {
      const std::string& code = source.Code(problem.line);
      problem.hint = code.find('\'') != kNowhere   ? "write the name without quotes"
                     : code.find('\\') != kNowhere ? "write / between folders, not \\"
                                                   : "the name is relative to the folder of the file that sources it";
    } else if (error.kind == Kind::kNotARule && BeginsRule(source.Code(problem.line))) {
      ClarifyTail(problem, source);
    } else if (ClarifyMissingBrace(problem, source)) {
      outside = true;
      reported = Kind::kOther;
    } else if (error.kind == Kind::kUnboundAction) {
      const int begin = BeginOfRule(source, problem.line);
      last_unbound = ClarifyUnbound(problem, source, error);
      const bool is_new_rule = unbound_rules.insert(problem.file + ":" + std::to_string(begin)).second;
      if ((!is_new_rule && last_unbound == Unbound::kNoFirstCondition) ||
          (last_unbound == Unbound::kNotBound && unbound_before == Unbound::kNoFirstCondition)) {
        last_unbound = unbound_before;
        continue;
      }
    } else if (ClarifyCharacter(problem, source, FindPasted, DescribePasted, " cannot be read: ") ||
               ClarifyCharacter(problem, source, FindOddCharacter, DescribeOddCharacter, ": ")) {
      reported = Kind::kOther;
    } else {
      ClarifyState(problem, error);
      ClarifyFound(problem, source, error);
      if (LacksArrow(problem, source)) problem.hint = "write --> between the conditions and the actions";
    }
    kept.push_back(std::move(problem));
    last = reported;
  }
  problems = std::move(kept);
}

}  // namespace soarbox::explain
