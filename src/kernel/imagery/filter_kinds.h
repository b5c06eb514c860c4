// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "kernel/imagery/filter.h"

namespace soarbox::kernel::imagery {

/// The kind of argument that a parameter expects.
enum class ParameterForm : std::uint8_t {
  kWord,
  kNodes,  ///< A filter that returns nodes.
  kNumber,
  kObject,  ///< An identifier with elements.
};

/// A parameter of a filter or a command, for help and checks.
struct ParameterInfo {
  std::string_view name, meaning;
  bool required = false;
  ParameterForm form = ParameterForm::kWord;
  std::string_view words = {};  ///< For kWord: the allowed words, separated by blanks; empty: any.
};

/// The conditions under which several extracts share one computation.
enum class Sharing : std::uint8_t {
  kSameLook,  ///< If they begin in the same look, because the result depends on when it was first computed.
  kAlways,
  kNever,  ///< Never, because it draws random numbers.
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
/// Returns null if there is no such kind.
const FilterKind* FindFilterKind(std::string_view name);

/// Creates a filter with the constant value `content`.
std::unique_ptr<Filter> MakeConstant(FilterParts parts, Content content);

// The kinds, by source file. Each function appends its own.
void AppendNodeFilters(std::vector<FilterKind>& kinds);
void AppendMeasureFilters(std::vector<FilterKind>& kinds);
void AppendOtherFilters(std::vector<FilterKind>& kinds);

}  // namespace soarbox::kernel::imagery
