// SPDX-License-Identifier: BSD-2-Clause
#include "cli/aliases.h"

#include <algorithm>

namespace soarbox::cli {
namespace {

struct BuiltIn {
  const char* name;
  const char* expansion;
};

constexpr BuiltIn kBuiltIn[] = {
    {"?", "help"},
    {"a", "alias"},
    {"add-wme", "wm add"},
    {"allocate", "debug allocate"},
    {"aw", "wm add"},
    {"c", "explain chunk"},
    {"capture-input", "save percepts"},
    {"chdir", "cd"},
    {"chunk-name-format", "chunk naming-style"},
    {"cli", "soar tcl"},
    {"clog", "output log"},
    {"command-to-file", "output command-to-file"},
    {"cs", "chunk stats"},
    {"ctf", "output command-to-file"},
    {"d", "run -d"},
    {"default-wme-depth", "output print-depth"},
    {"dir", "ls"},
    {"e", "run -e"},
    {"echo-commands", "output echo-commands"},
    {"ef", "explain formation"},
    {"ei", "explain identities"},
    {"es", "explain stats"},
    {"et", "explain explanation-trace"},
    {"ex", "production excise"},
    {"excise", "production excise"},
    {"fc", "production firing-counts"},
    {"firing-counts", "production firing-counts"},
    {"gds_print", "print --gds"},
    {"gp-max", "soar max-gp"},
    {"i", "explain instantiation"},
    {"indifferent-selection", "decide indifferent-selection"},
    {"inds", "decide indifferent-selection"},
    {"init", "soar init"},
    {"init-soar", "soar init"},
    {"internal-symbols", "debug internal-symbols"},
    {"interrupt", "soar stop"},
    {"is", "soar init"},
    {"load-library", "load library"},
    {"man", "help"},
    {"matches", "production matches"},
    {"max-chunks", "chunk max-chunks"},
    {"max-dc-time", "soar max-dc-time"},
    {"max-elaborations", "soar max-elaborations"},
    {"max-goal-depth", "soar max-goal-depth"},
    {"max-memory-usage", "soar max-memory-usage"},
    {"max-nil-output-cycles", "soar max-nil-output-cycles"},
    {"memories", "production memory-usage"},
    {"multi-attributes", "production optimize-attribute"},
    {"numeric-indifferent-mode", "decide numeric-indifferent-mode"},
    {"p", "print"},
    {"pbreak", "production break"},
    {"pc", "print --chunks"},
    {"port", "debug port"},
    {"predict", "decide predict"},
    {"production-find", "production find"},
    {"ps", "print --stack"},
    {"pw", "production watch"},
    {"pwatch", "production watch"},
    {"quit", "exit"},
    {"r", "run"},
    {"remove-wme", "wm remove"},
    {"replay-input", "load percepts"},
    {"rete-net", "load rete-network"},
    {"rn", "load rete-network"},
    {"rw", "wm remove"},
    {"s", "run 1"},
    {"select", "decide select"},
    {"set-default-depth", "output print-depth"},
    {"set-stop-phase", "soar stop-phase"},
    {"soarnews", "soar"},
    {"source", "load file"},
    {"srand", "decide srand"},
    {"ss", "soar stop"},
    {"st", "stats"},
    {"step", "run -d"},
    {"stop", "soar stop"},
    {"stop-soar", "soar stop"},
    {"tcl", "soar tcl"},
    {"time", "debug time"},
    {"timers", "soar timers"},
    {"topd", "pwd"},
    {"un", "alias -r"},
    {"unalias", "alias -r"},
    {"varprint", "print -v -d 100"},
    {"verbose", "trace -A"},
    {"version", "soar version"},
    {"w", "trace"},
    {"waitsnc", "soar wait-snc"},
    {"warnings", "output warnings"},
    {"watch", "trace"},
    {"watch-wmes", "wm watch"},
    {"wma", "wm activation"},
    {"wmes", "print -depth 0 -internal"},
    {"wt", "explain wm-trace"},
};

std::string Join(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    line += word;
  }
  return line;
}

}  // namespace

AliasTable::AliasTable() {
  for (const BuiltIn& alias : kBuiltIn) {
    CommandReader reader(alias.expansion);
    std::vector<Word> words;
    reader.Next(words);
    std::vector<std::string> expansion;
    for (Word& word : words) expansion.push_back(std::move(word.text));
    aliases_[alias.name] = std::move(expansion);
  }
}

void AliasTable::Expand(std::vector<Word>& words) const {
  if (words.empty()) return;
  const auto found = aliases_.find(words.front().text);
  if (found == aliases_.end()) return;
  const Word first = words.front();
  words.erase(words.begin());
  std::vector<Word> expansion;
  for (const std::string& text : found->second) expansion.push_back(Word{text, first.line, first.column});
  words.insert(words.begin(), expansion.begin(), expansion.end());
}

void AliasTable::Define(std::string name, std::vector<std::string> expansion) {
  aliases_[std::move(name)] = std::move(expansion);
}

void AliasTable::Remove(const std::string& name) {
  aliases_.erase(name);
}

std::string AliasTable::Expansion(const std::string& name) const {
  const auto found = aliases_.find(name);
  return found == aliases_.end() ? std::string() : Join(found->second);
}

std::vector<std::pair<std::string, std::string>> AliasTable::All() const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [name, expansion] : aliases_) all.emplace_back(name, Join(expansion));
  std::ranges::sort(all);
  return all;
}

}  // namespace soarbox::cli
