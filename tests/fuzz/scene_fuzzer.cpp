// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary lines to a scene. Nodes must remain a tree with unique ids, measured values must be numbers, and a
// copy must give the same results as the original.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/measures.h"
#include "kernel/imagery/scene_lines.h"

namespace {

using namespace soarbox::kernel::imagery;

void Require(bool holds) {
  if (!holds) std::abort();
}

void Check(const Scene& scene) {
  std::set<std::string> ids;
  std::vector<const Node*> nodes;
  scene.ForEach([&](const Node& node) {
    Require(ids.insert(node.id()).second);
    Require(scene.Find(node.id()) == &node);
    Require(node.parent() == nullptr ? &node == &scene.root() : node.depth() == node.parent()->depth() + 1);
    nodes.push_back(&node);
  });
  Require(nodes.size() == scene.size());
  // All values that filters measure, for the first few nodes.
  nodes.resize(std::min<std::size_t>(nodes.size(), 5));
  PlainRandom random;
  for (const Node* const a : nodes) {
    a->World().Decompose();
    for (const Node* const b : nodes) {
      const double distance = HullDistance(*a, *b);
      Require(!(distance < 0));
      HullsTouch(*a, *b);
      AxisDistance(*a, *b, Vec3{1, 1, 0});
      Placement(*a, *b, a, {1, -1, 0.5});
      std::vector<SightLine> lines;
      AppendSightLines(*a, *b, lines);
      if (lines.size() < 20) Occlusion(lines, nodes);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Scene scene("S1");
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (const auto error = ApplyLine(scene, rest.substr(0, end))) Require(!error->ToString().empty());
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  Check(scene);
  const std::unique_ptr<Scene> copy = scene.Clone("S2");
  Require(copy->size() == scene.size());
  AnswerQueries(scene, text);
  scene.ForEach([&](const Node& node) {
    const std::string query = "obj-info " + node.id();
    Require(AnswerQueries(scene, query) == AnswerQueries(*copy, query));
  });
  scene.Clear();
  Require(scene.size() == 1);
  return 0;
}
