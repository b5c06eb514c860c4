// SPDX-License-Identifier: BSD-2-Clause
// Compares semantic memory with a model without indices: each cue is matched against all objects, and each activation
// is computed from all earlier touches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"
#include "kernel/longterm/semantic_query.h"
#include "kernel/longterm/semantic_records.h"

namespace soarbox::kernel {
namespace {

struct NaiveEdge {
  int attribute, value, row;
};

struct NaiveObject {
  std::vector<NaiveEdge> edges;
  std::vector<std::uint64_t> touches;
};

struct NaiveDemand {
  int attribute, value;  ///< value -1: any value.
  bool negative = false;
};

class NaiveMemory {
 public:
  explicit NaiveMemory(const SmemSettings& settings) : settings_(settings) {}

  std::map<Lti, NaiveObject> objects;
  std::uint64_t clock = 0;
  std::map<Lti, double> kept;  ///< Base-level activation as computed at the last touch.

  void Touch(Lti number) {
    ++clock;
    NaiveObject& object = objects[number];
    object.touches.push_back(clock);
    double sum = 0;
    const std::size_t count = object.touches.size();
    for (std::size_t n = 0; n < count && n < 10; ++n) {
      sum += std::pow(static_cast<double>(clock + 1 - object.touches[count - 1 - n]), -settings_.base_decay);
    }
    if (count > 10) {
      const double first = static_cast<double>(clock + 1 - object.touches[0]);
      const double tenth = static_cast<double>(clock + 1 - object.touches[count - 10]);
      const double d = settings_.base_decay;
      sum += static_cast<double>(count - 10) * (std::pow(first, 1 - d) - std::pow(tenth, 1 - d)) /
             ((1 - d) * (first - tenth));
    }
    kept[number] = std::log(sum / (1 + sum));
  }

  double ActivationOf(Lti number) const {
    const NaiveObject& object = objects.at(number);
    if (object.touches.empty()) return 0;
    if (settings_.activation_mode == ActivationMode::kRecency) return static_cast<double>(object.touches.back());
    if (settings_.activation_mode == ActivationMode::kFrequency) return static_cast<double>(object.touches.size());
    return kept.at(number);
  }

  /// With base-level activation, any object that was ever used precedes those that were not.
  double RankOf(Lti number) const {
    const bool is_cold = settings_.activation_mode == ActivationMode::kBaseLevel && objects.at(number).touches.empty();
    return is_cold ? -1e300 : ActivationOf(number);
  }

  static bool Has(const NaiveObject& object, const NaiveDemand& demand) {
    for (const NaiveEdge& edge : object.edges) {
      if (edge.attribute == demand.attribute && (demand.value < 0 || edge.value == demand.value)) return true;
    }
    return false;
  }

  /// The largest or smallest numeric value (numbers are multiples of 3) of an object's attribute.
  static std::optional<int> Extreme(const NaiveObject& object, int attribute, bool largest) {
    std::optional<int> best;
    for (const NaiveEdge& edge : object.edges) {
      if (edge.attribute != attribute || edge.value % 3 != 0) continue;
      if (!best || (largest ? edge.value > *best : edge.value < *best)) best = edge.value;
    }
    return best;
  }

