// SPDX-License-Identifier: BSD-2-Clause
#include "cli/options.h"

#include <algorithm>
#include <utility>

namespace soarbox::cli {
namespace {

const OptionSpec* FindLong(std::string_view name, std::span<const OptionSpec> specs, std::string& error) {
  std::vector<const OptionSpec*> found;
  for (const OptionSpec& spec : specs) {
    if (spec.name == name) return &spec;
    if (!spec.name.empty() && spec.name.starts_with(name)) found.push_back(&spec);
  }
  if (found.empty()) {
    error = "No such option: " + std::string(name);
    return nullptr;
  }
  const auto differs = [&](const OptionSpec* spec) { return spec->name != found.front()->name; };
  if (std::any_of(found.begin(), found.end(), differs)) {
    error = "Ambiguous option, possibilities: ";
    for (const OptionSpec* spec : found) error += "'--" + std::string(spec->name) + "' ";
    return nullptr;
  }
  return found.front();
}

const OptionSpec* FindShort(char letter, std::span<const OptionSpec> specs, std::string& error) {
  for (const OptionSpec& spec : specs) {
    if (spec.letter == letter) return &spec;
  }
  error = std::string("No such option: ") + letter;
  return nullptr;
}

/// Whether a word is a negative number and not an option: -5, -0.5, -1e3.
bool IsNegativeNumber(std::string_view word, std::span<const OptionSpec> specs) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (word.size() < 2 || word[0] != '-') return false;
  const std::size_t first = word[1] == '.' ? 2 : 1;
  if (first >= word.size() || !is_digit(word[first])) return false;
  if (word.find_first_not_of("0123456789.eE+-", first) != std::string_view::npos) return false;
  return std::none_of(specs.begin(), specs.end(), [&](const OptionSpec& spec) { return spec.letter == word[1]; });
}

}  // namespace

bool ParsedWords::Has(char letter) const {
  for (const ParsedOption& option : options) {
    if (option.letter == letter) return true;
  }
  return false;
}

std::optional<std::string> ParsedWords::Argument(char letter) const {
  std::optional<std::string> argument;
  for (const ParsedOption& option : options) {
    if (option.letter == letter) argument = option.argument;
  }
  return argument;
}

ParsedWords ParseOptions(std::span<const Word> words, std::span<const OptionSpec> specs, bool takes_negatives) {
  ParsedWords parsed;
  bool options_ended = false;
  std::string rest_of_cluster;  // The rest of a cluster is treated like the next word.
  std::size_t next = 0;
  const auto is_number = [&](std::string_view word) { return takes_negatives && IsNegativeNumber(word, specs); };
  const auto has_word = [&] { return !rest_of_cluster.empty() || next < words.size(); };
  const auto take_word = [&] {
    if (rest_of_cluster.empty()) return words[next++].text;
    return std::exchange(rest_of_cluster, {});
  };

  while (has_word()) {
    const std::size_t index = next;
    const bool from_cluster = !rest_of_cluster.empty();
    const std::string word = take_word();
    if (options_ended || word.size() < 2 || word[0] != '-' || (!from_cluster && is_number(word))) {
      parsed.arguments.push_back(words[index]);
      continue;
    }
    const OptionSpec* spec = nullptr;
    if (word[1] == '-' && !from_cluster) {
      if (word.size() == 2) {
        options_ended = true;
        continue;
      }
      spec = FindLong(std::string_view(word).substr(2), specs, parsed.error);
    } else {
      spec = FindShort(word[1], specs, parsed.error);
      if (word.size() > 2) rest_of_cluster = "-" + word.substr(2);
    }
    if (!spec) return parsed;

    ParsedOption option{spec->letter, std::nullopt};
    if (spec->argument == OptionArgument::kRequired) {
      if (!has_word()) {
        parsed.error = "Option '" + std::string(spec->name) + "' requires an argument.";
        return parsed;
      }
      option.argument = take_word();
    } else if (spec->argument == OptionArgument::kOptional && rest_of_cluster.empty() && next < words.size() &&
               (!words[next].text.starts_with('-') || is_number(words[next].text))) {
      option.argument = take_word();
    }
    parsed.options.push_back(std::move(option));
  }
  return parsed;
}

}  // namespace soarbox::cli
