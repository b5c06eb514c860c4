// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_surroundings.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "diagnostics/read_text.h"
#include "explain/rule_text.h"

namespace soarbox::explain {
namespace {

namespace fs = std::filesystem;

void AddWords(const std::string& text, std::set<std::string>& words) {
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
}

/// Adds all attributes in a text, including those in paths: "^taste.sweet" contains two.
void AddAttributes(std::string_view text, std::set<std::string>& made) {
  for (std::size_t at = text.find('^'); at != std::string_view::npos; at = text.find('^', at + 1)) {
    std::string_view path = text.substr(at + 1, text.find_first_of(" \t\n(){}", at) - at - 1);
    while (!path.empty()) {
      const std::size_t dot = std::min(path.find('.'), path.size());
      made.emplace(path.substr(0, dot));
      path.remove_prefix(std::min(dot + 1, path.size()));
    }
  }
}

/// Adds the attributes of facts: those in the braces after "smem --add".
void AddRemembered(std::string_view text, Surroundings& around) {
  constexpr std::string_view kCommand = "smem ";
  for (std::size_t at = text.find(kCommand); at != std::string_view::npos; at = text.find(kCommand, at + 1)) {
    std::string_view line = text.substr(at + kCommand.size());
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with("--add") || line.starts_with("-a ") || line.starts_with("-a\t")) {
      AddAttributes(line.substr(0, line.find('}')), around.made_by_rules);
    } else {
      const std::string_view words = line.substr(0, line.find('\n'));
      around.has_database |= words.find(" path ") != std::string_view::npos;
    }
  }
}

/// Adds "bank left" and "bank right" for "^bank left right", if the words are constants.
void AddValues(std::string_view text, std::set<std::string>& made) {
  for (std::size_t at = text.find('^'); at != std::string_view::npos; at = text.find('^', at + 1)) {
    std::size_t word = std::min(text.find_first_of(" \t\r\n(){}", at), text.size());
    std::string_view attribute = text.substr(at + 1, word - at - 1);
    if (const std::size_t dot = attribute.rfind('.'); dot != std::string_view::npos) attribute.remove_prefix(dot + 1);
    while ((word = text.find_first_not_of(" \t\r\n", word)) != std::string_view::npos && text[word] != '^' &&
           text[word] != ')' && text[word] != '(') {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n()", word), text.size());
      made.insert(std::string(attribute) + " " + std::string(text.substr(word, end - word)));
      word = end;
    }
  }
}

/// Adds every attribute between --> and the next rule. It does not parse the rules, which may not load.
void AddMade(const std::string& text, Surroundings& around) {
  for (std::size_t arrow = text.find("-->"); arrow != std::string::npos; arrow = text.find("-->", arrow + 3)) {
    const std::size_t end = std::min(text.find("\nsp", arrow), text.size());
    AddAttributes(std::string_view(text).substr(arrow, end - arrow), around.made_by_rules);
    AddValues(std::string_view(text).substr(arrow, end - arrow), around.made_values);
  }
}

}  // namespace

Surroundings LookAround(const fs::path& folder, std::span<const fs::path> readable) {
  Surroundings around;
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
       it.increment(error))
    if (IsPlainFileBelow(it->path(), readable)) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    if (file.extension() == ".lua") {
      AddWords(ReadText(file).value_or(""), around.lua_words);
    } else if (file.extension() == ".soar") {
      const std::string text = BlankComments(ReadText(file).value_or(""));
      AddMade(text, around);
      AddRemembered(text, around);
    }
  }
  return around;
}

}  // namespace soarbox::explain
