// SPDX-License-Identifier: BSD-2-Clause
// Filters that measure or test nodes. Each has three forms: the result, the nodes for which it is true, and the best
// node.
#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <type_traits>

#include "kernel/imagery/computed_filter.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/measures.h"

namespace soarbox::kernel::imagery {
namespace {

/// Arguments of a measure in addition to its nodes.
struct Options {
  std::string_view type;  ///< distance_type, volume_type or intersect_type; empty if missing.
  std::string_view axis;
  const Node* reference = nullptr;
  PlainRandom* random = nullptr;
};

using Measure = double (*)(const Node& a, const Node& b, const Options& options);
using Size = double (*)(const Node& a, const Options& options);
using Test = bool (*)(const Node& a, const Node& b, const Options& options);

// Measures ------------------------------------------------------------------------------------------------------------

double MeasureDistance(const Node& a, const Node& b, const Options& options) {
  if (&a == &b) return 0;
  return options.type == "hull" ? HullDistance(a, b) : PositionDistance(a, b);
}

double MeasureAxisDistance(const Node& a, const Node& b, const Options& options) {
  if (options.axis.empty()) return 0;
  const int letter = std::tolower(static_cast<unsigned char>(options.axis[0]));
  const int axis = letter >= 'x' && letter <= 'z' ? letter - 'x' : letter >= '0' && letter <= '2' ? letter - '0' : 0;
  if (options.reference == nullptr) return AxisDistance(a, b, axis);
  Vec3 unit;
  unit[axis] = 1;
  return AxisDistance(a, b, options.reference->World().Turn(unit));
}

double MeasureOverlap(const Node& a, const Node& b, const Options& options) {
  return &a == &b ? 1 : Overlap(a, b, *options.random);
}

double SizeOf(const Node& a, const Options& options) {
  return options.type == "scale" ? ScaleVolume(a) : BoxVolume(a);
}

bool IsLarger(const Node& a, const Node& b, const Options& options) {
  return &a != &b && SizeOf(a, options) > SizeOf(b, options);
}
bool IsSmaller(const Node& a, const Node& b, const Options& options) {
  return &a != &b && SizeOf(a, options) < SizeOf(b, options);
}
bool Contains(const Node& a, const Node& b, const Options&) {
  return &a == &b || a.Bounds().Contains(b.Bounds());
}
bool Intersects(const Node& a, const Node& b, const Options& options) {
  if (&a == &b) return true;
  return options.type == "hull" ? HullsTouch(a, b) : a.Bounds().Touches(b.Bounds());
}

// Filters -------------------------------------------------------------------------------------------------------------

/// Finds the arguments of measures in a combination. `Base` is the form of the filter.
template <typename Base>
class Measuring : public Base {
 public:
  /// `measure` is null for the size of one node.
  template <typename... More>
  Measuring(FilterParts parts, std::string_view type, Measure measure, More... more)
      : Base(std::move(parts), more...), measure_(measure), type_name_(type), type_(this->SlotsOf(type)) {}

 protected:
  using Slots = typename Base::Slots;

  Options OptionsOf(const Combination& combination) {
    Options options;
    if (const std::string* const type = this->TextOf(combination, type_, type_name_, false)) options.type = *type;
    if (const std::string* const axis = this->TextOf(combination, axis_, "axis", false)) options.axis = *axis;
    if (!reference_.empty()) {
      if (const Value* const value = this->Argument(combination, reference_)) {
        if (Node* const* const node = std::get_if<Node*>(&value->content)) options.reference = *node;
      }
    }
    options.random = &this->random();
    return options;
  }
  /// Sets the two nodes. Returns false if one is missing.
  bool Pair(const Combination& combination, Node*& a, Node*& b) {
    a = this->NodeOf(combination, a_, "a");
    b = a == nullptr ? nullptr : this->NodeOf(combination, b_, "b");
    if (a != nullptr && b != nullptr) return true;
    this->Fail("Need nodes a and b as input");
    return false;
  }
  /// The number of a combination, and the measured node; none if a node is missing.
  std::optional<double> Measured(const Combination& combination, Node*& node) {
    if (measure_ != nullptr) {
      Node* a;
      if (!Pair(combination, a, node)) return std::nullopt;
      return measure_(*a, *node, OptionsOf(combination));
    }
    node = this->NodeOf(combination, a_, "a");
    if (node != nullptr) return SizeOf(*node, OptionsOf(combination));
    this->Fail(std::is_same_v<Base, RankFilter> ? "Need node a as input" : "Need node a input");
    return std::nullopt;
  }

