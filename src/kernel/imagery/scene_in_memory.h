// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <unordered_map>

#include "kernel/base/symbol.h"
#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/memory_writer.h"

namespace soarbox::kernel::imagery {

/// The copy of a scene in working memory: ^id, ^child and the tags of each node.
class SceneView final : private SceneWatcher {
 public:
  /// Writes the scene below `root`.
  SceneView(MemoryWriter& writer, Scene& scene, Symbol root);
  ~SceneView() override;
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  void Mark(const std::function<void(Symbol)>& mark) const;

 private:
  void OnNode(Node& node, NodeChange change, std::string_view tag) override;
  void Write(const Node& node, Symbol id);
  void AddChild(const Node& node);
  void Erase(const Node& node);

  MemoryWriter& writer_;
  Scene& scene_;
  std::unordered_map<const Node*, Symbol> ids_;
};

}  // namespace soarbox::kernel::imagery
