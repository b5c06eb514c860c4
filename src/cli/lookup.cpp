// SPDX-License-Identifier: BSD-2-Clause
#include "cli/lookup.h"

#include <charconv>
#include <cmath>

#include "diagnostics/number_from_chars.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Symbol;

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::optional<IdentifierName> ParseIdentifierName(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  char letter = text.front();
  if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  if (letter < 'A' || letter > 'Z') return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return IdentifierName{letter, number};
}

bool IsContextVariable(std::string_view text) {
  for (const std::string_view name : {"<s>", "<o>", "<ss>", "<so>", "<sss>", "<sso>", "<ts>", "<to>"}) {
    if (text == name) return true;
  }
  return false;
}

Symbol FindIdentifier(const Agent& agent, std::string_view text) {
  if (IsContextVariable(text)) {
    const kernel::GoalStack& goals = agent.goals();
    const bool top = text[1] == 't';
    const bool wants_operator = text[text.size() - 2] == 'o';
    // <s> is the lowest state, <ss> the one above it, <sss> the one above that.
    std::size_t above = text.size() - 3;
    if (top) {
      above = goals.depth() == 0 ? 0 : goals.depth() - 1;
    }
    if (goals.depth() <= above) return {};
    const kernel::Goal& goal = goals.at(static_cast<kernel::GoalLevel>(goals.depth() - above));
    return wants_operator ? agent.OperatorOf(goal) : goal.id;
  }
  const std::optional<IdentifierName> name = ParseIdentifierName(text);
  const Symbol id = name ? agent.symbols().FindIdentifier(name->letter, name->number) : Symbol();
  if (!id || !agent.memory().identifier(id).live) return {};
  // A firing can keep an identifier of a removed state alive. It has no elements and is the value of none: for users,
  // it does not exist.
  const kernel::IdentifierRecord& record = agent.memory().identifier(id);
  const bool dropped = !record.is_goal && record.value_of == 0 && agent.memory().WmesOf(id).empty();
  return dropped && record.level > 1 ? Symbol() : id;
}

Symbol MakeConstant(Agent& agent, std::string_view text) {
  kernel::SymbolTable& symbols = agent.mutable_symbols();
  if (text.size() >= 2 && text.front() == '|' && text.back() == '|') {
    std::string content;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
      if (text[i] == '\\' && i + 2 < text.size()) ++i;
      content += text[i];
    }
    return symbols.String(content);
  }
  const std::size_t sign = !text.empty() && (text.front() == '+' || text.front() == '-') ? 1 : 0;
  bool digits = text.size() > sign;
  bool point = false;
  for (const char c : text.substr(sign)) {
    if (c == '.')
      point = true;
    else if (!IsDigit(c) && c != 'e' && c != 'E' && c != '-' && c != '+')
      digits = false;
  }
  if (digits && !point) {
    if (const auto integer = ParseInteger(text)) return symbols.Integer(*integer);
  }
  if (digits && point) {
    if (const auto number = ParseDouble(text)) return symbols.Float(*number);
  }
  return symbols.String(text);
}

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> ParseLeadingInteger(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\n')) text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data()) return std::nullopt;
  return value;
}

std::optional<double> ParseDouble(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = NumberFromChars(text, value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

}  // namespace soarbox::cli
