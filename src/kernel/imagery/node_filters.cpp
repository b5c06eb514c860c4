// SPDX-License-Identifier: BSD-2-Clause
// Filters that find nodes, and filters that read properties of a node.
#include <unordered_map>

#include "kernel/imagery/computed_filter.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/scene_command.h"

namespace soarbox::kernel::imagery {
namespace {

/// The node with a given name, if it exists when the filter is computed.
class NodeFilter final : public ComputedFilter {
 public:
  explicit NodeFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    const std::string* const id = TextOf(combination, id_, "id");
    if (id == nullptr) return Refuse("expecting parameter id");
    Node* const node = scene().Find(*id);
    missing_ = node == nullptr ? *id : std::string();
    content = node;
    return node == nullptr ? Verdict::kNothing : Verdict::kValue;
  }
  Trouble Missing() const override {
    if (missing_.empty() || scene().Find(missing_) != nullptr) return {};
    return {
        "filter node can never find anything: " + HintForNode(scene(), missing_),
        "to find a node that appears later, use tag_select over all_nodes, or give the command once the node exists"};
  }

  std::string missing_;  ///< The name for which there was no node.

  Slots id_ = SlotsOf("id");
};

/// All nodes except the world, including nodes added later.
class AllNodesFilter final : public Filter {
 public:
  explicit AllNodesFilter(FilterParts parts) : Filter(std::move(parts)) {}

 private:
  bool Compute() override {
    if (started_) return true;
    started_ = true;
    WatchScene();
    scene().ForEach([&](Node& node) {
      if (&node != &scene().root()) Give(nullptr, &node);
    });
    return true;
  }
  void OnNode(Node& node, NodeChange change, std::string_view) override {
    if (change == NodeChange::kAdded) Give(nullptr, &node);
  }

  bool started_ = false;
};

class RemoveNodeFilter final : public ComputedFilter {
 public:
  explicit RemoveNodeFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Refuse("expecting parameter a");
    const std::string* const id = TextOf(combination, id_, "id");
    if (id == nullptr) return Refuse("expecting parameter id");
    const Node* const removed = scene().Find(*id);
    if (removed == nullptr) return Refuse("The given node doesn't exist");
    content = a;
    return a == removed ? Verdict::kNothing : Verdict::kValue;
  }

  Slots a_ = SlotsOf("a"), id_ = SlotsOf("id");
};

class CombineNodesFilter final : public ComputedFilter {
 public:
  explicit CombineNodesFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    for (std::size_t n = 0; n < inputs().parameters().size(); ++n) {
      const Value* const argument = inputs().ArgumentOf(combination, n);
      if (argument == nullptr) continue;
      Node* const* const node = std::get_if<Node*>(&argument->content);
      if (node == nullptr) break;
      content = *node;
      return Verdict::kValue;
    }
    return Verdict::kFail;
  }
};

class TagFilter final : public ComputedFilter {
 public:
  explicit TagFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Refuse("Needs node a as input");
    const std::string* const name = TextOf(combination, name_, "tag_name");
    if (name == nullptr) return Refuse("Needs tag_name as input");
    const std::string* const wanted = TextOf(combination, value_, "tag_value");
    if (wanted == nullptr) return Refuse("Needs tag_value as input");
    content = a;
    const std::string* const value = a->Tag(*name);
    return value != nullptr && *value == *wanted ? Verdict::kValue : Verdict::kNothing;
  }

  Slots a_ = SlotsOf("a"), name_ = SlotsOf("tag_name"), value_ = SlotsOf("tag_value");
};

/// A property of a node.
template <typename Read>
class ReadFilter final : public ComputedFilter {
 public:
  ReadFilter(FilterParts parts, Read read) : ComputedFilter(std::move(parts)), read_(read) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    const Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Verdict::kFail;
    content = read_(*a);
    return Verdict::kValue;
  }

  Read read_;
  Slots a_ = SlotsOf("a");
};

template <typename Read>
std::unique_ptr<Filter> MakeRead(FilterParts parts, Read read) {
  return std::make_unique<ReadFilter<Read>>(std::move(parts), read);
}

