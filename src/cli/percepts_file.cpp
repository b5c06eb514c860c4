// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <cmath>

#include "cli/lookup.h"
#include "cli/percepts.h"

namespace soarbox::cli {
namespace {

constexpr std::string_view kFirstLine = "soarbox percepts 1";

/// Splits a line into words.
class LineReader {
 public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  std::string_view Word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t"));
    rest_.remove_prefix(word.size());
    return word;
  }

  /// Reads |text between bars|.
  bool Quoted(std::string& text) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    if (!rest_.starts_with('|')) return false;
    for (std::size_t i = 1; i < rest_.size(); ++i) {
      if (rest_[i] == '|') {
        rest_.remove_prefix(i + 1);
        return true;
      }
      char c = rest_[i];
      if (c == '\\' && ++i < rest_.size()) c = rest_[i] == 'n' ? '\n' : rest_[i] == 'r' ? '\r' : rest_[i];
      text += c;
    }
    return false;
  }

  bool Number(std::uint64_t& number) {
    const auto value = ParseInteger(Word());
    if (!value || *value < 0) return false;
    number = static_cast<std::uint64_t>(*value);
    return true;
  }

  bool AtEnd() { return Word().empty(); }

 private:
  std::string_view rest_;
};

/// Reads the part of a line after its cycle; else returns what was expected.
const char* ReadAction(LineReader& line, PerceptAction& action) {
  const std::string_view verb = line.Word();
  if (verb == "init") {
    action.kind = PerceptAction::Kind::kInit;
    return nullptr;
  }
  if (verb != "add" && verb != "remove") return "expected add, remove, init or end after the cycle";
  if (!line.Number(action.timetag) || action.timetag == 0) return "expected a time tag";
  if (verb == "remove") {
    action.kind = PerceptAction::Kind::kRemove;
    return nullptr;
  }
  action.parent = line.Word();
  if (!ParseIdentifierName(action.parent)) return "expected an identifier after the time tag";
  if (!line.Quoted(action.attribute) || action.attribute.empty()) return "expected an attribute between bars";
  const std::string_view kind = line.Word();
  if (kind == "string") {
    std::string text;
    if (!line.Quoted(text)) return "expected a text between bars";
    action.value = std::move(text);
    return nullptr;
  }
  const std::string_view word = line.Word();
  if (kind == "int") {
    const auto number = ParseInteger(word);
    if (!number) return "expected an integer";
    action.value = *number;
  } else if (kind == "float") {
    const auto number = ParseDouble(word);
    if (!number || std::isnan(*number)) return "expected a float";
    action.value = *number;
  } else if (kind == "id" || kind == "new") {
    if (!ParseIdentifierName(word)) return "expected an identifier as the value";
    action.value = PerceptAction::Identifier{std::string(word), kind == "new"};
  } else {
    return "expected int, float, string, id or new before the value";
  }
  return nullptr;
}

Diagnostic Problem(const std::string& file, int line, std::string message, std::string hint = {}) {
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.line = line;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  return diagnostic;
}

}  // namespace

Result<PerceptFile> ReadPercepts(std::string_view text, const std::string& name) {
  PerceptFile file;
  bool ended = false;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (content.ends_with('\r')) content.remove_suffix(1);
    const auto fail = [&](std::string message) { return Problem(name, number, std::move(message)); };
    if (content.find('\0') != std::string_view::npos) return fail("the line holds a zero byte");
    LineReader line(content);
    if (number == 1) {
      if (content == kFirstLine) continue;
      return Problem(name, 1, fmt::format("this is not a recording of input: its first line is not '{}'", kFirstLine),
                     "'save percepts --open FILE' records input");
    }
    if (number == 2) {
      std::uint64_t seed = 0;
      if (line.Word() != "seed" || !line.Number(seed) || seed > 0xFFFFFFFFu || !line.AtEnd()) {
        return fail("expected 'seed' and a number below 2^32");
      }
      file.seed = static_cast<std::uint32_t>(seed);
      continue;
    }
    if (content.empty() || content.front() == '#') continue;
    if (ended) return fail("something follows the end of the recording");
    PerceptAction action;
    action.line = number;
    if (!line.Number(action.cycle)) return fail("expected the number of a cycle");
    if (action.cycle < file.last_cycle) return fail("cycles must not go backwards");
    file.last_cycle = action.cycle;
    LineReader rest = line;
    if (rest.Word() == "end") {
      ended = true;
      if (!rest.AtEnd()) return fail("something is left over at the end of the line");
      continue;
    }
    if (const char* expected = ReadAction(line, action)) return fail(expected);
    if (!line.AtEnd()) return fail("something is left over at the end of the line");
    if (action.kind != PerceptAction::Kind::kInit) {
      if (action.cycle == 0) return fail("input enters in cycle 1 at the earliest");
      ++file.changes;
    }
    file.actions.push_back(std::move(action));
  }
  if (number < 2) {
    return Problem(name, number + 1, "the file ends before the recording begins",
                   "'save percepts --open FILE' records input");
  }
  return file;
}

// Recording -----------------------------------------------------------------------------------------------------------

namespace {

std::string Bars(std::string_view text) {
  std::string out = "|";
  for (const char c : text) {
    if (c == '|' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else if (c == '\r')
      out += "\\r";
    else
      out += c;
  }
  return out + "|";
}

}  // namespace

PerceptRecorder::PerceptRecorder(kernel::Agent& agent, const std::string& path)
    : agent_(agent), out_(path, std::ios::binary | std::ios::trunc) {
  if (!out_) return;
  seed_ = agent.random().Next32();
  agent.random().Seed(seed_);
  out_ << kFirstLine << "\nseed " << seed_ << '\n';
  agent.input().SetTap(this);
}

PerceptRecorder::~PerceptRecorder() {
  Close();
}

bool PerceptRecorder::Close() {
  if (agent_.input().tap() != this) return good();
  agent_.input().SetTap(nullptr);
  out_ << cycle_ << " end\n";
  out_.close();
  return good();
}

void PerceptRecorder::OnInputChange(const kernel::InputChange& change) {
  ++changes_;
  if (!change.added) {
    out_ << fmt::format("{} remove {}\n", cycle_, change.timetag);
    return;
  }
  const kernel::SymbolTable& symbols = std::as_const(agent_).symbols();
  std::string value;
  switch (change.value.kind()) {
    case kernel::SymbolKind::kInteger:
      value = fmt::format("int {}", symbols.IntegerValue(change.value));
      break;
    case kernel::SymbolKind::kFloat:
      value = fmt::format("float {}", symbols.FloatValue(change.value));
      break;
    case kernel::SymbolKind::kIdentifier:
      value = (change.new_identifier ? "new " : "id ") + ToString(symbols, change.value);
      break;
    default:
      value = "string " + Bars(symbols.Text(change.value));
      break;
  }
  out_ << fmt::format("{} add {} {} {} {}\n", cycle_, change.timetag, ToString(symbols, change.id),
                      Bars(ToString(symbols, change.attribute, false)), value);
}

void PerceptRecorder::OnInputReset() {
  out_ << cycle_ << " init\n";
}

}  // namespace soarbox::cli
