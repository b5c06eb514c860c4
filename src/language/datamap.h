// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_text.h"
#include "language/document.h"

namespace soarbox::language {

/// What working memory may hold, as VisualSoar describes it: a graph of objects, whose edges are attributes.
struct Datamap {
  enum class Kind : std::uint8_t { kObject, kEnumeration, kInteger, kFloat, kString };
  struct Edge {
    std::string attribute;
    std::size_t to = 0;
  };
  struct Vertex {
    Kind kind = Kind::kObject;
    std::vector<std::string> words;  ///< Of an enumeration.
    double min = 0, max = 0;         ///< Of numbers; both 0: any.
    std::vector<Edge> edges;         ///< Of an object.
  };
  std::vector<Vertex> vertices;  ///< Empty: nothing is known.
  std::size_t root = 0;          ///< The top state.

  std::size_t Add(Kind kind);
  /// The object behind an attribute, made if it is not there.
  std::size_t ObjectAt(std::size_t object, std::string_view attribute);
};

/// The attributes and values of rules that a datamap does not know, as warnings with places, each with the nearest that
/// it does know. An attribute is known if any state of the datamap (the top state, and all objects with ^superstate)
/// has it at the end of the rule's path; paths that begin at no state are left alone.
std::vector<Diagnostic> FindUnknown(const Datamap& datamap, const Document& document);

/// A datamap of the world's vocabulary (percepts and commands) and of what rules test and make.
Datamap DatamapOf(const std::vector<const Document*>& documents);

/// As VisualSoar's JSON, format 6. `name`: of the project; `layout`: files of rules, relative to it.
std::string ToProjectJson(const Datamap& datamap, const std::string& name, const std::vector<std::string>& layout);

}  // namespace soarbox::language
