// SPDX-License-Identifier: BSD-2-Clause
// Characters that editors and word processors substitute for others. A kernel's parser skips every character that is
// not ASCII as if it were a blank, unless it is between bars.
#include "explain/odd_characters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace soarbox::explain {
namespace {

/// How a character looks.
enum class Look : std::uint8_t { kSeen, kBlank, kUnseen };

struct LookAlike {
  std::string_view character, name, hint;
  Look look = Look::kSeen;
};

constexpr std::array kLookAlikes = {
    LookAlike{"\u00a0", "a no-break space", "replace it with a plain blank", Look::kBlank},
    LookAlike{"\u202f", "a no-break space", "replace it with a plain blank", Look::kBlank},
    LookAlike{"\u2007", "a no-break space", "replace it with a plain blank", Look::kBlank},
    LookAlike{"\u3000", "a wide blank", "replace it with a plain blank", Look::kBlank},
    LookAlike{"\u200b", "a blank without width", "remove it", Look::kUnseen},
    LookAlike{"\ufeff", "a byte order mark", "remove it", Look::kUnseen},
    LookAlike{"\u201c", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u201d", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u201e", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u2018", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u2019", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u00ab", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u00bb", "a typographic quote", "write text between bars: |hello|"},
    LookAlike{"\u2212", "a typographic minus", "write the - of the keyboard"},
    LookAlike{"\u2010", "a typographic hyphen", "write the - of the keyboard"},
    LookAlike{"\u2011", "a typographic hyphen", "write the - of the keyboard"},
    LookAlike{"\u2013", "a dash", "write the - of the keyboard"},
    LookAlike{"\u2014", "a dash", "write the - of the keyboard"},
    LookAlike{"\u2192", "an arrow", "write -->"},
    LookAlike{"\u27f6", "an arrow", "write -->"},
    LookAlike{"\u21d2", "an arrow", "write -->"},
    LookAlike{"\u2264", "a sign that rules do not have", "write <="},
    LookAlike{"\u2265", "a sign that rules do not have", "write >="},
    LookAlike{"\u2260", "a sign that rules do not have", "not equal is written <>"},
};

/// Character sequences that web pages contain instead of a character: escapes of Markdown and entities of HTML.
constexpr std::array kPasted = {
    LookAlike{"\\*", "*", {}},  LookAlike{"\\_", "_", {}},  LookAlike{"\\<", "<", {}},   LookAlike{"\\>", ">", {}},
    LookAlike{"&lt;", "<", {}}, LookAlike{"&gt;", ">", {}}, LookAlike{"&amp;", "&", {}}, LookAlike{"&quot;", "|", {}},
};

const LookAlike* PastedAt(std::string_view line, std::size_t at) {
  for (const LookAlike& each : kPasted)
    if (line.substr(at).starts_with(each.character)) return &each;
  return nullptr;
}

bool IsAscii(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

/// Number of bytes of the character that begins here.
std::size_t LengthAt(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
  return end - at;
}

constexpr std::string_view kEnds = " \t()^{}";

template <typename Fits>
std::size_t FindOutsideBars(std::string_view line, Fits fits) {
  bool is_quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '|') is_quoted = !is_quoted;
    if (!is_quoted && fits(at)) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::size_t FindOddCharacter(std::string_view line) {
  return FindOutsideBars(line, [&](std::size_t at) { return !IsAscii(line[at]); });
}

OddCharacter DescribeOddCharacter(std::string_view line, std::size_t at) {
  const std::size_t length = LengthAt(line, at);
  const std::string character(line.substr(at, length));
  for (const LookAlike& each : kLookAlikes) {
    if (each.character != character) continue;
    return {length,
            std::string(each.name) + (each.look == Look::kSeen ? " " + character : "") +
                " is skipped, as if it were not there",
            std::string(each.hint), each.look == Look::kBlank};
  }
  const std::size_t before = line.find_last_of(kEnds, at);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::string word(line.substr(begin, std::min(line.find_first_of(kEnds, at), line.size()) - begin));
  const bool is_variable = word.starts_with('<');
  return {
      length, "in " + word + ", " + character + " is skipped, which splits the word",
      is_variable
          ? "names of variables are made of the letters a to z, digits and - _ *"
          : "write it without " + character +
                (before == std::string_view::npos || line[before] == '{' ? "" : ", or between bars: |" + word + "|")};
}

std::size_t FindPasted(std::string_view line) {
  return FindOutsideBars(line, [&](std::size_t at) { return PastedAt(line, at) != nullptr; });
}

OddCharacter DescribePasted(std::string_view line, std::size_t at) {
  const LookAlike& pasted = *PastedAt(line, at);
  const std::string as(pasted.character), meant(pasted.name);
  return {as.size(), "it has " + as + ", which web pages write for " + meant, "write " + meant + " here and elsewhere"};
}

std::vector<Diagnostic> FindOddCharacters(const RuleFile& file) {
  constexpr std::size_t kMost = 20;
  std::vector<Diagnostic> found;
  std::string rule;
  int number = 0, depth = 0;
  bool awaits_name = false;
  std::string_view told;  // The character of the last warning about this rule; it is not reported twice in succession.
  const std::string_view text = file.text;
  for (std::size_t begin = 0; begin < text.size() && found.size() < kMost;) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const bool begins = line.size() > 2 && (line.starts_with("sp") || line.starts_with("gp")) &&
                        kEnds.find(line[2]) != std::string_view::npos;
    if (begins) depth = 0;
    if (begins || awaits_name) {
      const std::size_t name = line.find_first_not_of(" \t{", begins ? 2 : 0);
      awaits_name = name == std::string_view::npos;
      std::size_t stop = std::min(name, line.size());
      while (stop < line.size() && kEnds.find(line[stop]) == std::string_view::npos && IsAscii(line[stop])) ++stop;
      rule = awaits_name ? std::string() : std::string(line.substr(name, stop - name));
      told = {};
    }
    const int depth_before = depth;
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '|') is_quoted = !is_quoted;
      if (!is_quoted && (c == '{' || c == '}')) depth += c == '{' ? 1 : -1;
    }
    if (depth_before <= 0 && depth <= 0) continue;  // Outside rules.
    const std::size_t at = FindOddCharacter(line);
    if (at == std::string_view::npos || rule.empty()) continue;
    OddCharacter odd = DescribeOddCharacter(line, at);
    if (line.substr(at, odd.length) == told) continue;
    told = line.substr(at, odd.length);
    Diagnostic warning;
    warning.severity = Severity::kWarning;
    warning.file = file.file.string();
    warning.line = number;
    warning.column = static_cast<int>(at) + 1;
    warning.excerpt = line;
    warning.excerpt_length = 1;
    warning.message = "rule " + rule + ": " + odd.message;
    warning.hint = std::move(odd.hint);
    warning.rule = rule;
    found.push_back(std::move(warning));
  }
  return found;
}

}  // namespace soarbox::explain