/// The change of a node's property since the filter first read it.
template <typename Read, typename Compare>
class MonitorFilter final : public ComputedFilter {
 public:
  MonitorFilter(FilterParts parts, Read read, Compare compare)
      : ComputedFilter(std::move(parts)), read_(read), compare_(compare) {
    WatchScene();
  }

 private:
  using Known = std::invoke_result_t<Read, const Node&>;

  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Refuse("expecting parameter a");
    const Known now = read_(*a);
    content = compare_(known_.try_emplace(a, now).first->second, now);
    return Verdict::kValue;
  }
  void OnNode(Node& node, NodeChange change, std::string_view) override {
    if (change == NodeChange::kRemoved) known_.erase(&node);
  }

  Read read_;
  Compare compare_;
  Slots a_ = SlotsOf("a");
  std::unordered_map<const Node*, Known> known_;
};

template <typename Read, typename Compare>
std::unique_ptr<Filter> MakeMonitor(FilterParts parts, Read read, Compare compare) {
  return std::make_unique<MonitorFilter<Read, Compare>>(std::move(parts), read, compare);
}

double OwnVolume(const Node& node) {
  const Vec3& scale = node.pose().scale;
  return scale.x * scale.y * scale.z;
}

template <typename Kind>
std::unique_ptr<Filter> Make(FilterParts parts) {
  return std::make_unique<Kind>(std::move(parts));
}

constexpr ParameterInfo kId[] = {{"id", "the node's id", true}};
constexpr ParameterInfo kNodes[] = {{"a", "nodes", true, ParameterForm::kNodes}};
constexpr ParameterInfo kRemove[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                     {"id", "the id of the node to leave out", true}};
constexpr ParameterInfo kTag[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                  {"tag_name", "the name of the tag", true},
                                  {"tag_value", "its value", true}};

}  // namespace

void AppendNodeFilters(std::vector<FilterKind>& kinds) {
  kinds.insert(
      kinds.end(),
      {{"node", "the node with an id, if it exists when the filter is first computed", kId, Make<NodeFilter>},
       {"all_nodes", "all nodes except world, including those added later", {}, Make<AllNodesFilter>, Sharing::kAlways},
       {"remove_node", "nodes, except one of them", kRemove, Make<RemoveNodeFilter>},
       {"combine_nodes", "all nodes of several sets", kNodes, Make<CombineNodesFilter>},
       {"tag_select", "the nodes with a tag", kTag, Make<TagFilter>},
       {"node_position", "the position of each node in its parent's frame", kNodes,
        [](FilterParts parts) {
          return MakeRead(std::move(parts), [](const Node& node) { return node.pose().position; });
        }},
       {"node_rotation", "the rotation of each node in its parent's frame, in radians", kNodes,
        [](FilterParts parts) {
          return MakeRead(std::move(parts), [](const Node& node) { return node.pose().rotation; });
        }},
       {"node_scale", "the scale of each node in its parent's frame", kNodes,
        [](FilterParts parts) {
          return MakeRead(std::move(parts), [](const Node& node) { return node.pose().scale; });
        }},
       {"node_bbox", "the box around each node, along the axes of the world", kNodes,
        [](FilterParts parts) { return MakeRead(std::move(parts), [](const Node& node) { return node.Bounds(); }); }},
       {"monitor_position", "how far each node is from its position when the filter first read it", kNodes,
        [](FilterParts parts) {
          return MakeMonitor(
              std::move(parts), [](const Node& node) { return node.pose().position; },
              [](const Vec3& first, const Vec3& now) { return Distance(first, now); });
        }},
       {"monitor_volume", "the volume of each node's own scale, divided by that when the filter first read it", kNodes,
        [](FilterParts parts) {
          return MakeMonitor(std::move(parts), OwnVolume,
                             [](double first, double now) { return (now + 1e-9) / (first + 1e-9); });
        }}});
}

}  // namespace soarbox::kernel::imagery
