// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/semantic_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/longterm/spreading.h"

namespace soarbox::kernel {
namespace {

/// With this number of objects or fewer, an index of numbers is not worthwhile.
constexpr std::size_t kFewCandidates = 32;

bool Meets(const Terms& terms, StoreTerm value, const CueElement& element) {
  if (!value.IsNumber()) return false;
  const double number = terms.NumberValue(value);
  switch (element.math) {
    case MathTest::kLess:
      return number < element.bound;
    case MathTest::kGreater:
      return number > element.bound;
    case MathTest::kLessOrEqual:
      return number <= element.bound;
    case MathTest::kGreaterOrEqual:
      return number >= element.bound;
    default:
      return true;
  }
}

/// The largest (or smallest) number that an object has for an attribute; it must have one.
double Extreme(const Knowledge& knowledge, std::uint32_t object, const CueElement& element) {
  const bool largest = element.math == MathTest::kMax;
  bool any = false;
  double best = 0;
  for (const Edge& edge : knowledge.EdgesAt(object)) {
    if (edge.attribute != element.attribute || !edge.value.IsNumber()) continue;
    const double number = knowledge.terms().NumberValue(edge.value);
    if (!any || (largest ? number > best : number < best)) best = number;
    any = true;
  }
  return best;
}

}  // namespace

bool SemanticSearch::Better(const Candidate& a, const Candidate& b) {
  if (a.activation != b.activation) return a.activation > b.activation;
  if (a.is_large != b.is_large) return a.is_large;
  return a.row > b.row;
}

bool SemanticSearch::Has(const Terms& terms, std::span<const Edge> edges, const CueElement& element) {
  if (element.math != MathTest::kNone) {
    return std::ranges::any_of(edges, [&](const Edge& edge) {
      return edge.attribute == element.attribute && Meets(terms, edge.value, element);
    });
  }
  if (!element.value) {
    return std::ranges::any_of(edges, [&](const Edge& edge) { return edge.attribute == element.attribute; });
  }
  return std::ranges::any_of(
      edges, [&](const Edge& edge) { return edge.value == element.value && edge.attribute == element.attribute; });
}

bool SemanticSearch::Fits(const Knowledge& knowledge, const Cue& cue, const CueElement* driver, std::uint32_t object) {
  const std::span<const Edge> edges = knowledge.EdgesAt(object);
  for (const CueElement& element : cue.elements) {
    if (&element == driver && element.math == MathTest::kNone) continue;
    if (Has(knowledge.terms(), edges, element) == element.negative) return false;
  }
  return true;
}

std::uint32_t SemanticSearch::RowIn(const Knowledge& knowledge, std::uint32_t object, const CueElement& driver) {
  std::uint32_t row = 0;
  for (const Edge& edge : knowledge.EdgesAt(object)) {
    if (edge.attribute == driver.attribute && (!driver.value || edge.value == driver.value)) {
      row = std::max(row, edge.row);
    }
  }
  return row;
}

std::vector<std::uint32_t>& SemanticSearch::HotOf(const Knowledge& knowledge, std::uint32_t list,
                                                  const CueElement& driver) {
  const auto [place, added] = hot_.try_emplace(list);
  if (!added) return place->second;
  std::vector<std::uint32_t>& hot = place->second;
  const MemberList members = knowledge.ListAt(list);
  const std::span<const Activations::Touched> touched = activations_.records();
  if (touched.size() < members.slots()) {
    // The touched objects are often fewer than the members of the list.
    for (const Activations::Touched& record : touched) {
      if (RowIn(knowledge, record.object, driver) != 0) hot.push_back(record.object);
    }
  } else {
    members.ForEach([&](const Member& member) {
      if (activations_.Find(member.object) != nullptr) hot.push_back(member.object);
    });
  }
  std::ranges::sort(hot);
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());
  return hot;
}

const std::vector<SemanticSearch::Number>& SemanticSearch::NumbersOf(const Knowledge& knowledge, StoreTerm attribute) {
  const auto [place, added] = numbers_.try_emplace(attribute.bits());
  if (!added) return place->second;
  std::vector<Number>& numbers = place->second;
  const std::uint32_t list = knowledge.FindList(attribute, StoreTerm());
  if (list == Knowledge::kNowhere) return numbers;
  knowledge.ListAt(list).ForEach([&](const Member& member) {
    const std::span<const Edge> edges = knowledge.EdgesAt(member.object);
    const auto edge = std::ranges::find(edges, member.row, &Edge::row);
    if (!edge->value.IsNumber()) return;
    const double number = knowledge.terms().NumberValue(edge->value);
    if (number == number) numbers.push_back({number, member.object});
  });
  std::ranges::stable_sort(numbers, {}, &Number::number);
  return numbers;
}

