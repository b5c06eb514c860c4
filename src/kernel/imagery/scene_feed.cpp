// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/scene_feed.h"

#include <string>

#include "kernel/imagery/scene_lines.h"

namespace soarbox::kernel::imagery {
namespace {

std::string Numbers(const Vec3& vector) {
  return " " + NumberText(vector.x) + " " + NumberText(vector.y) + " " + NumberText(vector.z);
}

std::string ShapeText(const Node& node) {
  std::string text;
  if (node.shape() == Shape::kBall) text = " b " + NumberText(node.radius());
  if (node.shape() == Shape::kHull) {
    text = " v";
    for (const Vec3& point : node.points()) text += Numbers(point);
  }
  return text;
}

}  // namespace

SceneFeed::SceneFeed(Scene& scene, const ViewerSink& sink) : scene_(scene), sink_(sink) {
  scene_.Watch(*this);
  Send("-" + scene_.name());
  scene_.ForEach([&](const Node& node) {
    if (node.parent() != nullptr) SendNode(node, true, true);
  });
}

SceneFeed::~SceneFeed() {
  scene_.Unwatch(*this);
  Send("-" + scene_.name());
}

void SceneFeed::Send(const std::string& line) {
  if (alive_) alive_ = sink_(line + "\n");
}

void SceneFeed::SendNode(const Node& node, bool shape, bool pose) {
  std::string line = "+" + scene_.name() + " +" + node.id();
  if (shape) line += ShapeText(node);
  if (pose) {
    const Transform::Parts parts = node.World().Decompose();
    line += " p" + Numbers(parts.position) + " r";
    for (const double part : parts.rotation) line += " " + NumberText(part);
    line += " s" + Numbers(parts.scale);
  }
  Send(line);
}

void SceneFeed::OnNode(Node& node, NodeChange change, std::string_view) {
  if (!alive_ || node.parent() == nullptr) return;
  switch (change) {
    case NodeChange::kAdded:
      SendNode(node, true, true);
      break;
    case NodeChange::kRemoved:
      Send(scene_.name() + " -" + node.id());
      break;
    case NodeChange::kMoved:
      SendNode(node, false, true);
      break;
    case NodeChange::kReshaped:
      if (!node.is_group()) SendNode(node, true, false);
      break;
    case NodeChange::kTagged:
    case NodeChange::kUntagged:
      break;
  }
}

}  // namespace soarbox::kernel::imagery
