// SPDX-License-Identifier: BSD-2-Clause
#include "cli/tokens.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace soarbox::cli {
namespace {

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool EndsCommand(char c) {
  return c == '\n' || c == ';';
}

/// The characters with a special meaning between braces.
constexpr std::array<bool, 256> kBraceCharacters = [] {
  std::array<bool, 256> table{};
  for (const char c : {'\\', '|', '#', '{', '}', '\n'}) table[static_cast<unsigned char>(c)] = true;
  return table;
}();

/// The index of the next character of kBraceCharacters, or the end. Tests eight characters at once. This test also
/// matches other control characters, ~ and non-ASCII characters; therefore, the character that it finds is tested
/// again.
std::size_t SkipOrdinary(std::string_view text, std::size_t at) {
  constexpr std::uint64_t kEach = 0x0101010101010101ull, kTop = kEach * 0x80;
  const auto has_zero = [](std::uint64_t bytes) { return (bytes - kEach) & ~bytes; };
  while (text.size() - at >= sizeof(std::uint64_t)) {
    std::uint64_t eight;
    std::memcpy(&eight, text.data() + at, sizeof(eight));
    const std::uint64_t control = (eight - kEach * 0x20) & ~eight;
    const std::uint64_t from_brace = (eight + kEach * (0x80 - '{')) | eight;
    const std::uint64_t found =
        (control | from_brace | has_zero(eight ^ kEach * '\\') | has_zero(eight ^ kEach * '#')) & kTop;
    if (found == 0) {
      at += sizeof(eight);
      continue;
    }
    if constexpr (std::endian::native == std::endian::little) {
      at += static_cast<std::size_t>(std::countr_zero(found)) / 8;  // The characters before are certainly ordinary.
    }
    if (kBraceCharacters[static_cast<unsigned char>(text[at])]) return at;
    ++at;
  }
  while (at < text.size() && !kBraceCharacters[static_cast<unsigned char>(text[at])]) ++at;
  return at;
}

bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

void CommandReader::Advance() {
  if (Peek() == '\n') {
    ++line_;
    column_ = 1;
  } else {
    ++column_;
  }
  ++position_;
}

void CommandReader::SkipComment() {
  while (!AtEnd() && Peek() != '\n') Advance();
}

/// Skips blanks, comments, and line ends after a backslash. Stops at the end of the command.
void CommandReader::SkipBlanksAndComments() {
  while (!AtEnd()) {
    const char c = Peek();
    if (IsBlank(c)) {
      Advance();
    } else if (c == '#') {
      SkipComment();
    } else if (c == '\\' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n') {
      Advance();
      Advance();
    } else {
      return;
    }
  }
}

CommandReader::Status CommandReader::Next(std::vector<Word>& words) {
  std::size_t count = 0;
  const auto end = [&] {
    words.resize(count);
    return count == 0 ? Status::kEnd : Status::kCommand;
  };
  while (true) {
    SkipBlanksAndComments();
    if (AtEnd()) return end();
    const char c = Peek();
    if (EndsCommand(c)) {
      Advance();
      if (count != 0) return end();
      continue;
    }
    if (count == words.size()) words.emplace_back();
    Word& word = words[count++];
    word.text.clear();
    if (c == '{' ? !ReadBraced(word) : c == '"' ? !ReadQuoted(word) : !ReadBare(word)) {
      words.clear();
      return Status::kError;
    }
  }
}

/// Reads the character after a backslash outside braces. The backslash is the current character.
void CommandReader::AppendEscape(std::string& out) {
  Advance();
  if (AtEnd()) {
    out += '\\';
    return;
  }
  const char c = Peek();
  Advance();
  switch (c) {
    case 'a':
      out += '\a';
      break;
    case 'b':
      out += '\b';
      break;
    case 'f':
      out += '\f';
      break;
    case 'n':
      out += '\n';
      break;
    case 'r':
      out += '\r';
      break;
    case 't':
      out += '\t';
      break;
    case 'v':
      out += '\v';
      break;
    case '\n':
      while (!AtEnd() && IsBlank(Peek())) Advance();
      out += ' ';
      break;
    default:
      out += c;
  }
}

bool CommandReader::ReadBare(Word& word) {
  const std::size_t start = position_;
  word.line = line_;
  word.column = column_;
  bool in_bars = Peek() == '|';
  while (!AtEnd()) {
    const char c = Peek();
    if (!in_bars && (IsBlank(c) || EndsCommand(c) || c == '#')) break;
    if (in_bars && c == '|' && !word.text.empty()) {
      // A word that begins with a bar ends with the next one.
      in_bars = false;
      word.text += c;
      Advance();
      break;
    }
    if (c == '\\') {
      if (!in_bars && position_ + 1 < text_.size() && text_[position_ + 1] == '\n') break;
      AppendEscape(word.text);
      continue;
    }
    word.text += c;
    Advance();
  }
  if (!in_bars) return true;
  const bool failed = Fail("unexpected eof", word, start);
  error_column_ = word.column;
  return failed;
}

bool CommandReader::ReadQuoted(Word& word) {
  const std::size_t start = position_;
  Advance();
  word.line = line_;
  word.column = column_;
  while (!AtEnd()) {
    const char c = Peek();
    if (c == '"') {
      Advance();
      return true;
    }
    if (c == '\\') {
      AppendEscape(word.text);
      continue;
    }
    word.text += c;
    Advance();
  }
  return Fail("unexpected eof", word, start);
}

// Rules are long texts between braces: ordinary characters are skipped quickly and copied in one piece.
bool CommandReader::ReadBraced(Word& word) {
  const std::size_t start = position_;
  Advance();
  word.line = line_;
  word.column = column_;
  std::size_t at = position_;
  std::size_t taken = at;                                               // Characters before it are already in the word.
  std::size_t line_start = at + 1 - static_cast<std::size_t>(column_);  // May be "negative": only differences are used.
  const auto take = [&](std::size_t end) { word.text.append(text_, taken, end - taken); };
  const auto begin_line = [&](std::size_t first) {
    ++line_;
    line_start = first;
  };
  const auto stop = [&](std::size_t end) {
    position_ = end;
    column_ = static_cast<int>(end - line_start) + 1;
  };
  int depth = 1;
  bool in_bars = false;
  for (; at < text_.size(); ++at) {
    at = SkipOrdinary(text_, at);
    if (at == text_.size()) break;
    switch (text_[at]) {
      case '\n':
        begin_line(at + 1);
        break;
      case '|':
        in_bars = !in_bars;
        break;
      case '\\':
        if (at + 1 == text_.size()) break;
        if (text_[at + 1] == '\n') {
          begin_line(at + 2);
          if (!in_bars) {
            take(at);
            word.text += ' ';
            taken = at + 2;
          }
        }
        ++at;
        break;
      case '#':
        if (in_bars) break;
        take(at);
        at = std::min(text_.find('\n', at), text_.size());
        taken = at;
        --at;
        break;
      case '{':
        depth += in_bars ? 0 : 1;
        break;
      default:  // }
        if (in_bars || --depth != 0) break;
        take(at);
        stop(at + 1);
        return true;
    }
  }
  stop(text_.size());
  return Fail("unexpected eof, unmatched opening brace", word, start);
}

bool CommandReader::Fail(std::string message, const Word& word, std::size_t start) {
  error_ = std::move(message);
  error_line_ = word.line;
  error_column_ = word.column - 1;
  error_start_ = start;
  return false;
}

void CommandReader::Recover() {
  position_ = error_start_;
  line_ = error_line_;
  column_ = error_column_;
  while (!AtEnd()) {
    SkipComment();
    if (AtEnd()) return;
    Advance();
    if (!AtEnd() && IsLetter(Peek())) return;
  }
}

std::string QuoteWord(std::string_view word) {
  bool plain = !word.empty() && word.front() != '{' && word.front() != '"';
  for (const char c : word) {
    if (IsBlank(c) || EndsCommand(c) || c == '#' || c == '|' || c == '\\') plain = false;
  }
  if (plain) return std::string(word);
  std::string out = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace soarbox::cli
