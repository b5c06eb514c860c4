// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/meeting_order.h"

#include <algorithm>
#include <utility>

namespace soarbox::kernel {

/// Whether a token of a path was created when its element arrived, and not when the token above it was created.
bool MeetingOrder::CameWithElement(const Token& token) const {
  // The first token of a path counts as such a token, so that searches end below the anchor.
  const Token& above = tokens_[token.parent];
  return above.parent == kNil || elements_.ArrivalOf(token.wme) > above.serial;
}

OwnerAndPath MeetingOrder::Meeting(std::uint32_t owner, std::uint32_t prefix) const {
  OwnerAndPath meeting;
  meeting.owner = owner;
  meeting.prefix = prefix;
  meeting.node = tokens_[owner].node & Token::kNodeMask;
  meeting.serial = tokens_[owner].serial;
  return meeting;
}

bool MeetingOrder::CameLater(const OwnerAndPath& a, const OwnerAndPath& b) const {
  if (a.serial == b.serial && a.prefix == b.prefix) {
    return a.place > b.place;
  }
  OwnerAndPath x = a;
  OwnerAndPath y = b;
  for (;;) {
    for (OwnerAndPath* meeting : {&x, &y}) {
      while (tokens_[meeting->prefix].parent != kNil && !CameWithElement(tokens_[meeting->prefix])) {
        meeting->prefix = tokens_[meeting->prefix].parent;
      }
    }
    const Token& of_x = tokens_[x.prefix];
    const Token& of_y = tokens_[y.prefix];
    const bool same_element = x.serial < of_x.serial && y.serial < of_y.serial && of_x.wme == of_y.wme &&
                              of_x.node == of_y.node && of_x.parent != kNil;
    if (!same_element) {
      const std::uint64_t made_x = std::max(x.serial, of_x.serial);
      const std::uint64_t made_y = std::max(y.serial, of_y.serial);
      return made_x != made_y ? made_x > made_y : x.serial != y.serial ? x.serial > y.serial : a.place > b.place;
    }
    if (x.serial == y.serial && x.prefix == y.prefix) {
      return a.place > b.place;
    }
    // One element completed both. Then it was joined first with the newest token.
    x.prefix = of_x.parent;
    y.prefix = of_y.parent;
    std::swap(x, y);
  }
}

}  // namespace soarbox::kernel