  /// `extreme`: the attribute whose largest or smallest number is requested; negative: none.
  std::optional<Lti> Find(const std::vector<NaiveDemand>& cue, const std::set<Lti>& prohibited, int extreme = -1,
                          bool largest = true) const {
    const NaiveDemand* driver = nullptr;
    std::size_t fewest = 0;
    for (const NaiveDemand& demand : cue) {
      if (demand.negative) continue;
      std::size_t count = 0;
      for (const auto& [number, object] : objects) {
        for (const NaiveEdge& edge : object.edges) {
          count += edge.attribute == demand.attribute && (demand.value < 0 || edge.value == demand.value) ? 1 : 0;
        }
      }
      if (driver == nullptr || count < fewest) {
        driver = &demand;
        fewest = count;
      }
    }
    if (driver == nullptr) return {};
    std::optional<Lti> best;
    std::tuple<int, double, bool, int> rank;
    for (const auto& [number, object] : objects) {
      bool fits = !prohibited.contains(number);
      for (const NaiveDemand& demand : cue) fits = fits && Has(object, demand) != demand.negative;
      const std::optional<int> number_of = extreme < 0 ? 0 : Extreme(object, extreme, largest);
      if (!fits || !number_of) continue;
      int row = 0;
      for (const NaiveEdge& edge : object.edges) {
        const bool drives = edge.attribute == driver->attribute && (driver->value < 0 || edge.value == driver->value);
        if (drives) row = std::max(row, edge.row);
      }
      const bool large = !object.touches.empty() && object.edges.size() >= settings_.thresh;
      const std::tuple<int, double, bool, int> own(largest ? *number_of : -*number_of, RankOf(number), large, row);
      if (best && own <= rank) continue;
      best = number;
      rank = own;
    }
    return best;
  }

 private:
  const SmemSettings& settings_;
};

class RandomMemory {
 public:
  explicit RandomMemory(unsigned seed)
      : random_(seed), naive_(settings_), activations_(settings_), search_(settings_, activations_) {
    constexpr ActivationMode kModes[] = {ActivationMode::kRecency, ActivationMode::kFrequency,
                                         ActivationMode::kBaseLevel};
    settings_.activation_mode = kModes[seed % 3];
    settings_.thresh = 2 + seed % 5;
    objects_ = seed % 4 == 0 ? 150 : 12;
  }

  /// Another agent with the same knowledge and a copy of the first agent's history. From now on both change their
  /// layers.
  RandomMemory(RandomMemory& other, unsigned seed)
      : random_(seed),
        settings_(other.settings_),
        naive_(settings_),
        activations_(settings_),
        search_(settings_, activations_),
        row_(other.row_),
        objects_(other.objects_) {
    naive_.objects = other.naive_.objects;
    naive_.clock = other.naive_.clock;
    naive_.kept = other.naive_.kept;
    const std::vector<Activations::Touched> touched(other.activations_.records().begin(),
                                                    other.activations_.records().end());
    activations_.Restore(other.activations_.tick(), touched);
    if (!other.knowledge_->is_layer()) {
      other.base_ = other.knowledge_;
      other.knowledge_ = std::make_shared<Knowledge>(other.base_);
      other.search_.Forget();
    }
    base_ = other.base_;
    knowledge_ = std::make_shared<Knowledge>(base_);
  }

  std::string Image() const { return records::Image(*knowledge_, activations_, LinkWeights(settings_)); }
  const Knowledge& knowledge() const { return *knowledge_; }

  void Step() {
    switch (random_() % 10) {
      case 0:
      case 1:
      case 2:
        Add();
        break;
      case 3:
        Remove();
        break;
      case 4:
      case 5:
        Touch(Some());
        break;
      default:
        Query();
    }
  }

  void Check() {
    EXPECT_EQ(knowledge_->CheckInvariants(), "");
    for (const auto& [number, object] : naive_.objects) {
      EXPECT_NEAR(activations_.Of(knowledge_->Find(number)), naive_.ActivationOf(number), 1e-12);
    }
    const std::string image = Image();
    Knowledge again;
    Activations active(settings_);
    LinkWeights weights(settings_);
    ASSERT_TRUE(records::ReadImage(image, again, active, weights));
    EXPECT_EQ(again.CheckInvariants(), "");
    EXPECT_TRUE(image == records::Image(again, active, weights)) << "an image that is read gives the same image";
  }

 private:
  StoreTerm Attribute(int number) { return knowledge_->terms().String("a" + std::to_string(number)); }
  StoreTerm Value(int number) {
    if (number % 3 == 0) return knowledge_->terms().Integer(number);
    return knowledge_->terms().String("v" + std::to_string(number));
  }
  int AnyAttribute() { return static_cast<int>(random_() % 4); }
  /// Low numbers are common.
  int AnyValue() { return static_cast<int>((random_() % 4) * (random_() % 4)); }
  Lti Some() { return 1 + random_() % objects_; }

