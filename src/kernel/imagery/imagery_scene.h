// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/imagery/space.h"

namespace soarbox::kernel::imagery {

enum class Shape : std::uint8_t {
  kGroup,  ///< The union of its children.
  kHull,   ///< The convex hull of some points.
  kBall,
};

using Tags = std::map<std::string, std::string, std::less<>>;

/// The description of a new node.
struct NodeSpec {
  std::string id;
  Shape shape = Shape::kGroup;
  std::vector<Vec3> points;  ///< For kHull: in the node's own frame.
  double radius = 0;         ///< For kBall.
  Pose pose;
};

class SceneWatcher;

/// An object of a scene: a shape and a pose in its parent's frame. Data that depend on the poses of ancestors are
/// computed on request and cached until something moves. Only its scene changes it.
class Node {
 public:
  /// A watcher that is notified about this node, with the watcher's own number for the node.
  struct Hold {
    SceneWatcher* watcher;
    std::uint32_t number;
    friend bool operator==(const Hold&, const Hold&) = default;
  };

  /// Maximum nesting of groups.
  static constexpr int kDeepest = 200;

  const std::string& id() const { return spec_.id; }
  Shape shape() const { return spec_.shape; }
  bool is_group() const { return spec_.shape == Shape::kGroup; }
  const std::vector<Vec3>& points() const { return spec_.points; }
  double radius() const { return spec_.radius; }
  const Pose& pose() const { return spec_.pose; }
  const Tags& tags() const { return tags_; }
  /// Returns null if the node has no tag of this name.
  const std::string* Tag(std::string_view name) const;
  const Node* parent() const { return parent_; }
  const std::vector<std::unique_ptr<Node>>& children() const { return children_; }
  int depth() const { return depth_; }
  /// Whether `other` is a descendant of this node.
  bool IsAbove(const Node& other) const;

  const Transform& World() const;
  const std::vector<Vec3>& WorldPoints() const;  ///< For kHull.
  const Box& Bounds() const;
  Vec3 Centroid() const { return Bounds().Middle(); }
  /// The node's extent along a unit vector. A ball's extent is the length of the world vector to (radius, 0, 0) in its
  /// frame, as in Soar 9.6.3.
  std::pair<double, double> Extent(const Vec3& axis) const;

 private:
  friend class Scene;

  NodeSpec spec_;
  Tags tags_;
  Node* parent_ = nullptr;
  int depth_ = 0;
  std::vector<std::unique_ptr<Node>> children_;
  Node *previous_ = nullptr, *next_ = nullptr;  ///< In the scene's order.
  std::vector<Hold> holds_;
  mutable bool world_known_ = false, points_known_ = false, bounds_known_ = false;
  mutable Transform world_;
  mutable std::vector<Vec3> world_points_;
  mutable Box bounds_;
};

enum class NodeChange : std::uint8_t {
  kAdded,
  kRemoved,   ///< Its children have been removed; the node itself can still be read.
  kMoved,     ///< It or one of its ancestors moved.
  kReshaped,  ///< Its shape, or that of a descendant, changed.
  kTagged,
  kUntagged,
};

/// Receives notifications about a scene. Must not change the scene or its list of watchers.
class SceneWatcher {
 public:
  virtual ~SceneWatcher() = default;
  /// `tag` is the name of the tag that was added, changed or removed.
  virtual void OnNode(Node& node, NodeChange change, std::string_view tag) = 0;
  /// A change of a node that it holds under a number. A removed node is no longer held.
  virtual void OnHeld(std::uint32_t number, NodeChange change) {
    (void)number;
    (void)change;
  }
};

/// A tree of nodes below the group "world". Ids are unique; nodes are listed in the order in which they were added.
class Scene {
 public:
  explicit Scene(std::string name);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// The name of the state that it belongs to.
  const std::string& name() const { return name_; }
  Node& root() { return *root_; }
  const Node& root() const { return *root_; }
  /// Includes the root.
  std::size_t size() const { return index_.size(); }
  Node* Find(std::string_view id);
  const Node* Find(std::string_view id) const { return const_cast<Scene*>(this)->Find(id); }
  /// Visits all nodes in order, the root first. `visit` must not change the scene.
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (Node* node = root_.get(); node != nullptr; node = node->next_) visit(*node);
  }
  std::size_t MemoryBytes() const;

  /// Returns null if the id is in use, if the parent is not a group, or if the nesting is too deep.
  Node* Add(Node& parent, NodeSpec spec);
  /// Removes the node and all its descendants. The root cannot be removed.
  void Remove(Node& node);
  void Move(Node& node, const Pose& pose);
  void SetPoints(Node& node, std::vector<Vec3> points);
  void SetRadius(Node& node, double radius);
  void SetTag(Node& node, std::string_view name, std::string_view value);
  void DeleteTag(Node& node, std::string_view name);
  /// Removes all nodes but the root, last first.
  void Clear();
  /// A copy without watchers; its nodes are in depth-first order.
  std::unique_ptr<Scene> Clone(std::string name) const;

  /// Call Unwatch before the watcher is destroyed.
  void Watch(SceneWatcher& watcher) { watchers_.push_back(&watcher); }
  void Unwatch(SceneWatcher& watcher);
  /// Notifies a watcher about this node only. Call Release before the watcher is destroyed.
  void Hold(Node& node, SceneWatcher& watcher, std::uint32_t number) { node.holds_.push_back({&watcher, number}); }
  void Release(Node& node, SceneWatcher& watcher, std::uint32_t number);
  /// Increases with every change.
  std::uint64_t version() const { return version_; }

 private:
  void Tell(Node& node, NodeChange change, std::string_view tag = {});
  /// A node's shape changed, and thus those of its ancestors: notifies from the root down.
  void TellReshaped(Node* node);
  void TellMoved(Node& node);
  void CopyBelow(const Node& from, Node& to);
  void Enter(Node& node);
  void Drop(Node& node);

  std::string name_;
  std::unique_ptr<Node> root_;
  Node* last_ = nullptr;
  std::unordered_map<std::string_view, Node*> index_;  ///< By id; the node owns the text.
  std::vector<SceneWatcher*> watchers_;
  std::uint64_t version_ = 0;
};

}  // namespace soarbox::kernel::imagery
