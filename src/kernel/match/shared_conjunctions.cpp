// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/shared_conjunctions.h"

#include <algorithm>

namespace soarbox::kernel {

bool SharedConjunctions::Pairs(const Network& net, const TokenPool& tokens, const WmeTable& wmes,
                               const PairTests& tests, std::uint32_t owner, std::uint32_t path) {
  const Token& left = tokens[owner];
  const Token& right = tokens[path];
  const Node& node = net.node(left.node & Token::kNodeMask);
  const Node& paths = net.node(right.node & Token::kNodeMask);
  const Records<const Token> all = tokens.records();
  if (node.key == KeyKind::kIdValue &&
      BitsOf(wmes.data()[ElementAt(all, left.parent, left.wme, node.key_id_levels)], node.key_id_field) !=
          BitsOf(wmes.data()[ElementAt(all, right.parent, right.wme, paths.key_id_levels)], Field::kId)) {
    return false;
  }
  for (const NodeTest& test : net.tests(node)) {
    const Wme& element = wmes.data()[ElementAt(all, right.parent, right.wme, test.count)];
    if (!tests.PassesOne(test, left.parent, left.wme, element)) {
      return false;
    }
  }
  return true;
}

bool SharedConjunctions::IsInPath(const NodeStates& nodes, const Token& token) {
  return token.node != Token::kFixedMatchNode && (token.node & Token::kResultBit) == 0 &&
         nodes.marks(token.node & Token::kNodeMask).Is(NodeMarks::kInPath);
}

bool SharedConjunctions::StaysBlocked(const TokenPool& tokens, std::uint32_t owner, std::uint32_t wme) {
  std::uint32_t result = tokens[owner].first_child;
  while (result != kNil && tokens.Holds(tokens[result].parent, wme)) {
    result = tokens[result].next_in_bucket;
  }
  return result != kNil;
}

void SharedConjunctions::FindOpenings(const Network& network, const NodeStates& nodes, TokenPool& tokens,
                                      ElementLinks& links, std::uint32_t wme) {
  const MeetingOrder order(tokens, links);
  pairings.clear();
  new_paths.clear();
  std::uint32_t last = kNil;
  for (std::uint32_t token = links[wme].first_token; token != kNil; token = tokens[token].next_of_wme) {
    if (IsInPath(nodes, tokens[token])) {
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
    // Tokens below another token of the same element are removed with that one.
    for (std::uint32_t token = top;;) {
      std::uint32_t next = kNil;
      if (token == top || tokens[token].wme != wme) {
        if (network.node(tokens[token].node & Token::kNodeMask).kind == NodeKind::kPaths) {
          for (std::uint32_t result = tokens[token].first_child; result != kNil; result = tokens[result].next_sibling) {
            const std::uint32_t owner = tokens[result].key;
            if (StaysBlocked(tokens, owner, wme)) {
              continue;
            }
            OwnerAndPath meeting = order.Meeting(owner, top);
            meeting.due = std::max(meeting.serial, tokens[top].serial);
            meeting.place = ~static_cast<std::uint32_t>(pairings.size());  // The newest path is first.
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
  // An owner that several paths blocked is opened when the last of them is removed.
  for (std::size_t first = 0, end; first < pairings.size(); first = end) {
    OwnerAndPath opening = pairings[first];
    for (end = first + 1; end < pairings.size() && pairings[end].owner == opening.owner; ++end) {
      if (order.CameLater(opening, pairings[end])) {
        opening = pairings[end];
      }
    }
    openings.push_back(opening);
  }
  std::ranges::sort(openings, [&](const OwnerAndPath& a, const OwnerAndPath& b) { return order.CameLater(b, a); });
}

}  // namespace soarbox::kernel