void SemanticSearch::FirstTouched(const Knowledge& knowledge, std::uint32_t object) {
  if (hot_.empty()) return;
  for (const Edge& edge : knowledge.EdgesAt(object)) {
    for (const StoreTerm value : {edge.value, StoreTerm()}) {
      const auto hot = hot_.find(knowledge.FindList(edge.attribute, value));
      if (hot == hot_.end()) continue;
      if (std::ranges::find(hot->second, object) == hot->second.end()) hot->second.push_back(object);
    }
  }
}

double SemanticSearch::OwnActivation(const Knowledge& knowledge, std::uint32_t object) const {
  const Activations::Touched* const record = activations_.Find(object);
  if (record == nullptr) return 0;
  const bool is_large = knowledge.EdgesAt(object).size() >= settings_.thresh;
  const bool counts_as_new = settings_.activation_mode == ActivationMode::kFrequency ||
                             (settings_.activation_mode == ActivationMode::kRecency && is_large);
  return record->count == 0 && counts_as_new ? 0 : record->activation;
}

double SemanticSearch::ActivationOf(std::uint32_t object, const Spreading* spreading) const {
  const double base = activations_.Of(object);
  const Spreading::Gift* const gift = spreading == nullptr ? nullptr : spreading->GiftTo(object);
  return gift == nullptr ? base : (base != 0 ? base : gift->unused) + gift->share;
}

namespace {
/// The rarest requirement, and its list; null if a requirement cannot be met, or if there is none.
const CueElement* Driver(const Knowledge& knowledge, const Cue& cue, std::uint32_t& driving_list) {
  const CueElement* driver = nullptr;
  for (const CueElement& element : cue.elements) {
    if (element.negative) continue;
    const std::uint32_t list = knowledge.FindList(element.attribute, element.value);
    if (list == Knowledge::kNowhere) return nullptr;
    if (driver != nullptr && knowledge.ListAt(list).size() >= knowledge.ListAt(driving_list).size()) continue;
    driver = &element;
    driving_list = list;
  }
  return driver;
}
}  // namespace

std::uint32_t SemanticSearch::DrivingList(const Knowledge& knowledge, const Cue& cue) const {
  std::uint32_t list = Knowledge::kNowhere;
  return cue.impossible || Driver(knowledge, cue, list) == nullptr ? Knowledge::kNowhere : list;
}