  void Add() {
    const Lti number = Some();
    const int attribute = AnyAttribute(), value = AnyValue();
    NaiveObject& object = naive_.objects[number];
    const bool there = NaiveMemory::Has(object, {attribute, value});
    if (!there) object.edges.push_back({attribute, value, ++row_});
    EXPECT_EQ(knowledge_->AddEdge(knowledge_->FindOrAdd(number), Attribute(attribute), Value(value)), !there);
    search_.Forget(Attribute(attribute));
  }

  void Remove() {
    const Lti number = Some();
    const int attribute = AnyAttribute(), value = AnyValue();
    const std::uint32_t place = knowledge_->FindOrAdd(number);
    NaiveObject& object = naive_.objects[number];
    const auto gone = std::erase_if(
        object.edges, [&](const NaiveEdge& edge) { return edge.attribute == attribute && edge.value == value; });
    EXPECT_EQ(knowledge_->RemoveEdge(place, Attribute(attribute), Value(value)), gone == 1);
    search_.Forget(Attribute(attribute));
  }

  void Touch(Lti number) {
    const std::uint32_t place = knowledge_->FindOrAdd(number);
    naive_.Touch(number);
    if (activations_.Touch(place)) search_.FirstTouched(*knowledge_, place);
  }

  void Query() {
    std::vector<NaiveDemand> demands;
    Cue cue;
    const int size = 1 + static_cast<int>(random_() % 3);
    for (int n = 0; n < size; ++n) {
      const NaiveDemand demand{AnyAttribute(), random_() % 4 == 0 ? -1 : AnyValue(), n > 0 && random_() % 4 == 0};
      demands.push_back(demand);
      cue.elements.push_back(
          {Attribute(demand.attribute), demand.value < 0 ? StoreTerm() : Value(demand.value), demand.negative});
    }
    std::set<Lti> prohibited;
    std::vector<std::uint32_t> places;
    for (int n = 0; n < 2; ++n) {
      if (random_() % 3 != 0) continue;
      const Lti number = Some();
      if (knowledge_->Find(number) == Knowledge::kNowhere || !prohibited.insert(number).second) continue;
      places.push_back(knowledge_->Find(number));
    }
    const int extreme = random_() % 3 == 0 ? AnyAttribute() : -1;
    const bool largest = random_() % 2 == 0;
    if (extreme >= 0) {
      CueElement test{Attribute(extreme), StoreTerm()};
      test.math = largest ? MathTest::kMax : MathTest::kMin;
      cue.elements.push_back(test);
      demands.push_back({extreme, -1});
    }
    const std::vector<std::uint32_t> found = search_.Find(*knowledge_, cue, places, 1);
    const std::optional<Lti> expected = naive_.Find(demands, prohibited, extreme, largest);
    ASSERT_EQ(found.empty(), !expected.has_value());
    if (!expected) return;
    ASSERT_EQ(knowledge_->NumberAt(found.front()), *expected);
    Touch(*expected);
  }

  std::mt19937 random_;
  SmemSettings settings_;
  NaiveMemory naive_;
  std::shared_ptr<const Knowledge> base_;
  std::shared_ptr<Knowledge> knowledge_ = std::make_shared<Knowledge>();
  Activations activations_;
  SemanticSearch search_;
  int row_ = 0;
  std::uint32_t objects_ = 12;
};

TEST(SemanticSearch, AnswersAsAModelWithoutIndicesDoes) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomMemory memory(seed);
    for (int step = 0; step < 600; ++step) {
      memory.Step();
      if (::testing::Test::HasFatalFailure()) return;
    }
    memory.Check();
  }
}

