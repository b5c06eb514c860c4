// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/imagery_scene.h"

#include <algorithm>
#include <utility>

namespace soarbox::kernel::imagery {

// Nodes ---------------------------------------------------------------------------------------------------------------

const std::string* Node::Tag(std::string_view name) const {
  const auto found = tags_.find(name);
  return found == tags_.end() ? nullptr : &found->second;
}

bool Node::IsAbove(const Node& other) const {
  for (const Node* node = other.parent_; node != nullptr; node = node->parent_) {
    if (node == this) return true;
  }
  return false;
}

const Transform& Node::World() const {
  if (!world_known_) {
    const Transform local(spec_.pose);
    world_ = parent_ == nullptr ? local : parent_->World() * local;
    world_known_ = true;
  }
  return world_;
}

const std::vector<Vec3>& Node::WorldPoints() const {
  if (!points_known_) {
    const Transform& world = World();
    world_points_.clear();
    for (const Vec3& point : spec_.points) world_points_.push_back(world(point));
    points_known_ = true;
  }
  return world_points_;
}

const Box& Node::Bounds() const {
  if (bounds_known_) return bounds_;
  bounds_known_ = true;
  switch (spec_.shape) {
    case Shape::kHull: {
      const std::vector<Vec3>& points = WorldPoints();
      bounds_ = points.empty() ? Box{} : Box{points[0], points[0]};
      for (const Vec3& point : points) bounds_.Include(point);
      break;
    }
    case Shape::kBall: {
      const Transform& world = World();
      const double r = spec_.radius;
      const Vec3 first = world({-r, -r, -r});
      bounds_ = {first, first};
      for (int corner = 1; corner < 8; ++corner) {
        bounds_.Include(world({corner & 4 ? r : -r, corner & 2 ? r : -r, corner & 1 ? r : -r}));
      }
      break;
    }
    case Shape::kGroup: {
      const Vec3 origin = World()({});
      bounds_ = children_.empty() ? Box{origin, origin} : children_[0]->Bounds();
      for (const auto& child : children_) bounds_.Include(child->Bounds());
      break;
    }
  }
  return bounds_;
}

std::pair<double, double> Node::Extent(const Vec3& axis) const {
  const double middle = Dot(Centroid(), axis);
  double low = middle, high = middle;
  const auto include = [&](double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  };
  switch (spec_.shape) {
    case Shape::kHull:
      for (const Vec3& point : WorldPoints()) include(Dot(point, axis), Dot(point, axis));
      break;
    case Shape::kBall: {
      const double reach = Length(World()({spec_.radius, 0, 0}));
      include(middle - reach, middle + reach);
      break;
    }
    case Shape::kGroup:
      for (const auto& child : children_) {
        const auto [from, to] = child->Extent(axis);
        include(from, to);
      }
      break;
  }
  return {low, high};
}

// The scene -----------------------------------------------------------------------------------------------------------

Scene::Scene(std::string name) : name_(std::move(name)), root_(std::make_unique<Node>()) {
  root_->spec_.id = "world";
  last_ = root_.get();
  index_.emplace(root_->spec_.id, root_.get());
}

Scene::~Scene() = default;

Node* Scene::Find(std::string_view id) {
  const auto found = index_.find(id);
  return found == index_.end() ? nullptr : found->second;
}

std::size_t Scene::MemoryBytes() const {
  std::size_t bytes = sizeof(Scene) + index_.size() * 64;
  ForEach([&](const Node& node) {
    bytes += sizeof(Node) + (node.spec_.points.capacity() + node.world_points_.capacity()) * sizeof(Vec3) +
             node.children_.capacity() * sizeof(void*) + node.holds_.capacity() * sizeof(Node::Hold) +
             node.tags_.size() * 128;
  });
  return bytes;
}

void Scene::Enter(Node& node) {
  node.previous_ = last_;
  last_->next_ = &node;
  last_ = &node;
  index_.emplace(node.spec_.id, &node);
}

void Scene::Drop(Node& node) {
  node.previous_->next_ = node.next_;
  (node.next_ == nullptr ? last_ : node.next_->previous_) = node.previous_;
  index_.erase(node.spec_.id);
}

Node* Scene::Add(Node& parent, NodeSpec spec) {
  if (!parent.is_group() || parent.depth_ >= Node::kDeepest || Find(spec.id) != nullptr) return nullptr;
  auto made = std::make_unique<Node>();
  Node& node = *made;
  node.spec_ = std::move(spec);
  node.parent_ = &parent;
  node.depth_ = parent.depth_ + 1;
  parent.children_.push_back(std::move(made));
  Enter(node);
  TellReshaped(&parent);
  Tell(node, NodeChange::kAdded);
  return &node;
}

void Scene::Remove(Node& node) {
  if (&node == root_.get()) return;
  while (!node.children_.empty()) {
    // Removes the first child first. Ancestors are notified once, below.
    Node& child = *node.children_.front();
    while (!child.children_.empty()) Remove(*child.children_.front());
    const std::unique_ptr<Node> kept = std::move(node.children_.front());
    node.children_.erase(node.children_.begin());
    Tell(child, NodeChange::kRemoved);
    Drop(child);
  }
  Node& parent = *node.parent_;
  const auto place = std::find_if(parent.children_.begin(), parent.children_.end(),
                                  [&](const auto& child) { return child.get() == &node; });
  const std::unique_ptr<Node> kept = std::move(*place);
  parent.children_.erase(place);
  TellReshaped(&parent);
  Tell(node, NodeChange::kRemoved);
  Drop(node);
}

void Scene::Clear() {
  while (!root_->children_.empty()) Remove(*root_->children_.back());
}

void Scene::Move(Node& node, const Pose& pose) {
  if (node.spec_.pose == pose) return;
  node.spec_.pose = pose;
  TellReshaped(node.parent_);
  TellMoved(node);
}

void Scene::SetPoints(Node& node, std::vector<Vec3> points) {
  node.spec_.points = std::move(points);
  TellReshaped(&node);
}

void Scene::SetRadius(Node& node, double radius) {
  node.spec_.radius = radius;
  TellReshaped(&node);
}

void Scene::SetTag(Node& node, std::string_view name, std::string_view value) {
  node.tags_.insert_or_assign(std::string(name), std::string(value));
  Tell(node, NodeChange::kTagged, name);
}

void Scene::DeleteTag(Node& node, std::string_view name) {
  const auto found = node.tags_.find(name);
  if (found == node.tags_.end()) return;
  node.tags_.erase(found);
  Tell(node, NodeChange::kUntagged, name);
}

std::unique_ptr<Scene> Scene::Clone(std::string name) const {
  auto copy = std::make_unique<Scene>(std::move(name));
  copy->root_->spec_ = root_->spec_;
  copy->root_->tags_ = root_->tags_;
  copy->CopyBelow(*root_, *copy->root_);
  return copy;
}

void Scene::CopyBelow(const Node& from, Node& to) {
  for (const auto& child : from.children_) {
    Node* const made = Add(to, child->spec_);
    if (made == nullptr) continue;
    made->tags_ = child->tags_;
    CopyBelow(*child, *made);
  }
}

// Watchers ------------------------------------------------------------------------------------------------------------

void Scene::Unwatch(SceneWatcher& watcher) {
  std::erase(watchers_, &watcher);
}

void Scene::Tell(Node& node, NodeChange change, std::string_view tag) {
  ++version_;
  for (SceneWatcher* const watcher : watchers_) watcher->OnNode(node, change, tag);
  if (change == NodeChange::kRemoved) {
    for (const Node::Hold& hold : std::exchange(node.holds_, {})) hold.watcher->OnHeld(hold.number, change);
  } else {
    for (const Node::Hold& hold : node.holds_) hold.watcher->OnHeld(hold.number, change);
  }
}

void Scene::Release(Node& node, SceneWatcher& watcher, std::uint32_t number) {
  const auto found = std::find(node.holds_.begin(), node.holds_.end(), Node::Hold{&watcher, number});
  if (found == node.holds_.end()) return;
  *found = node.holds_.back();
  node.holds_.pop_back();
}

void Scene::TellReshaped(Node* node) {
  if (node == nullptr) return;
  TellReshaped(node->parent_);
  node->bounds_known_ = node->points_known_ = false;
  Tell(*node, NodeChange::kReshaped);
}

void Scene::TellMoved(Node& node) {
  node.world_known_ = node.bounds_known_ = node.points_known_ = false;
  Tell(node, NodeChange::kMoved);
  for (const auto& child : node.children_) TellMoved(*child);
}

}  // namespace soarbox::kernel::imagery