 private:
  Measure measure_;
  std::string_view type_name_;
  Slots type_, a_ = this->SlotsOf("a"), b_ = this->SlotsOf("b"), axis_ = this->SlotsOf("axis"),
               reference_ = this->SlotsOf("reference");
};

/// The number itself, or the node if its number is between ^min and ^max.
class MeasureFilter final : public Measuring<ComputedFilter> {
 public:
  MeasureFilter(FilterParts parts, std::string_view type, Measure measure, bool select)
      : Measuring(std::move(parts), type, measure), select_(select) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* node;
    const std::optional<double> number = Measured(combination, node);
    if (!number) return Verdict::kFail;
    if (!select_) {
      content = *number;
      return Verdict::kValue;
    }
    content = node;
    return InRange(combination, *number) ? Verdict::kValue : Verdict::kNothing;
  }
  bool InRange(const Combination& combination, double number) {
    if (const std::optional<double> min = NumberOf(combination, min_slots_, "min")) min_ = *min;
    if (const std::optional<double> max = NumberOf(combination, max_slots_, "max")) max_ = *max;
    if (const std::string* const text = TextOf(combination, include_min_slots_, "include_min")) {
      include_min_ = *text != "false";
    }
    if (const std::string* const text = TextOf(combination, include_max_slots_, "include_max")) {
      include_max_ = *text != "false";
    }
    const bool above = include_min_ ? number >= min_ : number > min_;
    const bool below = include_max_ ? number <= max_ : number < max_;
    return above && below;
  }

  bool select_;
  double min_ = -1e9, max_ = 1e9;
  bool include_min_ = true, include_max_ = true;
  Slots min_slots_ = SlotsOf("min"), max_slots_ = SlotsOf("max"), include_min_slots_ = SlotsOf("include_min"),
        include_max_slots_ = SlotsOf("include_max");
};

class MeasureRankFilter final : public Measuring<RankFilter> {
 public:
  using Measuring::Measuring;

 private:
  std::optional<double> Rank(const Combination& combination) override {
    Node* node;
    return Measured(combination, node);
  }
};

/// A test of two nodes: returns the result, or b if it is true.
class TestFilter final : public Measuring<ComputedFilter> {
 public:
  TestFilter(FilterParts parts, std::string_view type, Test test, bool select)
      : Measuring(std::move(parts), type, nullptr), test_(test), select_(select) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node *a, *b;
    if (!Pair(combination, a, b)) return Verdict::kFail;
    const bool answer = test_(*a, *b, OptionsOf(combination));
    if (select_) {
      content = b;
      return answer ? Verdict::kValue : Verdict::kNothing;
    }
    content = answer;
    return Verdict::kValue;
  }
  Test test_;
  bool select_;
};

// The table -----------------------------------------------------------------------------------------------------------

template <Measure kMeasure, int kForm>  // 0: the number, 1: select, 2: lowest, 3: highest.
std::unique_ptr<Filter> MakeMeasure(FilterParts parts) {
  constexpr std::string_view kType = kMeasure == nullptr ? "volume_type" : "distance_type";
  if constexpr (kForm < 2) return std::make_unique<MeasureFilter>(std::move(parts), kType, kMeasure, kForm == 1);
  return std::make_unique<MeasureRankFilter>(std::move(parts), kType, kMeasure, kForm == 3);
}

template <Test kTest, bool kSelect>
std::unique_ptr<Filter> MakeTest(FilterParts parts) {
  const std::string_view type = kTest == Intersects ? "intersect_type" : "volume_type";
  return std::make_unique<TestFilter>(std::move(parts), type, kTest, kSelect);
}

/// The parameters of a measure, followed by those of a range.
template <std::size_t count>
constexpr auto WithRange(const ParameterInfo (&own)[count], std::string_view least, std::string_view greatest) {
  std::array<ParameterInfo, count + 4> all{};
  std::copy_n(own, count, all.begin());
  all[count] = {"min", least, false, ParameterForm::kNumber};
  all[count + 1] = {"max", greatest, false, ParameterForm::kNumber};
  all[count + 2] = {"include_min", "false: more than min", false, ParameterForm::kWord, "true false"};
  all[count + 3] = {"include_max", "false: less than max", false, ParameterForm::kWord, "true false"};
  return all;
}

