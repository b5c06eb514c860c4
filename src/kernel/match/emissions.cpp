// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/emissions.h"

#include <algorithm>

namespace soarbox::kernel {

std::vector<std::uint32_t> EmissionReader::TokensByAge(std::uint32_t node) const {
  std::vector<std::uint32_t> found;
  found.reserve(nodes_[node].count);
  nodes_.ForEachToken(tokens_, node, [&](std::uint32_t token) { found.push_back(token); });
  std::sort(found.begin(), found.end(),
            [this](std::uint32_t a, std::uint32_t b) { return tokens_[a].serial > tokens_[b].serial; });
  return found;
}

std::vector<Emission> EmissionReader::Of(std::uint32_t index) const {
  std::vector<Emission> emissions;
  AddTo(index, emissions);
  return emissions;
}

void EmissionReader::AddTo(std::uint32_t index, std::vector<Emission>& emissions) const {
  const Node& node = network_.node(index);
  switch (node.kind) {
    case NodeKind::kRoot:
      emissions.emplace_back(kNil, kNil);
      break;
    case NodeKind::kJoin: {
      if (nodes_[node.parent].count == 0) {
        break;
      }
      if (nodes_[node.parent].count == 1 && alphas_[node.alpha].id_bits != 0 && node.IsJoinById() &&
          nodes_.marks(node.parent).HasList()) {
        // With only one token, the elements are looked up by its key.
        const std::uint32_t token = nodes_[node.parent].head;
        const std::uint32_t id = tokens_[token].key;
        const AlphaState& alpha = alphas_[node.alpha];
        for (std::uint32_t item = alphas_.IdBucket(alpha, id); item != kNil; item = alphas_.item(item).next_in_bucket) {
          if (alphas_.item(item).id == id && tests_.Passes(node, token, wmes_[alphas_.item(item).wme])) {
            emissions.emplace_back(token, alphas_.item(item).wme);
          }
        }
        break;
      }
      for (std::uint32_t item = alphas_[node.alpha].first; item != kNil; item = alphas_.item(item).next) {
        const std::uint32_t wme = alphas_.item(item).wme;
        const std::uint32_t key = KeyOfElement(node, wmes_[wme]);
        const std::size_t first = emissions.size();
        for (std::uint32_t token = nodes_.BucketHead(node.parent, key); token != kNil;
             token = tokens_[token].next_in_bucket) {
          if (tokens_[token].key == key && HasKey(tokens_, wmes_, node, token, wmes_[wme]) &&
              tests_.Passes(node, token, wmes_[wme])) {
            emissions.emplace_back(token, wme);
          }
        }
        if (nodes_.marks(node.parent).Is(NodeMarks::kSparse)) {  // Its buckets may be unsorted.
          std::sort(emissions.begin() + static_cast<std::ptrdiff_t>(first), emissions.end(),
                    [this](const Emission& a, const Emission& b) {
                      return tokens_[a.first].serial > tokens_[b.first].serial;
                    });
        }
      }
      break;
    }
    case NodeKind::kNegative:
      for (const std::uint32_t token : TokensByAge(index)) {
        const std::uint32_t child = tokens_[token].first_child;
        if (child == kNil || (tokens_[child].node & Token::kResultBit) == 0) {
          emissions.emplace_back(token, kNil);
        }
      }
      break;
    case NodeKind::kConjunctive:
      for (const std::uint32_t token : TokensByAge(index)) {
        if ((tokens_[token].node & Token::kBlockedBit) == 0) {
          emissions.emplace_back(token, kNil);
        }
      }
      break;
    case NodeKind::kFree:
    case NodeKind::kMemory:
    case NodeKind::kPartner:
    case NodeKind::kAnchors:
    case NodeKind::kPaths:
    case NodeKind::kProduction:
    case NodeKind::kGuard:
      break;
  }
}

/// The owners, oldest first, for which (parent, wme), emitted by a join of the conjunction, is a partial match.
std::vector<std::uint32_t> EmissionReader::OwnersOf(std::uint32_t conjunctive, std::uint32_t join, std::uint32_t parent,
                                                    std::uint32_t wme) const {
  const Network& net = network_;
  const Node& node = net.node(conjunctive);
  std::uint32_t below = 0;  // Number of later conditions of the conjunction.
  for (std::uint32_t n = net.node(net.node(node.partner()).parent).parent; n != join; ++below) {
    n = net.node(net.node(n).parent).parent;
  }
  const std::uint32_t anchor = tokens_.TopOf(parent);
  const auto passes = [&](std::uint32_t owner) {
    const Token& left = tokens_[owner];
    return left.pairs == anchor && std::ranges::all_of(net.tests(node), [&](const NodeTest& test) {
             if (test.count < below) {
               return true;  // It belongs to a later condition.
             }
             const Wme& element = wmes_.data()[ElementAt(tokens_.records(), parent, wme, test.count - below)];
             return tests_.PassesOne(test, left.parent, left.wme, element);
           });
  };
  std::vector<std::uint32_t> owners = TokensByAge(conjunctive);
  std::erase_if(owners, [&](std::uint32_t owner) { return !passes(owner); });
  std::reverse(owners.begin(), owners.end());
  return owners;
}

}  // namespace soarbox::kernel