std::vector<std::uint32_t> SemanticSearch::Find(const Knowledge& knowledge, const Cue& cue,
                                                std::span<const std::uint32_t> prohibited, std::size_t limit,
                                                const Spreading* spreading) {
  if (cue.impossible || limit == 0) return {};
  std::uint32_t driving_list = Knowledge::kNowhere;
  const CueElement* const driver = Driver(knowledge, cue, driving_list);
  if (driver == nullptr) return {};
  const MemberList list = knowledge.ListAt(driving_list);
  if (settings_.activation_mode == ActivationMode::kBaseLevel &&
      settings_.base_update_policy == BaseUpdatePolicy::kNaive) {
    list.ForEach([&](const Member& member) { activations_.Update(member.object); });
    hot_.erase(driving_list);
  }
  const auto is_prohibited = [&](std::uint32_t object) {
    return std::ranges::find(prohibited, object) != prohibited.end();
  };
  // A query may ask for the largest value of one attribute and the smallest of another.
  const CueElement* extreme = nullptr;
  const CueElement* second_extreme = nullptr;
  for (const CueElement& element : cue.elements) {
    if (element.math != MathTest::kMax && element.math != MathTest::kMin) continue;
    (extreme == nullptr ? extreme : second_extreme) = &element;
  }

  // With base-level activation, any object that was ever used is more active than one that was not.
  const double cold_activation =
      settings_.activation_mode == ActivationMode::kBaseLevel ? -std::numeric_limits<double>::infinity() : 0;
  const auto with_spread = [&](std::uint32_t object) {
    const bool is_cold = !spreading->Reaches(object) && activations_.Find(object) == nullptr;
    return is_cold ? cold_activation : ActivationOf(object, spreading);
  };
  // For objects that were touched, or that activation spreads to.
  const auto candidate = [&](std::uint32_t object) {
    Candidate made;
    made.object = object;
    made.activation = OwnActivation(knowledge, object);
    if (spreading == nullptr && activations_.Find(object) == nullptr) made.activation = cold_activation;
    if (spreading != nullptr) made.activation = with_spread(object);
    made.is_large = activations_.Find(object) != nullptr && knowledge.EdgesAt(object).size() >= settings_.thresh;
    made.row = RowIn(knowledge, object, *driver);
    return made;
  };
  const auto is_cold = [&](std::uint32_t object) {
    return activations_.Find(object) == nullptr && (spreading == nullptr || !spreading->Reaches(object));
  };
  if (extreme != nullptr && second_extreme == nullptr && limit == 1 && list.size() > kFewCandidates) {
    // Starts at the requested end: the first number of any object that fits. Of objects with equal numbers the best one
    // wins.
    const std::vector<Number>& numbers = NumbersOf(knowledge, extreme->attribute);
    const std::size_t count = numbers.size();
    const auto nth = [&](std::size_t n) -> const Number& {
      return extreme->math == MathTest::kMax ? numbers[count - 1 - n] : numbers[n];
    };
    std::vector<Candidate> best;
    for (std::size_t n = 0; n < count; ++n) {
      if (!best.empty() && nth(n).number != nth(n - 1).number) break;
      const std::uint32_t object = nth(n).object;
      if (is_prohibited(object) || !Fits(knowledge, cue, nullptr, object)) continue;
      const Candidate made = candidate(object);
      if (best.empty()) {
        best.push_back(made);
      } else if (Better(made, best.front())) {
        best.front() = made;
      }
    }
    return best.empty() ? std::vector<std::uint32_t>() : std::vector<std::uint32_t>{best.front().object};
  }
  std::vector<Candidate>& hot = candidates_;
  hot.clear();
  const bool one_is_enough = limit == 1 && extreme == nullptr;
  const auto consider = [&](std::uint32_t object) {
    if (one_is_enough && !hot.empty()) {
      // Most candidates can be excluded by their activation alone.
      double activation = OwnActivation(knowledge, object);
      if (spreading != nullptr) activation = with_spread(object);
      if (activation < hot.front().activation) return;
    }
    if (is_prohibited(object) || !Fits(knowledge, cue, driver, object)) return;
    const Candidate made = candidate(object);
    if (!one_is_enough || hot.empty()) {
      hot.push_back(made);
    } else if (Better(made, hot.front())) {
      hot.front() = made;
    }
  };
  for (const std::uint32_t object : HotOf(knowledge, driving_list, *driver)) {
    if (activations_.Find(object) != nullptr) consider(object);
  }
  if (spreading != nullptr) {
    for (const auto& [object, gift] : spreading->shares()) {
      if (activations_.Find(object) == nullptr && RowIn(knowledge, object, *driver) != 0) consider(object);
    }
  }
  std::ranges::sort(hot, Better);

  // Merges the other objects: they have equal activation, and the newest row is first.
  std::vector<std::uint32_t> found;
  std::size_t next_hot = 0;
  std::size_t next_cold = list.slots();
  std::vector<std::uint32_t> seen;  // If any value of the attribute matches, an object may be in the list several
                                    // times.
  bool has_best = false;
  double best = 0, second_best = 0;
  const auto improves = [](const CueElement& element, double number, double least) {
    return element.math == MathTest::kMax ? number > least : number < least;
  };
  const auto take = [&](std::uint32_t object) {
    if (extreme == nullptr) {
      found.push_back(object);
      return found.size() >= limit;
    }
    // An object must be better in all requested extremes to replace the best one.
    const double number = Extreme(knowledge, object, *extreme);
    const double second = second_extreme == nullptr ? 0 : Extreme(knowledge, object, *second_extreme);
    const bool is_better = improves(*extreme, number, best) &&
                           (second_extreme == nullptr || improves(*second_extreme, second, second_best));
    if (!has_best || is_better) {
      found.assign(1, object);
      best = number;
      second_best = second;
      has_best = true;
    }
    return false;
  };
  while (true) {
    if (next_hot < hot.size() && hot[next_hot].activation > cold_activation) {
      if (take(hot[next_hot++].object)) break;
      continue;
    }
    std::uint32_t cold = Knowledge::kNowhere;
    while (next_cold > 0) {
      const std::uint32_t object = list.At(next_cold - 1).object;
      const bool again = !driver->value && std::ranges::find(seen, object) != seen.end();
      if (!again && !list.IsHidden(next_cold - 1) && Fits(knowledge, cue, driver, object) && is_cold(object) &&
          !is_prohibited(object)) {
        cold = object;
        break;
      }
      --next_cold;
    }
    const bool has_hot = next_hot < hot.size();
    if (!has_hot && cold == Knowledge::kNowhere) break;
    Candidate passive;
    passive.object = cold;
    passive.activation = cold_activation;
    passive.row = next_cold > 0 ? list.At(next_cold - 1).row : 0;
    if (has_hot && (cold == Knowledge::kNowhere || Better(hot[next_hot], passive))) {
      if (take(hot[next_hot++].object)) break;
      continue;
    }
    --next_cold;
    const auto has_attribute = [&](const Edge& edge) { return edge.attribute == driver->attribute; };
    if (!driver->value && std::ranges::count_if(knowledge.EdgesAt(cold), has_attribute) > 1) seen.push_back(cold);
    if (take(cold)) break;
  }
  return found;
}

}  // namespace soarbox::kernel
