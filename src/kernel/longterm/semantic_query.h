// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/store_term.h"

namespace soarbox::kernel {

class Spreading;

enum class MathTest : std::uint8_t { kNone, kLess, kGreater, kLessOrEqual, kGreaterOrEqual, kMax, kMin };

/// One requirement on an object.
struct CueElement {
  StoreTerm attribute;
  StoreTerm value;        ///< None: any value.
  bool negative = false;  ///< The object must not have the value.
  MathTest math = MathTest::kNone;
  double bound = 0;  ///< For a math test, except those for the largest and the smallest value.
};

/// The requirements of a query. A term that the store does not contain is none; `impossible` is set if a requirement
/// needs such a term.
struct Cue {
  std::vector<CueElement> elements;
  bool impossible = false;
  bool takes_last = false;  ///< The result is the last object that fits, not the first.

  void Clear() {
    elements.clear();
    impossible = takes_last = false;
  }
};

/// Finds the objects that fit a cue, the most active first. Among objects with equal activation, an object with many
/// augmentations (SmemSettings::thresh) is first if it was ever touched; then the one whose augmentation in the list of
/// the rarest requirement is the newest.
///
/// Only objects that meet the rarest requirement are examined (the driving list). Objects that were never touched are
/// equally active and are in the right order already. Touched ones are stored separately, for each list that was ever
/// the driving one.
class SemanticSearch {
 public:
  SemanticSearch(const SmemSettings& settings, Activations& activations)
      : settings_(settings), activations_(activations) {}

  /// The places of up to `limit` objects, best first. With `spreading`, its share is added to their activations.
  std::vector<std::uint32_t> Find(const Knowledge& knowledge, const Cue& cue, std::span<const std::uint32_t> prohibited,
                                  std::size_t limit, const Spreading* spreading = nullptr);
  /// The list of the rarest requirement, whose members are the candidates; kNowhere if no object meets one of the
  /// requirements.
  std::uint32_t DrivingList(const Knowledge& knowledge, const Cue& cue) const;
  /// The activation of an object, including its share if `spreading` is given.
  double ActivationOf(std::uint32_t object, const Spreading* spreading) const;
  /// Call when an object is touched for the first time.
  void FirstTouched(const Knowledge& knowledge, std::uint32_t object);
  /// Call before or after augmentations of an object with this attribute change.
  void Forget(StoreTerm attribute) {
    hot_.clear();
    numbers_.erase(attribute.bits());
  }
  void Forget() {
    hot_.clear();
    numbers_.clear();
  }

 private:
  struct Candidate {
    double activation = 0;
    bool is_large = false;
    std::uint32_t row = 0;
    std::uint32_t object = 0;
  };
  struct Number {
    double number;
    std::uint32_t object;
  };
  /// The activation of an object alone. An object that was stored but never used has activation 0 in mode frequency.
  /// In mode recency, it has activation 0 if it has at least SmemSettings::thresh augmentations.
  double OwnActivation(const Knowledge& knowledge, std::uint32_t object) const;
  static bool Better(const Candidate& a, const Candidate& b);
  /// The numeric values of an attribute with their objects, sorted.
  const std::vector<Number>& NumbersOf(const Knowledge& knowledge, StoreTerm attribute);
  static bool Has(const Terms& terms, std::span<const Edge> edges, const CueElement& element);
  static bool Fits(const Knowledge& knowledge, const Cue& cue, const CueElement* driver, std::uint32_t object);
  std::vector<std::uint32_t>& HotOf(const Knowledge& knowledge, std::uint32_t list, const CueElement& driver);
  static std::uint32_t RowIn(const Knowledge& knowledge, std::uint32_t object, const CueElement& driver);

  const SmemSettings& settings_;
  Activations& activations_;
  std::vector<Candidate> candidates_;                               ///< For the current query.
  std::unordered_map<std::uint32_t, std::vector<Number>> numbers_;  ///< By attribute, for attributes that were needed.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> hot_;  ///< By list: its touched members.
};

}  // namespace soarbox::kernel
