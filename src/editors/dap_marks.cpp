// SPDX-License-Identifier: BSD-2-Clause
// Breakpoints with a condition, and log points, which print a line and do not stop.
#include <algorithm>
#include <array>
#include <string_view>

#include "debugger/watch.h"
#include "diagnostics/number_from_chars.h"
#include "diagnostics/wildcard.h"
#include "editors/dap_server.h"
#include "editors/dap_words.h"
#include "explain/command_text.h"

namespace soarbox::editors {
namespace {

/// A comparison of the values of a path: "io.input-link.self.health < 50". If `op` is empty, the condition holds if the
/// path has a value.
struct MarkCondition {
  std::string path, op, value;
};

MarkCondition ReadMarkCondition(const std::string& text) {
  // The blanks distinguish an operator from the variable <s> in a path.
  constexpr std::array<std::string_view, 7> kOperators = {" == ", " != ", " <= ", " >= ", " = ", " < ", " > "};
  for (const std::string_view op : kOperators)
    if (const std::size_t at = text.find(op); at != std::string::npos)
      return {explain::Trimmed(text.substr(0, at)), explain::Trimmed(op),
              explain::Trimmed(text.substr(at + op.size()))};
  return {explain::Trimmed(text), {}, {}};
}

bool IsNumberText(const std::string& text, double& number) {
  const auto read = NumberFromChars(text, number);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

bool Compare(const std::string& left, const std::string& op, const std::string& right) {
  double a = 0, b = 0;
  const bool are_numbers = IsNumberText(left, a) && IsNumberText(right, b);
  const bool is_equal = are_numbers ? a == b : left == right;
  if (op == "=" || op == "==") return is_equal;
  if (op == "!=") return !is_equal;
  if (!are_numbers) return false;
  return op == "<" ? a < b : op == "<=" ? a <= b : op == ">" ? a > b : a >= b;
}

/// Whether the condition holds for at least one of the values. Blanks and line ends separate them.
bool Holds(const MarkCondition& condition, const std::string& values) {
  if (condition.op.empty()) return !values.empty();
  for (std::size_t begin = 0; begin < values.size();) {
    const std::size_t end = std::min(values.find_first_of(" \n", begin), values.size());
    if (end > begin && Compare(values.substr(begin, end - begin), condition.op, condition.value)) return true;
    begin = end + 1;
  }
  return false;
}

/// Replaces each {expression} by what `evaluate` returns for it.
template <typename Evaluate>
std::string Interpolated(const std::string& text, const Evaluate& evaluate) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('{', at);
    const std::size_t close = open == std::string::npos ? open : text.find('}', open);
    if (close == std::string::npos) return line + text.substr(at);
    line += text.substr(at, open - at) + evaluate(text.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return line;
}

}  // namespace

std::string DapServer::FaultOfCondition(const std::string& condition) {
  return condition.empty() ? std::string() : debugger::WatchFault(ReadMarkCondition(condition).path);
}

void DapServer::Log(const std::string& line, const std::filesystem::path& file, std::size_t at) {
  Event("output", {{"category", "console"},
                   {"output", line + "\n"},
                   {"source", {{"name", file.filename().string()}, {"path", file.string()}}},
                   {"line", at}});
}

bool DapServer::StopsFor(const StopReason& reason) {
  if (reason.rule.empty()) return true;
  for (const StopWish& wish : wishes_)
    if (wish.kind == "fire" && (wish.what == reason.rule || IsLikePattern(reason.rule, wish.what))) return true;
  for (const auto& entry : marks_) {
    for (const Mark& mark : entry.second) {
      if (mark.rule != reason.rule) continue;
      const std::unique_ptr<explain::Inspector> mind = debuggee_->Inspect(reason.agent);
      const auto value_of = [&](const std::string& path) {
        const debugger::WatchValue value =
            mind == nullptr ? debugger::WatchValue() : debugger::LookAtWatch(*mind, explain::Trimmed(path));
        return value.is_error ? std::string() : value.text;
      };
      if (!mark.condition.empty()) {
        const MarkCondition condition = ReadMarkCondition(mark.condition);
        if (!Holds(condition, value_of(condition.path))) continue;
      }
      if (mark.log.empty()) return true;
      Log(Interpolated(mark.log, value_of), mark.file, mark.line);
    }
  }
  return false;
}

bool DapServer::StopsInScript(std::uint32_t owner) {
  std::vector<script::ScriptFrame> calls;
  debuggee_->Scripts()->With([&](script::ScriptDebugger& scripts) { calls = scripts.view().Frames(); });
  if (calls.empty()) return true;
  const auto log = script_logs_.find({calls.front().file, calls.front().line});
  if (log == script_logs_.end()) return true;
  const auto value_of = [&](const std::string& expression) {
    try {
      return EvaluateInScript(owner, 0, explain::Trimmed(expression), false).at("result").get<std::string>();
    } catch (const DapRefusal& refused) {
      return "{" + refused.message + "}";
    }
  };
  Log(Interpolated(log->second, value_of), calls.front().file, static_cast<std::size_t>(calls.front().line));
  return false;
}

bool DapServer::StopsFor(const StopReasons& reasons) {
  if (const std::optional<std::uint32_t> script = PausedScript())
    return reasons.size() != 1 || reasons.front().kind != StopReason::Kind::kScriptLine || StopsInScript(*script);
  // The loop does not end at the first `true`, because a later reason may be a log point, which must print.
  bool stops = false;
  for (const StopReason& reason : reasons) stops |= StopsFor(reason);
  return stops;
}

}  // namespace soarbox::editors
