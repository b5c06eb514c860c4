// SPDX-License-Identifier: BSD-2-Clause
// Filters that measure or test nodes, each in three forms: the answer, the nodes for which it is right, the best one.
#include <cctype>

#include "kernel/imagery/computed_filter.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/measures.h"

namespace soarbox::kernel::imagery {
namespace {

/// What a measure is told beside its nodes.
struct Options {
  std::string_view type;  ///< distance_type, volume_type or intersect_type; empty if it is missing.
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

/// How the parameters of measures are found in a combination. `Base` is the form of the filter.
template <typename Base>
class Measuring : public Base {
 public:
  template <typename... More>
  Measuring(FilterParts parts, std::string_view type, More... more)
      : Base(std::move(parts), more...), type_name_(type), type_(this->SlotsOf(type)) {}

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
  /// The two nodes; false if one is missing.
  bool Pair(const Combination& combination, Node*& a, Node*& b) {
    a = this->NodeOf(combination, a_, "a");
    b = a == nullptr ? nullptr : this->NodeOf(combination, b_, "b");
    if (a != nullptr && b != nullptr) return true;
    this->Fail("Need nodes a and b as input");
    return false;
  }
  Node* Single(const Combination& combination, std::string_view complaint) {
    Node* const a = this->NodeOf(combination, a_, "a");
    if (a == nullptr) this->Fail(complaint);
    return a;
  }

 private:
  std::string_view type_name_;
  Slots type_, a_ = this->SlotsOf("a"), b_ = this->SlotsOf("b"), axis_ = this->SlotsOf("axis"),
               reference_ = this->SlotsOf("reference");
};

/// A range of numbers, from ^min to ^max.
class RangeFilter : public Measuring<ComputedFilter> {
 public:
  using Measuring::Measuring;

 protected:
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

 private:
  double min_ = -1e9, max_ = 1e9;
  bool include_min_ = true, include_max_ = true;
  Slots min_slots_ = SlotsOf("min"), max_slots_ = SlotsOf("max"), include_min_slots_ = SlotsOf("include_min"),
        include_max_slots_ = SlotsOf("include_max");
};

class MeasureFilter final : public Measuring<ComputedFilter> {
 public:
  MeasureFilter(FilterParts parts, std::string_view type, Measure measure)
      : Measuring(std::move(parts), type), measure_(measure) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node *a, *b;
    if (!Pair(combination, a, b)) return Verdict::kFail;
    content = measure_(*a, *b, OptionsOf(combination));
    return Verdict::kValue;
  }
  Measure measure_;
};

class MeasureSelectFilter final : public RangeFilter {
 public:
  MeasureSelectFilter(FilterParts parts, std::string_view type, Measure measure)
      : RangeFilter(std::move(parts), type), measure_(measure) {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node *a, *b;
    if (!Pair(combination, a, b)) return Verdict::kFail;
    content = b;
    const double measured = measure_(*a, *b, OptionsOf(combination));
    return InRange(combination, measured) ? Verdict::kValue : Verdict::kNothing;
  }
  Measure measure_;
};

class MeasureRankFilter final : public Measuring<RankFilter> {
 public:
  MeasureRankFilter(FilterParts parts, std::string_view type, Measure measure, bool highest)
      : Measuring(std::move(parts), type, highest), measure_(measure) {}

 private:
  std::optional<double> Rank(const Combination& combination) override {
    Node *a, *b;
    if (!Pair(combination, a, b)) return std::nullopt;
    return measure_(*a, *b, OptionsOf(combination));
  }
  Measure measure_;
};

class SizeFilter final : public Measuring<ComputedFilter> {
 public:
  explicit SizeFilter(FilterParts parts) : Measuring(std::move(parts), "volume_type") {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    const Node* const a = Single(combination, "Need node a input");
    if (a == nullptr) return Verdict::kFail;
    content = SizeOf(*a, OptionsOf(combination));
    return Verdict::kValue;
  }
};

class SizeSelectFilter final : public RangeFilter {
 public:
  explicit SizeSelectFilter(FilterParts parts) : RangeFilter(std::move(parts), "volume_type") {}

 private:
  Verdict Evaluate(const Combination& combination, Content& content) override {
    Node* const a = Single(combination, "Need node a input");
    if (a == nullptr) return Verdict::kFail;
    content = a;
    return InRange(combination, SizeOf(*a, OptionsOf(combination))) ? Verdict::kValue : Verdict::kNothing;
  }
};

class SizeRankFilter final : public Measuring<RankFilter> {
 public:
  SizeRankFilter(FilterParts parts, bool highest) : Measuring(std::move(parts), "volume_type", highest) {}

