// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/scene_in_memory.h"

namespace soarbox::kernel::imagery {

SceneView::SceneView(MemoryWriter& writer, Scene& scene, Symbol root) : writer_(writer), scene_(scene) {
  scene_.Watch(*this);
  Write(scene_.root(), root);
}

SceneView::~SceneView() {
  scene_.Unwatch(*this);
}

void SceneView::Mark(const std::function<void(Symbol)>& mark) const {
  for (const auto& [node, id] : ids_) {
    if (id) mark(id);
  }
}

void SceneView::Write(const Node& node, Symbol id) {
  ids_[&node] = id;
  writer_.Add(id, "id", writer_.Text(node.id()));
  for (const auto& child : node.children()) AddChild(*child);
  for (const auto& [name, value] : node.tags()) writer_.Add(id, name, writer_.Text(value));
}

void SceneView::AddChild(const Node& node) {
  Write(node, writer_.AddObject(ids_.at(node.parent()), "child"));
}

void SceneView::Erase(const Node& node) {
  const auto found = ids_.find(&node);
  if (found == ids_.end()) return;
  const Symbol id = found->second;
  writer_.Remove(id, "id", writer_.Text(node.id()));
  for (const auto& [name, value] : node.tags()) writer_.Remove(id, name, writer_.Text(value));
  if (node.parent() != nullptr) writer_.Remove(ids_.at(node.parent()), "child", id);
  ids_.erase(found);
}

void SceneView::OnNode(Node& node, NodeChange change, std::string_view tag) {
  switch (change) {
    case NodeChange::kAdded:
      AddChild(node);
      break;
    case NodeChange::kRemoved:
      Erase(node);
      break;
    case NodeChange::kTagged: {
      const Symbol id = ids_.at(&node);
      // A tag has one value, which is replaced. Tags named id or child are skipped, because they would replace ^id or
      // ^child.
      if (tag == "id" || tag == "child") break;
      writer_.RemoveAll(id, tag);
      writer_.Add(id, tag, writer_.Text(*node.Tag(tag)));
      break;
    }
    case NodeChange::kUntagged:
      if (tag != "id" && tag != "child") writer_.RemoveAll(ids_.at(&node), tag);
      break;
    case NodeChange::kMoved:
    case NodeChange::kReshaped:
      break;
  }
}

}  // namespace soarbox::kernel::imagery
