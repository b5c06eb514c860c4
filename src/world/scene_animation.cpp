// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "world/scene.h"
#include "world/scene_node.h"
#include "world/state_hash.h"

// Bodies with a skeleton: their animations, and nodes attached to their bones.
namespace soarbox::world {

Animator* Scene::AnimatorOf(NodeId node) {
  Node* found = Find(node);
  return found ? found->animator.get() : nullptr;
}

const Animator* Scene::AnimatorOf(NodeId node) const {
  const Node* found = Find(node);
  return found ? found->animator.get() : nullptr;
}

AnimationId Scene::AnimationOf(NodeId node, std::size_t clip) {
  const Animator* animator = AnimatorOf(node);
  if (!animator || clip >= animator->rig().clips.size()) return AnimationId::kNone;
  AnimationId& id = animation_ids_[{node, static_cast<std::uint32_t>(clip)}];
  if (id == AnimationId::kNone) {
    animation_names_.push_back({node, static_cast<std::uint32_t>(clip)});
    id = AnimationId{static_cast<std::uint32_t>(animation_names_.size())};
  }
  return id;
}

Scene::FoundAnimation Scene::FindAnimation(AnimationId animation) {
  const std::uint32_t number = Number(animation);
  if (number == 0 || number > animation_names_.size()) return {};
  const AnimationName& name = animation_names_[number - 1];
  return {AnimatorOf(name.node), name.clip};
}

void Scene::ForgetAnimations(NodeId node) {
  std::erase(animated_, node);
  const auto first = animation_ids_.lower_bound({node, 0});
  auto last = first;
  while (last != animation_ids_.end() && last->first.first == node) ++last;
  animation_ids_.erase(first, last);
}

bool Scene::AttachToBone(NodeId mesh, std::size_t bone, NodeId node, Vec3 position, Quat orientation) {
  Node* body = Find(mesh);
  Node* thing = Find(node);
  if (!body || !body->animator || !thing || thing->belongs_to_entity) return false;
  if (bone >= body->animator->rig().skeleton.bones().size() || !IsFinite(position) || !IsFinite(orientation))
    return false;
  for (const Node* above = body; above; above = above->above) {
    if (above == thing) return false;
  }
  std::vector<std::pair<const Node*, int>> below{{thing, Depth(mesh) + 1}};
  while (!below.empty()) {
    const auto [at, depth] = below.back();
    below.pop_back();
    if (depth > kDeepest) return false;
    for (const Node* child : at->children) below.emplace_back(child, depth + 1);
  }
  if (thing->above) std::erase(thing->above->children, thing);
  body->children.push_back(thing);
  thing->above = body;
  thing->bone = static_cast<int>(bone);
  thing->position = position;
  thing->orientation = Normalized(orientation);
  // A carried node and its descendants belong to the carrier.
  std::vector<Node*> waiting{thing};
  while (!waiting.empty()) {
    Node* next = waiting.back();
    waiting.pop_back();
    next->owner = body->owner;
    next->owner_is_agent = body->owner_is_agent;
    next->has_new_look = true;
    waiting.insert(waiting.end(), next->children.begin(), next->children.end());
  }
  Changed(*thing);
  return true;
}

std::optional<BonePose> Scene::BoneInWorld(NodeId node, std::string_view bone) const {
  // Depth first, without recursion, because chains of attachments can be long.
  std::vector<const Node*> waiting{Find(node)};
  while (!waiting.empty()) {
    const Node* found = waiting.back();
    waiting.pop_back();
    if (!found || !found->animator) continue;
    const int index = found->animator->rig().skeleton.Find(bone);
    if (index >= 0) {
      const WorldTransform transform = TransformOf(*found);
      const BonePose pose = found->animator->NowPose().WorkOut(static_cast<std::size_t>(index));
      return BonePose{transform.Apply(pose.position), transform.orientation * pose.orientation};
    }
    AddCarried(*found, waiting);
  }
  return std::nullopt;
}

void Scene::AddCarried(const Node& body, std::vector<const Node*>& carried) {
  for (auto child = body.children.rbegin(); child != body.children.rend(); ++child) {
    if ((*child)->bone >= 0) carried.push_back(*child);
  }
}

std::vector<std::string_view> Scene::BonesBelow(NodeId node) const {
  std::vector<std::string_view> names;
  std::vector<const Node*> waiting{Find(node)};
  while (!waiting.empty()) {
    const Node* found = waiting.back();
    waiting.pop_back();
    if (!found || !found->animator) continue;
    const auto more = found->animator->rig().BoneNames();
    names.insert(names.end(), more.begin(), more.end());
    AddCarried(*found, waiting);
  }
  return names;
}

void Scene::AddAnimationTo(StateHash& hash) const {
  for (const NodeId id : animated_) {
    const Node& node = *Find(id);
    hash.Add(static_cast<std::uint64_t>(Number(id)));
    hash.Add(static_cast<std::uint64_t>(node.above ? Number(node.above->id) : 0));
    hash.Add(static_cast<std::uint64_t>(node.bone + 1));
    node.animator->AddTo(hash);
  }
}

}  // namespace soarbox::world
