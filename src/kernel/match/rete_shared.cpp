// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/match/rete_inline.h"

/// Shared conjunctions: most conjunctive negations look from one object along a path of elements for something that
/// beats or excludes what has been matched (no other task of the class ranks higher, no slot of the zone is free).
/// Matched below each token they make as many partial matches as there are tokens times elements. Where the conditions
/// form a path that begins at one identifier, they are matched once per identifier instead: its *anchor*. The tokens
/// that wait for the conjunction, its *owners*, meet complete paths by the anchor and what else must be equal; the
/// other comparisons of the two are made there, and only what blocks an owner becomes a record.
///
/// An anchor lives while it has owners, and comparisons with owners come last (rete_builder_shared.cpp). So there are
/// about as many paths per identifier as there would otherwise be partial matches per token.
///
/// Nothing that can be observed depends on it: owners are blocked and opened in the order in which the partial matches
/// (owner, path) would have been made and removed. That order follows from serial numbers: such a match is made when
/// the later one of the two arrives; when that is the path, and an element completed it, the owners are met in the
/// reverse of the order in which they met what was there of the path before.
namespace soarbox::kernel {

// Meeting -------------------------------------------------------------------------------------------------------------

/// Whether a path that has an owner's key blocks it.
bool ReteState::Pairs(std::uint32_t owner, std::uint32_t path) const {
  const Network& net = *network;
  const Token& left = tokens[owner];
  const Token& right = tokens[path];
  const Node& node = net.node(left.node & Token::kNodeMask);
  const Node& paths = net.node(right.node & Token::kNodeMask);
  const Records<const Token> all = tokens.records();
  if (node.key == KeyKind::kIdValue &&
      FieldOf(wmes.data()[ElementAt(all, left.parent, left.wme, node.key_id_levels)], node.key_id_field) !=
          FieldOf(wmes.data()[ElementAt(all, right.parent, right.wme, paths.key_id_levels)], Field::kId)) {
    return false;
  }
  for (const NodeTest& test : net.tests(node)) {
    const Wme& element = wmes.data()[ElementAt(all, right.parent, right.wme, test.count)];
    if (!PassesOne(test, left.parent, left.wme, element)) {
      return false;
    }
  }
  return true;
}

/// Whether an element is part of a path.
bool ReteState::Holds(std::uint32_t path, std::uint32_t wme) const {
  while (tokens[path].parent != kNil && tokens[path].wme != wme) {
    path = tokens[path].parent;
  }
  return tokens[path].parent != kNil;
}

std::uint32_t ReteState::AnchorOf(std::uint32_t token) const {
  while (tokens[token].parent != kNil) {
    token = tokens[token].parent;
  }
  return token;
}

void ReteState::LeftShared(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(index);
  const std::uint32_t anchors = node.ancestor;
  const std::uint32_t paths = network->node(node.partner()).parent;
  const KeyParts key = KeyOfPair(*this, node, parent, wme);
  std::uint32_t anchor = BucketHead(*this, anchors, key.id);
  while (anchor != kNil && tokens[anchor].key != key.id) {
    anchor = tokens[anchor].next_in_bucket;
  }
  if (anchor == kNil) {
    anchor = MakeAnchor(anchors, key.id);
    new_paths.clear();  // There is nobody else that they might block.
    tokens[anchor].previous_sibling = 0;
  }
  ++tokens[anchor].previous_sibling;
  // What is emitted once to several conjunctions reaches them all at once.
  const bool again = last_owner != kNil && tokens[last_owner].parent == parent && tokens[last_owner].wme == wme &&
                     (tokens[last_owner].node & Token::kNodeMask) != index &&
                     network->node(tokens[last_owner].node & Token::kNodeMask).parent == node.parent;
  const std::uint32_t owner = MakeToken(*this, index, parent, wme, again ? tokens[last_owner].serial : next_serial++);
  last_owner = owner;
  tokens[owner].pairs = anchor;
  InsertWithKey(*this, index, owner, key.key, true);
  for (std::uint32_t path = BucketHead(*this, paths, key.key); path != kNil; path = tokens[path].next_in_bucket) {
    if (tokens[path].key == key.key && Pairs(owner, path) && (removing == kNil || !Holds(path, removing))) {
      BlockOwner(owner, path, kNil);
    }
  }
  if ((tokens[owner].node & Token::kBlockedBit) == 0) {
    Emit(index, owner, kNil);
  }
}

void ReteState::OwnerGone(std::uint32_t anchor) {
  if (--tokens[anchor].previous_sibling == 0) {
    tokens[anchor].previous_sibling = kNil;
    RemoveSubtree(anchor);
  }
}

void ReteState::LeftPath(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const std::uint32_t path = NewToken(index, parent, wme);
  InsertWithKey(*this, index, path, KeyOfToken(network->node(index), path), true);
  new_paths.push_back(path);
}

// Order ---------------------------------------------------------------------------------------------------------------

/// Whether a token of a path was made when its element came, not when what is above it was made.
bool ReteState::CameWithElement(const Token& token) const {
  const Token& above = tokens[token.parent];
  const std::uint64_t arrival = token.wme == removing ? arrival_of_removing : links[token.wme].serial;
  return above.parent == kNil || arrival > above.serial;  // Below the anchor it must have been: the owners were there.
}

OwnerAndPath ReteState::Meeting(std::uint32_t owner, std::uint32_t prefix) const {
  OwnerAndPath meeting;
  meeting.owner = owner;
  meeting.prefix = prefix;
  meeting.node = tokens[owner].node & Token::kNodeMask;
  meeting.serial = tokens[owner].serial;
  return meeting;
}

/// Whether the partial match of a's owner and prefix would have been made after that of b's.
bool ReteState::CameLater(const OwnerAndPath& a, const OwnerAndPath& b) const {
  if (a.serial == b.serial && a.prefix == b.prefix) {
    return a.place > b.place;
  }
  OwnerAndPath x = a;
  OwnerAndPath y = b;
  for (;;) {
    for (OwnerAndPath* meeting : {&x, &y}) {
      while (tokens[meeting->prefix].parent != kNil && !CameWithElement(tokens[meeting->prefix])) {
        meeting->prefix = tokens[meeting->prefix].parent;
      }
    }
    const Token& of_x = tokens[x.prefix];
    const Token& of_y = tokens[y.prefix];
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
    // One element completed both: it was joined first with what had come last.
    x.prefix = of_x.parent;
    y.prefix = of_y.parent;
    std::swap(x, y);
  }
}

// Blocking ------------------------------------------------------------------------------------------------------------

/// An element has completed paths: blocks their owners. `above`: the memory that it joined with.
void ReteState::BlockOwners(std::uint32_t above) {
  pairings.clear();
  for (const std::uint32_t path : new_paths) {
    const std::uint32_t conjunctive = network->node(tokens[path].node & Token::kNodeMask).partner();
    std::uint32_t prefix = path;
    while ((tokens[prefix].node & Token::kNodeMask) != above) {
      prefix = tokens[prefix].parent;
    }
    const std::uint32_t key = tokens[path].key;
    for (std::uint32_t owner = BucketHead(*this, conjunctive, key); owner != kNil;
         owner = tokens[owner].next_in_bucket) {
      if (tokens[owner].key != key || !Pairs(owner, path)) {
        continue;
      }
      if ((tokens[owner].node & Token::kBlockedBit) != 0) {
        BlockOwner(owner, path, kNil);  // Once more: nobody notices when.
        continue;
      }
      OwnerAndPath meeting = Meeting(owner, prefix);
      meeting.path = path;
      meeting.place = static_cast<std::uint32_t>(pairings.size());
      pairings.push_back(meeting);
    }
  }
  new_paths.clear();
  if (pairings.size() > 1) {
    // What would have been joined first is what came last; its paths come in the order in which they were made.
    std::ranges::sort(pairings, [this](const OwnerAndPath& a, const OwnerAndPath& b) {
      return a.serial == b.serial ? a.place < b.place : CameLater(a, b);
    });
  }
  for (const OwnerAndPath& pairing : pairings) {
    BlockOwner(pairing.owner, pairing.path, kNil);
  }
}

// Opening -------------------------------------------------------------------------------------------------------------

/// Whether a token belongs to a shared conjunction's own conditions.
bool ReteState::IsInPath(const Token& token) const {
  return token.node != Token::kFixedMatchNode && (token.node & Token::kResultBit) == 0 &&
         marks[token.node & Token::kNodeMask].Is(NodeMarks::kInPath);
}

/// Whether a path without the element blocks an owner.
bool ReteState::StaysBlocked(std::uint32_t owner, std::uint32_t wme) const {
  std::uint32_t result = tokens[owner].first_child;
  while (result != kNil && Holds(tokens[result].parent, wme)) {
    result = tokens[result].next_in_bucket;
  }
  return result != kNil;
}

/// Finds the owners that nothing will block when the paths with an element have gone: those that are opened first
/// come last. The element's tokens in paths move behind its other ones.
void ReteState::FindOpenings(std::uint32_t wme) {
  pairings.clear();
  new_paths.clear();
  std::uint32_t last = kNil;
  for (std::uint32_t token = links[wme].first_token; token != kNil; token = tokens[token].next_of_wme) {
    if (IsInPath(tokens[token])) {
      new_paths.push_back(token);
    }
    last = token;
  }
  for (const std::uint32_t top : new_paths) {
    if (top != last) {
      Token& moved = tokens[top];
      tokens[moved.next_of_wme].previous_of_wme = moved.previous_of_wme;
      (moved.previous_of_wme != kNil ? tokens[moved.previous_of_wme].next_of_wme : links[wme].first_token) =
          moved.next_of_wme;
      moved.previous_of_wme = last;
      moved.next_of_wme = kNil;
      tokens[last].next_of_wme = top;
      last = top;
    }
    // What is below another token of the same element goes with that one.
    for (std::uint32_t token = top;;) {
      std::uint32_t next = kNil;
      if (token == top || tokens[token].wme != wme) {
        if (network->node(tokens[token].node & Token::kNodeMask).kind == NodeKind::kPaths) {
          for (std::uint32_t result = tokens[token].first_child; result != kNil; result = tokens[result].next_sibling) {
            const std::uint32_t owner = tokens[result].key;
            if (StaysBlocked(owner, wme)) {
              continue;
            }
            OwnerAndPath meeting = Meeting(owner, top);
            meeting.due = std::max(meeting.serial, tokens[top].serial);
            meeting.place = ~static_cast<std::uint32_t>(pairings.size());  // The newest path goes first.
            pairings.push_back(meeting);
          }
        } else {
          next = tokens[token].first_child;
        }
      }
      while (next == kNil && token != top) {
        next = tokens[token].next_sibling;
        if (next == kNil) {
          token = tokens[token].parent;
        }
      }
      if (next == kNil) {
        break;
      }
      token = next;
    }
  }

  new_paths.clear();
  openings.clear();
  std::ranges::sort(pairings, {}, &OwnerAndPath::owner);
  // An owner that several paths blocked is opened when the last of them goes.
  for (std::size_t first = 0, end; first < pairings.size(); first = end) {
    OwnerAndPath opening = pairings[first];
    for (end = first + 1; end < pairings.size() && pairings[end].owner == opening.owner; ++end) {
      if (CameLater(opening, pairings[end])) {
        opening = pairings[end];
      }
    }
    openings.push_back(opening);
  }
  std::ranges::sort(openings, [this](const OwnerAndPath& a, const OwnerAndPath& b) { return CameLater(b, a); });
}

/// The last path that blocked an owner is going.
void ReteState::OpenOwner(const OwnerAndPath& opening) {
  const std::uint32_t owner = opening.owner;
  if (tokens[owner].node != (opening.node | Token::kBlockedBit) || tokens[owner].serial != opening.serial) {
    return;  // It went itself meanwhile.
  }
  FreeResults(owner);
  tokens[owner].node &= ~Token::kBlockedBit;
  Emit(opening.node, owner, kNil);
}

/// Removes the tokens of an element that may be part of paths.
void ReteState::RemoveTokensInOrder(std::uint32_t wme) {
  path_element = false;
  FindOpenings(wme);
  while (!openings.empty()) {
    const OwnerAndPath& opening = openings.back();
    const std::uint32_t token = links[wme].first_token;
    if (token != kNil && tokens[token].serial > opening.due && !IsInPath(tokens[token])) {
      RemoveTokenOfElement(token);
      continue;
    }
    OpenOwner(opening);
    openings.pop_back();
  }
}

}  // namespace soarbox::kernel
