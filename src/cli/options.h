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
  char letter = 0;        ///< The short form, and how handlers know the option.
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
  /// The argument of the last such option; nothing if the option is absent or had none.
  std::optional<std::string> Argument(char letter) const;
};

/// Parses the words after the command's name.
///
/// `-x` is a short option, `-xyz` a cluster of them, `--name` a long one (a unique beginning suffices); `--` ends the
/// options. A required argument is the next word, whatever it is. An optional one is taken if the next word does not
/// begin with a dash. A word of one character is never an option, and neither is a negative number, unless the command
/// has an option of its first digit. `takes_negatives`: false reads them as options, as Soar 9.6.3 does.
ParsedWords ParseOptions(std::span<const Word> words, std::span<const OptionSpec> specs, bool takes_negatives = true);

}  // namespace soarbox::cli
