// SPDX-License-Identifier: BSD-2-Clause
#include "sim/rule_surroundings.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>
#include <vector>

#include "diagnostics/read_text.h"
#include "sim/rule_text.h"

namespace soarbox::sim {
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

/// Every word that follows a ^ between --> and the next rule. Cruder than reading the rules, which may not load.
void AddMade(const std::string& text, std::set<std::string>& made) {
  for (std::size_t arrow = text.find("-->"); arrow != std::string::npos; arrow = text.find("-->", arrow + 3)) {
    const std::size_t end = std::min(text.find("\nsp", arrow), text.size());
    const std::string side = text.substr(arrow, end - arrow);
    for (std::size_t at = side.find('^'); at != std::string::npos; at = side.find('^', at + 1)) {
      const std::size_t stop = std::min(side.find_first_of(" \t\n()", at), side.size());
      made.insert(side.substr(at + 1, stop - at - 1));
    }
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
      AddMade(BlankComments(ReadText(file).value_or("")), around.made_by_rules);
    }
  }
  return around;
}

}  // namespace soarbox::sim
