// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/network.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <mutex>

#include "kernel/base/sole_owner.h"

namespace soarbox::kernel {

namespace {

constexpr std::uint32_t kFirstAlphaBits = 6;
constexpr std::size_t kFirstShareBuckets = 256;

/// Mixes a number into all bits of a hash.
std::uint64_t Mixed(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
  return hash ^ hash >> 32;
}

/// A test without its referent, as a number.
std::uint64_t Bits(const NodeTest& test) {
  static_assert(offsetof(NodeTest, referent) == sizeof(std::uint64_t));
  std::uint64_t bits;
  std::memcpy(&bits, &test, sizeof(bits));
  return bits;
}

/// Serializes the creation of copies and their images.
std::mutex forks;

template <typename T>
void MakeImage(const PlainVector<T, ForkableRoom>& records) {
  records.room().MakeImage(records.data(), records.size() * sizeof(T));
}

/// Allocates `count` places from a pool with free lists by size.
template <typename T, typename Room, typename Next>
std::uint32_t TakePlaces(PlainVector<T, Room>& pool, std::vector<std::uint32_t>& free, std::size_t count, Next next) {
  if (count == 0) {
    return 0;
  }
  if (count >= free.size()) {
    free.resize(count + 1, kNil);
  }
  std::uint32_t place = free[count];
  if (place != kNil) {
    free[count] = next(pool[place]);
    return place;
  }
  place = static_cast<std::uint32_t>(pool.size());
  pool.resize(pool.size() + count);
  return place;
}

}  // namespace

Network::Network() {
  alpha_buckets_.assign(std::size_t{1} << kFirstAlphaBits, kNil);
  alpha_shift_ = 32 - static_cast<int>(kFirstAlphaBits);
  share_buckets_.assign(kFirstShareBuckets, kNil);
  constexpr std::uint8_t kAnyAttribute = 0x33;  // The bits of masks that do not test the attribute.
  for (auto& masks : masks_of_attribute_) std::fill(std::begin(masks), std::end(masks), kAnyAttribute);
  nodes_.emplace_back();
  nodes_[0].kind = NodeKind::kRoot;
}

// Alpha memories ------------------------------------------------------------------------------------------------------

std::uint32_t Network::AddAlpha(const std::uint32_t (&constants)[3], std::uint32_t mask, bool acceptable) {
  if (alpha_count_ >= alpha_buckets_.size()) {
    --alpha_shift_;
    alpha_buckets_.assign(alpha_buckets_.size() * 2, kNil);
    for (std::uint32_t n = 0; n < alphas_.size(); ++n) {
      Alpha& alpha = alphas_[n];
      if (alpha.uses == 0) {
        continue;
      }
      std::uint32_t& head = alpha_buckets_[AlphaHash(alpha.constant, alpha.mask, alpha.acceptable) >> alpha_shift_];
      alpha.hash_next = head;
      head = n;
    }
  }
  std::uint32_t index = free_alphas_;
  if (index != kNil) {
    free_alphas_ = alphas_[index].hash_next;
  } else {
    index = static_cast<std::uint32_t>(alphas_.size());
    alphas_.emplace_back();
  }
  Alpha& alpha = alphas_[index];
  std::copy(constants, constants + 3, alpha.constant);
  alpha.mask = static_cast<std::uint8_t>(mask);
  alpha.acceptable = acceptable;
  alpha.uses = 1;
  std::uint32_t& head = alpha_buckets_[AlphaHash(constants, mask, acceptable) >> alpha_shift_];
  alpha.hash_next = head;
  head = index;
  ++alpha_count_;
  ++mask_counts_[acceptable ? 1 : 0][mask];
  masks_in_use_[acceptable ? 1 : 0] |= 1u << mask;
  if ((mask & 2) != 0) {
    masks_of_attribute_[acceptable ? 1 : 0][constants[1] % kAttributeClasses] |= static_cast<std::uint8_t>(1u << mask);
  }
  return index;
}

bool Network::DropAlpha(std::uint32_t index) {
  Alpha& alpha = alphas_[index];
  if (--alpha.uses != 0) {
    return false;
  }
  std::uint32_t* link = &alpha_buckets_[AlphaHash(alpha.constant, alpha.mask, alpha.acceptable) >> alpha_shift_];
  while (*link != index) {
    link = &alphas_[*link].hash_next;
  }
  *link = alpha.hash_next;
  --alpha_count_;
  if (--mask_counts_[alpha.acceptable ? 1 : 0][alpha.mask] == 0) {
    masks_in_use_[alpha.acceptable ? 1 : 0] &= ~(1u << alpha.mask);
  }
  alpha = Alpha();
  alpha.hash_next = free_alphas_;
  free_alphas_ = index;
  return true;
}

// Nodes ---------------------------------------------------------------------------------------------------------------

std::uint32_t NodePlan::Hash() const {
  std::uint64_t hash = Mixed(std::uint64_t{parent} << 32 | alpha, shape.Bits());
  if (digest != 0) {
    hash = Mixed(hash, digest);
  }
  for (const NodeTest& test : tests) {
    hash = Mixed(hash, Bits(test));
    if (test.op != TestOp::kDisjunction) {
      hash = Mixed(hash, test.referent);
      continue;
    }
    for (std::uint32_t n = 0; n < test.count; ++n) {
      hash = Mixed(hash, disjuncts[test.referent + n]);
    }
  }
  return static_cast<std::uint32_t>(hash);
}

std::uint32_t Network::FindShared(const NodePlan& plan, std::uint32_t hash) const {
  for (std::uint32_t n = share_buckets_[hash & (share_buckets_.size() - 1)]; n != kNil; n = nodes_[n].share_next) {
    const Node& other = nodes_[n];
    if (other.share_hash != hash || other.parent != plan.parent || other.Bits() != plan.shape.Bits() ||
        other.alpha != plan.alpha || other.test_count != plan.tests.size()) {
      continue;
    }
    const bool same = std::ranges::equal(tests(other), plan.tests, [&](const NodeTest& a, const NodeTest& b) {
      if (Bits(a) != Bits(b)) {
        return false;
      }
      if (a.op != TestOp::kDisjunction) {
        return a.referent == b.referent;
      }
      return std::equal(disjuncts(a), disjuncts(a) + a.count, plan.disjuncts.data() + b.referent);
    });
    if (same) {
      return n;
    }
  }
  return kNil;
}

std::uint32_t Network::FindProduction(const NodePlan& plan, std::uint32_t hash, std::uint32_t after) const {
  std::uint32_t n = after == kNil ? share_buckets_[hash & (share_buckets_.size() - 1)] : nodes_[after].share_next;
  while (n != kNil &&
         (nodes_[n].share_hash != hash || nodes_[n].parent != plan.parent || nodes_[n].kind != plan.shape.kind)) {
    n = nodes_[n].share_next;
  }
  return n;
}

std::uint32_t Network::StoreTests(std::span<const NodeTest> tests, std::span<const std::uint32_t> disjuncts) {
  const std::uint32_t place =
      TakePlaces(tests_, free_tests_, tests.size(), [](const NodeTest& test) { return test.referent; });
  for (std::size_t n = 0; n < tests.size(); ++n) {
    NodeTest test = tests[n];
    if (test.op == TestOp::kDisjunction) {
      const std::uint32_t from = test.referent;
      test.referent = TakePlaces(disjuncts_, free_disjuncts_, test.count, [](std::uint32_t word) { return word; });
      std::copy_n(disjuncts.begin() + from, test.count, disjuncts_.data() + test.referent);
    }
    tests_[place + n] = test;
  }
  return place;
}

ValueFilter Network::FilterOf(const Node& join) const {
  // The constant must be a small integer, and so must the compared value.
  const std::uint32_t smallest = static_cast<std::uint32_t>(Symbol::Tag::kSmallInteger) << Symbol::kIndexBits;
  std::uint32_t low = smallest;
  std::uint32_t high = smallest | Symbol::kIndexMask;
  bool any = false;
  for (const NodeTest& test : tests(join)) {
    if (test.op < TestOp::kLess || test.op > TestOp::kGreaterOrEqual || test.against_binding ||
        test.field != Field::kValue || !ValueFilter::Knows(test.referent)) {
      continue;
    }
    any = true;
    const std::uint32_t bound = ValueFilter::Place(test.referent);
    switch (test.op) {
      case TestOp::kLess:
        high = std::min(high, bound - 1);
        break;
      case TestOp::kLessOrEqual:
        high = std::min(high, bound);
        break;
      case TestOp::kGreater:
        low = std::max(low, bound + 1);
        break;
      default:
        low = std::max(low, bound);
        break;
    }
  }
  // An empty interval is replaced by a value that no small integer has.
  return !any ? ValueFilter() : low > high ? ValueFilter{0, 0} : ValueFilter{low, high - low};
}

std::uint32_t Network::AddNode(const NodePlan& plan, std::uint32_t hash) {
  std::uint32_t index = free_nodes_;
  if (index != kNil) {
    free_nodes_ = nodes_[index].share_next;
  } else {
    index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
  }
  Node& node = nodes_[index];
  static_cast<NodeShape&>(node) = plan.shape;
  node.test_count = static_cast<std::uint16_t>(plan.tests.size());
  node.first_test = plan.tests.empty() ? 0 : StoreTests(plan.tests, plan.disjuncts);
  node.parent = plan.parent;
  node.alpha = plan.alpha;
  node.ancestor = plan.ancestor;
  node.counterpart = plan.rule;
  if (node.kind == NodeKind::kJoin && node.test_count != 0) {
    node.filter = FilterOf(node);
  }
  node.share_hash = hash;
  LinkChild(index);
  InsertShared(index);
  digest_ = (digest_ ^ hash) * 0x9E3779B97F4A7C15u + index;
  return index;
}

void Network::RemoveNode(std::uint32_t index) {
  Node& node = nodes_[index];
  UnlinkChild(index);
  std::uint32_t* link = &share_buckets_[node.share_hash & (share_buckets_.size() - 1)];
  while (*link != index) {
    link = &nodes_[*link].share_next;
  }
  *link = node.share_next;
  --share_count_;
  if (node.test_count != 0) {
    for (std::uint32_t n = 0; n < node.test_count; ++n) {
      const NodeTest& test = tests_[node.first_test + n];
      if (test.op == TestOp::kDisjunction && test.count != 0) {
        disjuncts_[test.referent] = free_disjuncts_[test.count];
        free_disjuncts_[test.count] = test.referent;
      }
    }
    tests_[node.first_test].referent = free_tests_[node.test_count];
    free_tests_[node.test_count] = node.first_test;
  }
  digest_ = (digest_ ^ ~std::uint64_t{node.share_hash}) * 0x9E3779B97F4A7C15u + index;
  node = Node();
  node.share_next = free_nodes_;
  free_nodes_ = index;
}

void Network::InsertShared(std::uint32_t index) {
  if (share_count_ >= share_buckets_.size() * most_per_bucket_) {
    share_buckets_.assign(share_buckets_.size() * 2, kNil);
    for (std::uint32_t n = 1; n < nodes_.size(); ++n) {
      if (nodes_[n].kind != NodeKind::kFree && n != index) {
        std::uint32_t& head = share_buckets_[nodes_[n].share_hash & (share_buckets_.size() - 1)];
        nodes_[n].share_next = head;
        head = n;
      }
    }
  }
  std::uint32_t& head = share_buckets_[nodes_[index].share_hash & (share_buckets_.size() - 1)];
  nodes_[index].share_next = head;
  head = index;
  ++share_count_;
}

void Network::LinkChild(std::uint32_t index) {
  Node& node = nodes_[index];
  std::uint32_t& head = nodes_[node.parent].first_child;
  node.previous_sibling = kNil;
  node.next_sibling = head;
  if (head != kNil) {
    nodes_[head].previous_sibling = index;
  }
  head = index;
  FindOnlyMemory(node.parent);
}

void Network::FindOnlyMemory(std::uint32_t parent) {
  const std::uint32_t child = nodes_[parent].first_child;
  const bool only = child != kNil && nodes_[child].next_sibling == kNil && nodes_[child].kind == NodeKind::kMemory;
  nodes_[parent].only_memory = only ? child : kNil;
}

void Network::UnlinkChild(std::uint32_t index) {
  const Node& node = nodes_[index];
  if (node.next_sibling != kNil) {
    nodes_[node.next_sibling].previous_sibling = node.previous_sibling;
  }
  if (node.previous_sibling != kNil) {
    nodes_[node.previous_sibling].next_sibling = node.next_sibling;
  } else {
    nodes_[node.parent].first_child = node.next_sibling;
  }
  FindOnlyMemory(node.parent);
}

void Network::MoveToHead(std::uint32_t index) {
  UnlinkChild(index);
  LinkChild(index);
}

void Network::MoveBehind(std::uint32_t index, std::uint32_t sibling) {
  UnlinkChild(index);
  Node& node = nodes_[index];
  node.previous_sibling = sibling;
  node.next_sibling = nodes_[sibling].next_sibling;
  nodes_[sibling].next_sibling = index;
  if (node.next_sibling != kNil) {
    nodes_[node.next_sibling].previous_sibling = index;
  }
  FindOnlyMemory(node.parent);
}

void Network::SetPartner(std::uint32_t conjunctive, std::uint32_t partner) {
  nodes_[conjunctive].counterpart = partner;
  nodes_[partner].counterpart = conjunctive;
}

void Network::SetPaths(std::uint32_t conjunctive, std::uint32_t anchors, std::uint32_t paths) {
  nodes_[conjunctive].ancestor = anchors;
  nodes_[paths].counterpart = conjunctive;
}

// Rules ---------------------------------------------------------------------------------------------------------------

void Network::AddRule(std::uint32_t number, std::shared_ptr<const RuleInfo> rule) {
  if (number >= rules_.size()) {
    rules_.resize(number + 1u);
  }
  rules_[number] = std::move(rule);
}

void Network::RemoveRule(std::uint32_t number) {
  rules_[number].reset();
}

// Sharing -------------------------------------------------------------------------------------------------------------

void Network::Own(std::shared_ptr<Network>& network) {
  if (IsSoleOwner(network)) {
    network->BeginChange();
    return;
  }
  // If there are only two owners, one is the store of shared rules (decide/rule_sharing.h).
  network = network->Fork(network.use_count() > 2);
}

std::shared_ptr<Network> Network::Fork(bool many) const {
  const std::lock_guard lock(forks);
  if (many && !has_images_) {
    has_images_ = true;
    MakeImage(nodes_);
    MakeImage(tests_);
    MakeImage(alphas_);
  }
  auto fork = std::make_shared<Network>(*this);
  fork->rules_.reserve(rules_.size() + rules_.size() / 8 + 16);
  fork->has_images_ = false;
  fork->most_per_bucket_ = many ? 4 : 1;
  return fork;
}

void Network::ForgetImages() {
  has_images_ = false;
  nodes_.room().ForgetImage();
  tests_.room().ForgetImage();
  alphas_.room().ForgetImage();
}

std::size_t Network::MemoryBytes() const {
  return nodes_.capacity() * sizeof(Node) + tests_.capacity() * sizeof(NodeTest) +
         (free_tests_.capacity() + disjuncts_.capacity() + free_disjuncts_.capacity() + alpha_buckets_.capacity() +
          share_buckets_.capacity()) *
             4 +
         alphas_.capacity() * sizeof(Alpha) + rules_.size() * (sizeof(rules_[0]) + sizeof(RuleInfo) + 64);
}

bool Network::SameAs(const Network& other) const {
  return digest_ == other.digest_ && nodes_ == other.nodes_ && tests_ == other.tests_ &&
         disjuncts_ == other.disjuncts_ && alphas_ == other.alphas_ &&
         std::ranges::equal(rules_, other.rules_, [](const auto& a, const auto& b) {
           if (!a || !b) {
             return !a && !b;
           }
           return a->node == b->node && a->support == b->support && a->rule->name == b->rule->name &&
                  a->rule->type == b->rule->type &&
                  (a->rule == b->rule || (std::ranges::equal(a->rule->conditions, b->rule->conditions) &&
                                          std::ranges::equal(a->rule->actions, b->rule->actions)));
         });
}

}  // namespace soarbox::kernel
