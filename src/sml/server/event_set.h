// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <initializer_list>

#include "sml/client/sml_Events.h"

namespace soarbox::server {

/// A set of events, by their numbers (sml_Events.h).
class EventSet {
 public:
  constexpr EventSet() = default;
  constexpr EventSet(std::initializer_list<int> events) {
    for (const int event : events) Add(event);
  }

  constexpr void Add(int event) { bits_ |= Bit(event); }
  void Remove(int event) { bits_ &= ~Bit(event); }
  void Add(EventSet other) { bits_ |= other.bits_; }
  bool Has(int event) const { return (bits_ & Bit(event)) != 0; }
  bool HasAnyOf(int first, int last) const {
    return ((bits_ >> first) & ((std::uint64_t{1} << (last - first + 1)) - 1)) != 0;
  }
  bool HasAnyOf(EventSet other) const { return (bits_ & other.bits_) != 0; }
  bool empty() const { return bits_ == 0; }
  void Clear() { bits_ = 0; }

 private:
  static constexpr std::uint64_t Bit(int event) { return std::uint64_t{1} << event; }

  std::uint64_t bits_ = 0;
};

static_assert(::sml::smlEVENT_LAST <= 64);

}  // namespace soarbox::server