 private:
  std::optional<double> Rank(const Combination& combination) override {
    const Node* const a = Single(combination, "Need node a as input");
    if (a == nullptr) return std::nullopt;
    return SizeOf(*a, OptionsOf(combination));
  }
};

/// A test of two nodes: the answer, or b if it is true.
class TestFilter final : public Measuring<ComputedFilter> {
 public:
  TestFilter(FilterParts parts, std::string_view type, Test test, bool select)
      : Measuring(std::move(parts), type), test_(test), select_(select) {}

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
  if constexpr (kForm == 0) return std::make_unique<MeasureFilter>(std::move(parts), "distance_type", kMeasure);
  if constexpr (kForm == 1) return std::make_unique<MeasureSelectFilter>(std::move(parts), "distance_type", kMeasure);
  return std::make_unique<MeasureRankFilter>(std::move(parts), "distance_type", kMeasure, kForm == 3);
}

template <Test kTest, bool kSelect>
std::unique_ptr<Filter> MakeTest(FilterParts parts) {
  const std::string_view type = kTest == Intersects ? "intersect_type" : "volume_type";
  return std::make_unique<TestFilter>(std::move(parts), type, kTest, kSelect);
}

constexpr ParameterInfo kDistance[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"distance_type", "centroid (of local positions) or hull", false, ParameterForm::kWord, "centroid hull"}};
constexpr ParameterInfo kDistanceRange[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"distance_type", "centroid (of local positions) or hull", false, ParameterForm::kWord, "centroid hull"},
    {"min", "the least number to select", false, ParameterForm::kNumber},
    {"max", "the greatest number to select", false, ParameterForm::kNumber},
    {"include_min", "false: more than min", false, ParameterForm::kWord, "true false"},
    {"include_max", "false: less than max", false, ParameterForm::kWord, "true false"}};
constexpr ParameterInfo kAxis[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                   {"b", "nodes", true, ParameterForm::kNodes},
                                   {"axis", "x, y or z", true, ParameterForm::kWord, "x y z"},
                                   {"reference", "a node along whose axis to measure", false, ParameterForm::kNodes}};
constexpr ParameterInfo kAxisRange[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"axis", "x, y or z", true, ParameterForm::kWord, "x y z"},
    {"reference", "a node along whose axis to measure", false, ParameterForm::kNodes},
    {"min", "the least number to select", false, ParameterForm::kNumber},
    {"max", "the greatest number to select", false, ParameterForm::kNumber},
    {"include_min", "false: more than min", false, ParameterForm::kWord, "true false"},
    {"include_max", "false: less than max", false, ParameterForm::kWord, "true false"}};
constexpr ParameterInfo kTwo[] = {{"a", "nodes", true, ParameterForm::kNodes},
                                  {"b", "nodes", true, ParameterForm::kNodes}};
constexpr ParameterInfo kTwoRange[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"b", "nodes", true, ParameterForm::kNodes},
    {"min", "the least share to select", false, ParameterForm::kNumber},
    {"max", "the greatest share to select", false, ParameterForm::kNumber},
    {"include_min", "false: more than min", false, ParameterForm::kWord, "true false"},
    {"include_max", "false: less than max", false, ParameterForm::kWord, "true false"}};
constexpr ParameterInfo kVolume[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"volume_type", "bbox, or scale: of the node's own scale", false, ParameterForm::kWord, "bbox scale"}};
constexpr ParameterInfo kVolumeRange[] = {
    {"a", "nodes", true, ParameterForm::kNodes},
    {"volume_type", "bbox, or scale: of the node's own scale", false, ParameterForm::kWord, "bbox scale"},
    {"min", "the least volume to select", false, ParameterForm::kNumber},
    {"max", "the greatest volume to select", false, ParameterForm::kNumber},
    {"include_min", "false: more than min", false, ParameterForm::kWord, "true false"},
    {"include_max", "false: less than max", false, ParameterForm::kWord, "true false"}};
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
       {"closest", "the least distance between an a and a b, and which they are", kDistance,
        MakeMeasure<MeasureDistance, 2>},
       {"farthest", "the greatest distance between an a and a b, and which they are", kDistance,
        MakeMeasure<MeasureDistance, 3>},
       {"axis_distance", "how far b's box is beyond a's along an axis", kAxis, MakeMeasure<MeasureAxisDistance, 0>},
       {"axis_distance_select", "each b within a range of such distances", kAxisRange,
        MakeMeasure<MeasureAxisDistance, 1>},
       {"overlap", "the share of a that is in b", kTwo, MakeMeasure<MeasureOverlap, 0>, Sharing::kNever},
       {"overlap_select", "each b within a range of such shares", kTwoRange, MakeMeasure<MeasureOverlap, 1>,
        Sharing::kNever},
       {"volume", "the volume of each node", kVolume,
        [](FilterParts parts) -> std::unique_ptr<Filter> { return std::make_unique<SizeFilter>(std::move(parts)); }},
       {"volume_select", "the nodes within a range of volumes", kVolumeRange,
        [](FilterParts parts) -> std::unique_ptr<Filter> {
          return std::make_unique<SizeSelectFilter>(std::move(parts));
        }},
       {"largest", "the greatest volume, and of which node", kVolume,
        [](FilterParts parts) -> std::unique_ptr<Filter> {
          return std::make_unique<SizeRankFilter>(std::move(parts), true);
        }},
       {"smallest", "the least volume, and of which node", kVolume,
        [](FilterParts parts) -> std::unique_ptr<Filter> {
          return std::make_unique<SizeRankFilter>(std::move(parts), false);
        }},
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
