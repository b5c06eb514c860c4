// SPDX-License-Identifier: BSD-2-Clause
// Filters for relations along an axis, placement, and occlusion.
#include <algorithm>
#include <cctype>
#include <utility>

#include "kernel/imagery/computed_filter.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/measures.h"

namespace soarbox::kernel::imagery {
namespace {

class AxisRelationFilter final : public ComputedFilter {
 public:
  explicit AxisRelationFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Refuse("Need node a as input");
    Node* const b = NodeOf(combination, b_, "b");
    if (b == nullptr) return Refuse("Need node b as input");
    const std::string* const axis = TextOf(combination, axis_, "axis");
    if (axis == nullptr) return Refuse("Need axis x, y, or z specified");
    const auto is = [&](const Slots& slots, std::string_view name) {
      const std::string* const text = TextOf(combination, slots, name);
      return text != nullptr && *text == "true";
    };
    const bool greater = is(greater_, "greater"), aligned = is(aligned_, "aligned"), less = is(less_, "less");
    const double bottom = NumberOf(combination, bottom_, "bottom").value_or(0);
    const double top = NumberOf(combination, top_, "top").value_or(0);
    const std::string* const base = TextOf(combination, base_, "base");
    const bool from_a = base != nullptr && (*base == "a" || *base == "A");
    const int number = axis->empty() ? -1 : std::tolower(static_cast<unsigned char>((*axis)[0])) - 'x';
    const Node &from = from_a ? *a : *b, &to = from_a ? *b : *a;
    const double distance = number < 0 || number > 2 ? 0 : AxisDistance(from, to, number);
    const bool holds = (aligned && distance == 0) || (less && -top < distance && distance < -bottom) ||
                       (less && aligned && -top < distance && distance <= 0) ||
                       (greater && bottom < distance && distance < top) ||
                       (greater && aligned && 0 <= distance && distance < top);
    content = b;
    return holds ? Verdict::kValue : Verdict::kNothing;
  }

  Slots a_ = SlotsOf("a"), b_ = SlotsOf("b"), axis_ = SlotsOf("axis"), greater_ = SlotsOf("greater"),
        aligned_ = SlotsOf("aligned"), less_ = SlotsOf("less"), bottom_ = SlotsOf("bottom"), top_ = SlotsOf("top"),
        base_ = SlotsOf("base");
};

class PlacementFilter final : public ComputedFilter {
 public:
  explicit PlacementFilter(FilterParts parts) : ComputedFilter(std::move(parts)) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    const Node* const a = NodeOf(combination, a_, "a");
    if (a == nullptr) return Refuse("expecting sgnode parameter 'a'");
    const Node* const b = NodeOf(combination, b_, "b");
    if (b == nullptr) return Refuse("expecting sgnode parameter 'b'");
    const Node* const reference = NodeOf(combination, reference_, "reference");
    const Vec3 separation{NumberOf(combination, x_, "x_axis_separation").value_or(0),
                          NumberOf(combination, y_, "y_axis_separation").value_or(0),
                          NumberOf(combination, z_, "z_axis_separation").value_or(0)};
    content = Placement(*a, *b, reference, separation);
    return Verdict::kValue;
  }

  Slots a_ = SlotsOf("a"), b_ = SlotsOf("b"), reference_ = SlotsOf("reference"), x_ = SlotsOf("x_axis_separation"),
        y_ = SlotsOf("y_axis_separation"), z_ = SlotsOf("z_axis_separation");
};

/// One number for all combinations.
class OcclusionFilter final : public Filter {
 public:
  explicit OcclusionFilter(FilterParts parts) : Filter(std::move(parts)) {}

