// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "language/workspace.h"

namespace soarbox::language {

/// What a name in a text names.
struct Name {
  enum class Kind : std::uint8_t { kRule, kVariable, kAttribute, kOperator, kValue } kind = Kind::kValue;
  std::string text;
  std::string path;  ///< Of attributes and values, see Word.
  Span span;         ///< In the file.
  Span rule;         ///< The rule that it stands in; empty outside of rules.
};
/// The name at an offset of a file, also right behind its last letter.
std::optional<Name> NameAt(const Document& document, std::size_t offset);

/// A place where a name stands.
struct Use {
  std::filesystem::path file;
  Span span;
  bool defines = false;  ///< A rule's own name, an action that makes the attribute, the first use of a variable.
};
/// All uses of a name in a program. Attributes are the same wherever they stand; variables are those of their rule.
std::vector<Use> UsesOf(const Program& program, const Name& name, const std::filesystem::path& file);
/// Where it is defined: for an operator, the rules that propose it; for a file that is sourced, its first character.
std::vector<Use> DefinitionsOf(const Program& program, const Document& document, std::size_t offset);

/// The uses to replace, and the text to put there, to rename something. Fails for names that the world or the
/// architecture gives, for names that are not allowed, and for those that are taken.
struct Renaming {
  std::vector<Use> uses;
  std::string text;
};
Result<Renaming> Rename(const Program& program, const Document& document, std::size_t offset, const std::string& to);
/// Why a name cannot be renamed; empty if it can.
std::string WhyNotRenamed(const Name& name);

}  // namespace soarbox::language
