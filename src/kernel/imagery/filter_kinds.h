// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "kernel/imagery/filter.h"

namespace soarbox::kernel::imagery {

/// What a parameter is.
enum class ParameterForm : std::uint8_t {
  kWord,
  kNodes,  ///< A filter that gives nodes.
  kNumber,
  kObject,  ///< An identifier with elements of its own.
};

/// A parameter of a filter or of a command, for help and checks.
struct ParameterInfo {
  std::string_view name, meaning;
  bool required = false;
  ParameterForm form = ParameterForm::kWord;
  std::string_view words = {};  ///< kWord: the allowed words, with blanks between them; empty: any.
};

/// When several extracts share one computation.
enum class Sharing : std::uint8_t {
  kSameLook,  ///< If they begin in the same look: the result depends on when it was first computed.
  kAlways,
  kNever,  ///< It draws random numbers.
};

/// A kind of filter.
struct FilterKind {
  std::string_view name, meaning;
  std::span<const ParameterInfo> parameters;
  std::unique_ptr<Filter> (*make)(FilterParts parts);
  Sharing sharing = Sharing::kSameLook;
};

/// All kinds, sorted by name.
std::span<const FilterKind> FilterKinds();
/// Null if there is no such kind.
const FilterKind* FindFilterKind(std::string_view name);

/// Makes a filter that always gives `content`.
std::unique_ptr<Filter> MakeConstant(FilterParts parts, Content content);

// The kinds, by file. Each function appends its own.
void AppendNodeFilters(std::vector<FilterKind>& kinds);
void AppendMeasureFilters(std::vector<FilterKind>& kinds);
void AppendOtherFilters(std::vector<FilterKind>& kinds);

}  // namespace soarbox::kernel::imagery