 private:
  bool Compute() override {
    TrackedList<Combination>& combinations = inputs().combinations();
    if (!combinations.HasChanges()) return true;
    std::vector<SightLine> lines;
    std::vector<const Node*> occluders;
    std::vector<std::pair<const Node*, const Node*>> seen;
    for (const Combination& combination : combinations) {
      const Node* const a = NodeOf(combination, a_, "a");
      if (a == nullptr) return Refuse("expecting parameter a");
      const Node* eye = NodeOf(combination, eye_, "eye");
      if (eye == nullptr) eye = scene().Find("eye");
      if (eye == nullptr) return Refuse("expecting parameter eye");
      const Node* const b = NodeOf(combination, b_, "b");
      if (b == nullptr) return Refuse("expecting parameter b");
      if (std::find(seen.begin(), seen.end(), std::pair(a, eye)) == seen.end()) {
        seen.emplace_back(a, eye);
        AppendSightLines(*a, *eye, lines);
      }
      if (std::find(occluders.begin(), occluders.end(), b) == occluders.end()) occluders.push_back(b);
    }
    const double hidden = Occlusion(lines, occluders);
    if (value_ == nullptr) {
      value_ = &Give(nullptr, hidden);
    } else {
      Change(*value_, hidden);
    }
    return true;
  }
  void ClearOutput() override {
    value_ = nullptr;
    Filter::ClearOutput();
  }
  bool Refuse(std::string_view status) {
    Fail(status);
    return false;
  }

  Slots a_ = SlotsOf("a"), b_ = SlotsOf("b"), eye_ = SlotsOf("eye");
  Value* value_ = nullptr;
};

/// A constant in a rule.
class ConstantFilter final : public Filter {
 public:
  ConstantFilter(FilterParts parts, Content content) : Filter(std::move(parts)), content_(std::move(content)) {}

 private:
  bool Compute() override {
    if (!std::exchange(given_, true)) Give(nullptr, content_);
    return true;
  }

  Content content_;
  bool given_ = false;
};

template <typename Kind>
std::unique_ptr<Filter> MakeOther(FilterParts parts) {
  return std::make_unique<Kind>(std::move(parts));
}

constexpr ParameterInfo kRelation[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"axis", "x, y or z", true, ParameterForm::kWord, "x y z"},
    {"less", "true: it holds for negative distances", false, ParameterForm::kWord, "true false"},
    {"aligned", "true: it holds if both overlap on the axis", false, ParameterForm::kWord, "true false"},
    {"greater", "true: it holds for positive distances", false, ParameterForm::kWord, "true false"},
    {"bottom", "the smallest distance, without its sign", false, ParameterForm::kNumber},
    {"top", "the largest distance, without its sign", false, ParameterForm::kNumber},
    {"base", "a or b: the node from which to measure", false, ParameterForm::kWord, "a b"}};
constexpr ParameterInfo kPlacement[] = {
    {"a", "the node to place", true, ParameterForm::kNodes},
    {"b", "the node to place it next to", true, ParameterForm::kNodes},
    {"reference", "a node along whose axes to measure", false, ParameterForm::kNodes},
    {"x_axis_separation", "the gap along x", false, ParameterForm::kNumber},
    {"y_axis_separation", "the gap along y", false, ParameterForm::kNumber},
    {"z_axis_separation", "the gap along z", false, ParameterForm::kNumber}};
constexpr ParameterInfo kOcclusion[] = {
    {"a", "the node that is looked at", true, ParameterForm::kNodes},
    {"b", "the nodes that may hide it", true, ParameterForm::kNodes},
    {"eye", "the node from which it is looked at; the node eye if missing", false, ParameterForm::kNodes}};

}  // namespace

std::unique_ptr<Filter> MakeConstant(FilterParts parts, Content content) {
  return std::make_unique<ConstantFilter>(std::move(parts), std::move(content));
}

void AppendOtherFilters(std::vector<FilterKind>& kinds) {
  kinds.insert(kinds.end(),
               {{"axis_relation_select", "each b that is in a given relation to a along an axis", kRelation,
                 MakeOther<AxisRelationFilter>},
                {"calculate_placement", "the position for a's centroid that places a next to b", kPlacement,
                 MakeOther<PlacementFilter>},
                {"occlusion", "the share of a that b hides from an eye", kOcclusion, MakeOther<OcclusionFilter>}});
}

}  // namespace soarbox::kernel::imagery
