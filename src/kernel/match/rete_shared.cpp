// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "kernel/match/rete_inline.h"

/// Shared conjunctions. Most conjunctive negations start at one object and follow a path of elements. They search for
/// something that beats or excludes the current match: another task of the class with a higher rank, a free slot of the
/// zone. If they are matched below each token, they create as many partial matches as there are tokens times elements.
/// If the conditions form a path from one identifier, they are instead matched once per identifier, the *anchor*. The
/// tokens that wait for the conjunction are its *owners*. They meet complete paths by the anchor and by other bindings
/// that must be equal. The remaining comparisons are evaluated at the meeting. A record is created only for a path that
/// blocks an owner.
///
/// An anchor lives while it has owners, and comparisons with owners come last (rete_builder_shared.cpp). So the number
/// of paths per identifier is about the number of partial matches per token without sharing.
///
/// Sharing has no observable effect: owners are blocked and opened in the order in which the partial matches (owner,
/// path) would have been created and removed. This order follows from serial numbers. Such a match is created when the
/// later of the two arrives. If an element completes a path, the owners are processed in reverse order: the owner that
/// first met the existing part of the path comes last.
namespace soarbox::kernel {

// Meeting -------------------------------------------------------------------------------------------------------------

void ReteState::LeftShared(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const Node& node = network->node(index);
  const std::uint32_t anchors = node.ancestor;
  const std::uint32_t paths = network->node(node.partner()).parent;
  const KeyParts key = KeyOfPair(*this, node, parent, wme);
  std::uint32_t anchor = nodes.BucketHead(anchors, key.id);
  while (anchor != kNil && tokens[anchor].key != key.id) {
    anchor = tokens[anchor].next_in_bucket;
  }
  if (anchor == kNil) {
    anchor = MakeAnchor(anchors, key.id);
    shared.new_paths.clear();  // There are no other owners that they might block.
    tokens[anchor].previous_sibling = 0;
  }
  ++tokens[anchor].previous_sibling;
  // A pair that is emitted to several conjunctions reaches all of them at the same time.
  const bool again = shared.last_owner != kNil && tokens[shared.last_owner].parent == parent &&
                     tokens[shared.last_owner].wme == wme &&
                     (tokens[shared.last_owner].node & Token::kNodeMask) != index &&
                     network->node(tokens[shared.last_owner].node & Token::kNodeMask).parent == node.parent;
  const std::uint32_t owner =
      tokens.Make(links, index, parent, wme, again ? tokens[shared.last_owner].serial : tokens.TakeSerial());
  shared.last_owner = owner;
  tokens[owner].pairs = anchor;
  nodes.Insert(tokens, index, owner, key.key, true);
  for (std::uint32_t path = nodes.BucketHead(paths, key.key); path != kNil; path = tokens[path].next_in_bucket) {
    if (tokens[path].key == key.key && SharedConjunctions::Pairs(*network, tokens, wmes, pair_tests, owner, path) &&
        (links.leaving() == kNil || !tokens.Holds(path, links.leaving()))) {
      BlockOwner(owner, path, kNil);
    }
  }
  if ((tokens[owner].node & Token::kBlockedBit) == 0) {
    Emit(index, owner, kNil);
  }
}

void ReteState::LeftPath(std::uint32_t index, std::uint32_t parent, std::uint32_t wme) {
  const std::uint32_t path = MakeToken(*this, index, parent, wme);
  nodes.Insert(tokens, index, path, KeyOfPair(*this, network->node(index), parent, wme).key, true);
  shared.new_paths.push_back(path);
}

// Blocking ------------------------------------------------------------------------------------------------------------

/// An element has completed paths: blocks their owners. `above` is the memory with which it was joined.
void ReteState::BlockOwners(std::uint32_t above) {
  const MeetingOrder order(tokens, links);
  shared.pairings.clear();
  for (const std::uint32_t path : shared.new_paths) {
    const std::uint32_t conjunctive = network->node(tokens[path].node & Token::kNodeMask).partner();
    std::uint32_t prefix = path;
    while ((tokens[prefix].node & Token::kNodeMask) != above) {
      prefix = tokens[prefix].parent;
    }
    const std::uint32_t key = tokens[path].key;
    for (std::uint32_t owner = nodes.BucketHead(conjunctive, key); owner != kNil;
         owner = tokens[owner].next_in_bucket) {
      if (tokens[owner].key != key || !SharedConjunctions::Pairs(*network, tokens, wmes, pair_tests, owner, path)) {
        continue;
      }
      if ((tokens[owner].node & Token::kBlockedBit) != 0) {
        BlockOwner(owner, path, kNil);  // A further result. Its order does not matter.
        continue;
      }
      OwnerAndPath meeting = order.Meeting(owner, prefix);
      meeting.path = path;
      meeting.place = static_cast<std::uint32_t>(shared.pairings.size());
      shared.pairings.push_back(meeting);
    }
  }
  shared.new_paths.clear();
  if (shared.pairings.size() > 1) {
    // The newest would have been joined first; its paths come in the order in which they were created.
    std::ranges::sort(shared.pairings, [&](const OwnerAndPath& a, const OwnerAndPath& b) {
      return a.serial == b.serial ? a.place < b.place : order.CameLater(a, b);
    });
  }
  for (const OwnerAndPath& pairing : shared.pairings) {
    BlockOwner(pairing.owner, pairing.path, kNil);
  }
}

// Opening -------------------------------------------------------------------------------------------------------------

/// The last path that blocked an owner is removed.
void ReteState::OpenOwner(const OwnerAndPath& opening) {
  const std::uint32_t owner = opening.owner;
  if (tokens[owner].node != (opening.node | Token::kBlockedBit) || tokens[owner].serial != opening.serial) {
    return;  // It was removed meanwhile.
  }
  tokens.FreeResults(links, owner);
  tokens[owner].node &= ~Token::kBlockedBit;
  Emit(opening.node, owner, kNil);
}

/// Removes the tokens of an element that may be part of paths.
void ReteState::RemoveTokensInOrder(std::uint32_t wme) {
  shared.path_element = false;
  shared.FindOpenings(*network, nodes, tokens, links, wme);
  while (!shared.openings.empty()) {
    const OwnerAndPath& opening = shared.openings.back();
    const std::uint32_t token = links[wme].first_token;
    if (token != kNil && tokens[token].serial > opening.due && !SharedConjunctions::IsInPath(nodes, tokens[token])) {
      RemoveTokenOfElement(token);
      continue;
    }
    OpenOwner(opening);
    shared.openings.pop_back();
  }
}

}  // namespace soarbox::kernel
