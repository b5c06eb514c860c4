// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/tokens.h"

namespace soarbox::cli {

enum class OptionArgument { kNone, kRequired, kOptional };

/// One option of a command: `-d N`, `--depth N`.
struct OptionSpec {
  char letter = 0;        ///< The short form; handlers identify the option by it.
  std::string_view name;  ///< The long form, without dashes.
  OptionArgument argument = OptionArgument::kNone;
  std::string_view help = {};  ///< One line for help texts.
};

struct ParsedOption {
  char letter = 0;
  std::optional<std::string> argument;
};

/// A parsed command line: options in the order written, and the other words.
struct ParsedWords {
  std::vector<ParsedOption> options;
  std::vector<Word> arguments;
  std::string error;  ///< Not empty: the line is wrong, and this says how.

  bool Has(char letter) const;
  /// The argument of the last such option; nothing if the option is absent or has no argument.
  std::optional<std::string> Argument(char letter) const;
};

/// Parses the words after the command's name.
///
/// `-x` is a short option, `-xyz` several of them, `--name` a long one (a unique prefix is sufficient); `--` ends the
/// options. A required argument is the next word, whatever it is; after an option in `-xyz`, it is a dash and the rest
/// of that word. An optional argument is the next word if that does not begin with a dash. A word of one character is
/// never an option. A negative number is an option only if the command has an option of its first digit.
/// `takes_negatives`: if false, negative numbers are parsed as options, as in Soar 9.6.3.
ParsedWords ParseOptions(std::span<const Word> words, std::span<const OptionSpec> specs, bool takes_negatives = true);

}  // namespace soarbox::cli