constexpr ParameterInfo kDistance[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"distance_type", "centroid (of local positions) or hull", false, ParameterForm::kWord, "centroid hull"}};
constexpr auto kDistanceRange = WithRange(kDistance, "the smallest number to select", "the largest number to select");
constexpr ParameterInfo kAxis[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                   {"b", "nodes", true, ParameterForm::kNodes},
                                   {"axis", "x, y or z", true, ParameterForm::kWord, "x y z"},
                                   {"reference", "a node along whose axis to measure", false, ParameterForm::kNodes}};
constexpr auto kAxisRange = WithRange(kAxis, "the smallest number to select", "the largest number to select");
constexpr ParameterInfo kTwo[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                  {"b", "nodes", true, ParameterForm::kNodes}};
constexpr auto kTwoRange = WithRange(kTwo, "the smallest share to select", "the largest share to select");
constexpr ParameterInfo kVolume[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"volume_type", "bbox, or scale: of the node's own scale", false, ParameterForm::kWord, "bbox scale"}};
constexpr auto kVolumeRange = WithRange(kVolume, "the smallest volume to select", "the largest volume to select");
constexpr ParameterInfo kSizes[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"volume_type", "bbox, or scale: of the node's own scale", false, ParameterForm::kWord, "bbox scale"}};
constexpr ParameterInfo kIntersect[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"intersect_type", "bbox or hull", false, ParameterForm::kWord, "bbox box hull"}};

}  // namespace

void AppendMeasureFilters(std::vector<FilterKind>& kinds) {
  kinds.insert(
      kinds.end(),
      {{"distance", "the distance between a and b", kDistance, MakeMeasure<MeasureDistance, 0>},
       {"distance_select", "each b within a range of distances from a", kDistanceRange,
        MakeMeasure<MeasureDistance, 1>},
       {"closest", "the smallest distance between an a and a b, and these two nodes", kDistance,
        MakeMeasure<MeasureDistance, 2>},
       {"farthest", "the largest distance between an a and a b, and these two nodes", kDistance,
        MakeMeasure<MeasureDistance, 3>},
       {"axis_distance", "how far b's box is beyond a's along an axis", kAxis, MakeMeasure<MeasureAxisDistance, 0>},
       {"axis_distance_select", "each b within a range of such distances", kAxisRange,
        MakeMeasure<MeasureAxisDistance, 1>},
       {"overlap", "the share of a that is in b", kTwo, MakeMeasure<MeasureOverlap, 0>, Sharing::kNever},
       {"overlap_select", "each b within a range of such shares", kTwoRange, MakeMeasure<MeasureOverlap, 1>,
        Sharing::kNever},
       {"volume", "the volume of each node", kVolume, MakeMeasure<nullptr, 0>},
       {"volume_select", "the nodes within a range of volumes", kVolumeRange, MakeMeasure<nullptr, 1>},
       {"largest", "the largest volume, and the node that has it", kVolume, MakeMeasure<nullptr, 3>},
       {"smallest", "the smallest volume, and the node that has it", kVolume, MakeMeasure<nullptr, 2>},
       {"larger", "whether a is larger than b", kSizes, MakeTest<IsLarger, false>},
       {"larger_select", "each b that a is larger than", kSizes, MakeTest<IsLarger, true>},
       {"smaller", "whether a is smaller than b", kSizes, MakeTest<IsSmaller, false>},
       {"smaller_select", "each b that a is smaller than", kSizes, MakeTest<IsSmaller, true>},
       {"contain", "whether the box around a contains that around b", kTwo, MakeTest<Contains, false>},
       {"contain_select", "each b whose box is in that around a", kTwo, MakeTest<Contains, true>},
       {"intersect", "whether a and b touch or overlap", kIntersect, MakeTest<Intersects, false>},
       {"intersect_select", "each b that touches or overlaps a", kIntersect, MakeTest<Intersects, true>}});
}

}  // namespace soarbox::kernel::imagery
