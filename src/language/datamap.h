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
#include "language/text_document.h"

namespace soarbox::language {

/// The possible contents of working memory, as VisualSoar describes them: a graph of objects whose edges are
/// attributes.
struct Datamap {
  enum class Kind : std::uint8_t { kObject, kEnumeration, kInteger, kFloat, kString };
  struct Edge {
    std::string attribute;
    std::size_t to = 0;
  };
  struct Vertex {
    Kind kind = Kind::kObject;
    std::vector<std::string> words;  ///< For an enumeration.
    double min = 0, max = 0;         ///< For numbers; both 0: no limits.
    std::vector<Edge> edges;         ///< For an object.
  };
  std::vector<Vertex> vertices;  ///< Empty if there is no datamap.
  std::size_t root = 0;          ///< The top state.

  std::size_t Add(Kind kind) {
    vertices.emplace_back().kind = kind;
    return vertices.size() - 1;
  }
  /// The object that an attribute leads to; it is created if it does not exist.
  std::size_t ObjectAt(std::size_t object, std::string_view attribute);
};

/// Warnings about attributes and values of rules that the datamap does not contain. The hint is the most similar known
/// word or, without one, a list of the known words. An attribute is valid if any state of the datamap (the top state,
/// and all objects with ^superstate) has it at the end of the rule's path. Paths that do not begin at a state are not
/// checked.
std::vector<Diagnostic> FindUnknown(const Datamap& datamap, const Document& document);

/// Builds a datamap from the world's vocabulary (percepts and commands), and from what rules test and make.
Datamap DatamapOf(const std::vector<const Document*>& documents);

/// Converts a datamap to VisualSoar's JSON, format 6. `name`: name of the project; `layout`: paths of rule files,
/// relative to it.
std::string ToProjectJson(const Datamap& datamap, const std::string& name, const std::vector<std::string>& layout);

}  // namespace soarbox::language