/// Agents with shared knowledge, compared with the same model: changes of one agent are not visible to others.
TEST(SharedKnowledge, LayersAnswerAsAModelOfTheirOwnDoes) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomMemory first(seed);
    for (int step = 0; step < 300; ++step) first.Step();
    const std::string before = first.Image();
    RandomMemory second(first, seed + 1000), third(first, seed + 2000);
    ASSERT_TRUE(second.knowledge().is_layer());
    EXPECT_EQ(third.Image(), before);
    for (int step = 0; step < 300; ++step) {
      first.Step();
      second.Step();
      if (::testing::Test::HasFatalFailure()) return;
    }
    first.Check();
    second.Check();
    EXPECT_EQ(third.Image(), before);
    EXPECT_EQ(third.knowledge().CheckInvariants(), "");
  }
}

/// The size of a layer depends on its changes, not on the size of the base.
TEST(SharedKnowledge, ALayerCostsWhatItChanges) {
  const auto known = std::make_shared<Knowledge>();
  const StoreTerm kind = known->terms().String("kind"), thing = known->terms().String("thing");
  const StoreTerm number = known->terms().String("number");
  for (int n = 0; n < 20'000; ++n) {
    const std::uint32_t object = known->AddNew();
    known->AddEdge(object, kind, thing);
    known->AddEdge(object, number, known->terms().Integer(n));
  }
  const std::shared_ptr<const Knowledge> base = known;
  Knowledge layer(base);
  EXPECT_EQ(layer.object_count(), 20'000u);
  const std::uint32_t made = layer.AddNew();
  EXPECT_EQ(layer.NumberAt(made), 20'001u);
  EXPECT_TRUE(layer.AddEdge(made, kind, thing));
  EXPECT_FALSE(layer.AddEdge(5, kind, thing));
  EXPECT_TRUE(layer.RemoveEdge(5, kind, thing));
  EXPECT_EQ(layer.ListAt(layer.FindList(kind, thing)).size(), 20'000u);
  EXPECT_EQ(base->ListAt(base->FindList(kind, thing)).size(), 20'000u);
  EXPECT_LT(layer.MemoryBytes(), 5'000u);
  EXPECT_GT(base->MemoryBytes(), 1'000'000u);
  EXPECT_EQ(layer.CheckInvariants(), "");
}

TEST(LinkWeights, LinksThatAreUsedGainAndOthersLose) {
  SmemSettings settings;
  settings.spreading_edge_update_factor = 0.8;
  Knowledge knowledge;
  const std::uint32_t hub = knowledge.AddNew(), left = knowledge.AddNew(), right = knowledge.AddNew();
  const StoreTerm next = knowledge.terms().String("next");
  for (const std::uint32_t object : {left, right}) knowledge.AddEdge(hub, next, StoreTerm::Object(object));
  LinkWeights weights(settings);
  EXPECT_EQ(weights.Of(knowledge, hub), nullptr);
  // In the first cycle, weights decrease only by normalization: 0.6 and 0.5.
  weights.Use(knowledge, hub, left, 1);
  ASSERT_NE(weights.Of(knowledge, hub), nullptr);
  EXPECT_NEAR(weights.Of(knowledge, hub)->at(left), 0.6 / 1.1, 1e-9);
  EXPECT_NEAR(weights.Of(knowledge, hub)->at(right), 0.5 / 1.1, 1e-9);
  weights.Use(knowledge, hub, right, 2);
  weights.Use(knowledge, hub, right, 2);
  EXPECT_NEAR(weights.Of(knowledge, hub)->at(right), 0.5522, 1e-4);
  // In the second of two cycles, unused links lose weight.
  weights.Use(knowledge, hub, left, 3);
  weights.Use(knowledge, hub, left, 4);
  EXPECT_NEAR(weights.Of(knowledge, hub)->at(left), 0.6022, 1e-4);
  EXPECT_NEAR(weights.Of(knowledge, hub)->at(right), 0.3978, 1e-4);
  weights.Forget(hub);
  EXPECT_EQ(weights.Of(knowledge, hub), nullptr);
}

TEST(LinkWeights, TheyAreGivenToAllLinksOrNone) {
  const SmemSettings settings;
  Knowledge knowledge;
  const std::uint32_t hub = knowledge.AddNew(), left = knowledge.AddNew(), right = knowledge.AddNew();
  const StoreTerm next = knowledge.terms().String("next");
  for (const std::uint32_t object : {left, right}) knowledge.AddEdge(hub, next, StoreTerm::Object(object));
  LinkWeights weights(settings);
  weights.NoteChanges(true);
  EXPECT_FALSE(weights.Set(knowledge, hub, {{left, 1}}));
  EXPECT_FALSE(weights.Set(knowledge, hub, {{left, 1}, {hub, 1}}));
  EXPECT_FALSE(weights.Set(knowledge, left, {}));
  EXPECT_THAT(weights.TakeChanged(), testing::IsEmpty());
  EXPECT_TRUE(weights.Set(knowledge, hub, {{left, 0.25}, {right, 0.5}}));
  weights.Use(knowledge, hub, left, 1);
  EXPECT_EQ(weights.Known(hub)->at(left), 0.25);
  EXPECT_GT(weights.Of(knowledge, hub)->at(left), 0.25);
  EXPECT_THAT(weights.TakeChanged(), testing::ElementsAre(hub, hub));
}

TEST(SemanticRecords, ImagesWithoutWeightsAreRead) {
  const SmemSettings settings;
  Knowledge knowledge;
  const Activations activations(settings);
  LinkWeights weights(settings);
  const std::uint32_t hub = knowledge.FindOrAdd(3);
  const StoreTerm next = knowledge.terms().String("next");
  knowledge.AddEdge(hub, next, StoreTerm::Object(hub));
  std::string old = records::Image(knowledge, activations, weights);
  old.pop_back();
  ASSERT_EQ(old[1], 2);
  old[1] = 1;
  Knowledge read;
  Activations active(settings);
  EXPECT_TRUE(records::ReadImage(old, read, active, weights));
  EXPECT_EQ(read.edge_count(), 1u);
  weights.Set(knowledge, hub, {{hub, 0.75}});
  const std::string record = records::Weights(knowledge, hub, *weights.Known(hub));
  LinkWeights again(settings);
  EXPECT_TRUE(records::Apply(record, read, active, again));
  EXPECT_EQ(again.Known(read.Find(3))->at(read.Find(3)), 0.75);
}

TEST(SemanticRecords, BytesThatLieAreRefused) {
  SmemSettings settings;
  Knowledge knowledge;
  Activations activations(settings);
  const std::uint32_t object = knowledge.FindOrAdd(3);
  knowledge.AddEdge(object, knowledge.terms().String("name"), knowledge.terms().Float(2.5));
  knowledge.AddEdge(object, knowledge.terms().String("self"), StoreTerm::Object(object));
  activations.Touch(object);
  LinkWeights weights(settings);
  weights.Set(knowledge, object, {{object, 0.5}});
  const std::string whole = records::Image(knowledge, activations, weights);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Knowledge read;
    Activations active(settings);
    LinkWeights links(settings);
    EXPECT_FALSE(records::ReadImage(std::string_view(whole).substr(0, size), read, active, links)) << size;
  }
  std::mt19937 random(5);
  for (int n = 0; n < 3000; ++n) {
    std::string spoilt = whole;
    spoilt[random() % spoilt.size()] = static_cast<char>(random());
    Knowledge read;
    Activations active(settings);
    LinkWeights links(settings);
    if (records::ReadImage(spoilt, read, active, links)) {
      EXPECT_EQ(read.CheckInvariants(), "");
    }
    std::string noise(random() % 20, '\0');
    for (char& byte : noise) byte = static_cast<char>(random() % 13);
    static_cast<void>(records::Apply(noise, read, active, links));
    EXPECT_EQ(read.CheckInvariants(), "");
  }
}

}  // namespace
}  // namespace soarbox::kernel
