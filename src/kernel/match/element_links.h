// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "kernel/base/plain_vector.h"
#include "kernel/match/network.h"

namespace soarbox::kernel {

/// The match's data on an element: the lists that contain it.
struct WmeLinks {
  std::uint32_t first_item = kNil;
  std::uint32_t first_token = kNil;
  std::uint32_t next = kNil, previous = kNil;  ///< In the list of all elements of the match, newest first.
  std::uint64_t serial : 62 = 0;  ///< Serial number of its arrival; after it began to leave, that of its departure.
  bool in_match : 1 = false;
  bool unsorted : 1 = false;  ///< The list of its tokens may be unsorted.
};
static_assert(sizeof(WmeLinks) == 24, "an agent has thousands");

/// The elements in the match, newest first, and the element that is leaving.
///
/// Invariants: an element is on the list exactly while it is in the match; once it begins to leave, `serial` is that of
/// its departure.
class ElementLinks {
 public:
  WmeLinks& operator[](std::uint32_t wme) { return links_[wme]; }
  const WmeLinks& operator[](std::uint32_t wme) const { return links_[wme]; }
  std::uint32_t newest() const { return newest_; }
  std::uint32_t count() const { return count_; }
  /// The highest time tag of all elements so far.
  std::uint64_t last_timetag() const { return last_timetag_; }
  void ForgetTimetags() { last_timetag_ = 0; }

  /// An element arrives. `room`: number of elements for which the table has space.
  [[gnu::always_inline]] void Enter(std::uint32_t wme, std::uint64_t serial, std::uint64_t timetag, std::size_t room) {
    if (wme >= links_.size()) {
      links_.resize(std::max<std::size_t>(wme + 1u, room));
    }
    WmeLinks& link = links_[wme];
    link.first_item = kNil;
    link.first_token = kNil;
    link.serial = last_serial_ = serial;
    link.in_match = true;
    link.unsorted = false;
    PutFirst(wme);
    ++count_;
    last_timetag_ = std::max(last_timetag_, timetag);
  }
  /// An element begins to leave: its items and tokens are removed.
  void BeginLeaving(std::uint32_t wme, std::uint64_t serial) {
    leaving_ = wme;
    arrival_of_leaving_ = links_[wme].serial;
    links_[wme].serial = last_serial_ = serial;
  }
  /// Replaces an element that leaves by another one with the same index. Nothing else may refer to it.
  void Renew(std::uint32_t wme, std::uint64_t serial, std::uint64_t timetag) {
    WmeLinks& link = links_[wme];
    link.serial = last_serial_ = serial;
    last_timetag_ = std::max(last_timetag_, timetag);
    if (newest_ != wme) {
      TakeOut(link);
      PutFirst(wme);
    }
  }
  /// The element has left.
  void Leave(WmeLinks& link) {
    TakeOut(link);
    link.in_match = false;
    --count_;
    leaving_ = kNil;
  }
  /// The element that is now leaving, or kNil.
  std::uint32_t leaving() const { return leaving_; }
  /// The serial number of the last event: an element arrived or began to leave.
  std::uint64_t last_serial() const { return last_serial_; }
  bool Holds(std::uint32_t wme) const { return wme < links_.size() && links_[wme].in_match; }
  /// The serial number of the arrival of an element of the match, even if it is leaving.
  std::uint64_t ArrivalOf(std::uint32_t wme) const {
    return wme == leaving_ ? arrival_of_leaving_ : links_[wme].serial;
  }

  /// Frees all memory.
  void Release() {
    links_ = PlainVector<WmeLinks>();
    newest_ = kNil;
    count_ = 0;
  }
  std::size_t MemoryBytes() const { return links_.capacity() * sizeof(WmeLinks); }

 private:
  /// Inserts an element at the head of the list of all elements.
  void PutFirst(std::uint32_t wme) {
    WmeLinks& link = links_[wme];
    link.previous = kNil;
    link.next = newest_;
    if (newest_ != kNil) {
      links_[newest_].previous = wme;
    }
    newest_ = wme;
  }
  void TakeOut(const WmeLinks& link) {
    if (link.next != kNil) {
      links_[link.next].previous = link.previous;
    }
    (link.previous != kNil ? links_[link.previous].next : newest_) = link.next;
  }

  PlainVector<WmeLinks> links_;
  std::uint32_t newest_ = kNil;
  std::uint32_t count_ = 0;
  std::uint32_t leaving_ = kNil;
  std::uint64_t arrival_of_leaving_ = 0;
  std::uint64_t last_serial_ = 0;
  std::uint64_t last_timetag_ = 0;
};

}  // namespace soarbox::kernel
