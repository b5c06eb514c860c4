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

/// A name in a text.
struct Name {
  enum class Kind : std::uint8_t { kRule, kVariable, kAttribute, kOperator, kValue } kind = Kind::kValue;
  std::string text;
  std::string path;  ///< For attributes and values, see Word.
  Span span;         ///< In the file.
  Span rule;         ///< The rule that contains it; empty outside rules.
};
/// The name at an offset of a file, or directly before it.
std::optional<Name> NameAt(const Document& document, std::size_t offset);

/// An occurrence of a name.
struct Use {
  std::filesystem::path file;
  Span span;
  bool defines = false;  ///< It is the name at the beginning of a rule, an action that makes the attribute, or the
                         ///< first use of a variable.
};
/// All uses of a name in a program. Equal attributes are the same name everywhere; variables belong to their rule.
std::vector<Use> UsesOf(const Program& program, const Name& name, const std::filesystem::path& file);
/// The definitions of the name: for an operator, the rules that propose it; for a sourced file, its first character.
std::vector<Use> DefinitionsOf(const Program& program, const Document& document, std::size_t offset);

/// The uses to replace, and the new text, to rename something. Fails for names of the world or the architecture, for
/// invalid names, and for names that already exist.
struct Renaming {
  std::vector<Use> uses;
  std::string text;
};
Result<Renaming> Rename(const Program& program, const Document& document, std::size_t offset, const std::string& to);
/// Why a name cannot be renamed; empty if it can.
std::string WhyNotRenamed(const Name& name);

}  // namespace soarbox::language
