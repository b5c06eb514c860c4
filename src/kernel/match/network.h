// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "kernel/base/forkable_room.h"
#include "kernel/base/plain_vector.h"
#include "kernel/match/rule_info.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

inline constexpr std::uint32_t kNil = 0xFFFFFFFFu;

/// The nodes of the beta network.
///
/// Joins, negative nodes, conjunctive nodes and the root *emit* (token, element) pairs to their children. A memory
/// converts each pair to a token; so do negative and conjunctive nodes, which are their own memories. A partner
/// converts it to a result for its conjunctive node, and a production node to a complete match. The children of a
/// memory are joins.
enum class NodeKind : std::uint8_t {
  kFree,
  kRoot,
  kMemory,
  kJoin,
  kNegative,
  kConjunctive,
  kPartner,
  kAnchors,  ///< Memory above a shared conjunction (rete_shared.cpp): the identifiers at which it begins.
  kPaths,    ///< Memory below it: the paths of elements that it matches. Its only child is the partner.
  kProduction,
  kGuard,  ///< Of a justification, below its negated conditions alone (rete_guard.cpp).
};

/// The key that indexes a memory (or negative node) and the alpha memory on the other side.
enum class KeyKind : std::uint8_t {
  kNone,     ///< No key: every pair is tested.
  kId,       ///< The element's identifier equals an earlier binding.
  kIdValue,  ///< The value also equals a binding. Different pairs may have the same 32-bit key.
};

enum class TestOp : std::uint8_t {
  kEqual,
  kNotEqual,
  kLess,
  kGreater,
  kLessOrEqual,
  kGreaterOrEqual,
  kSameType,
  kDisjunction,
  kIsGoal,
  kNever,
  kSameLti,
  kNotSameLti,
  kIsLti,
  kIsNotLti,
};

/// A test of a join that is covered neither by the alpha memory nor by the key.
struct NodeTest {
  TestOp op = TestOp::kNever;
  Field field = Field::kId;      ///< Field of the element.
  bool against_binding = false;  ///< Compare with a binding (levels, referent_field); if false, with `referent`.
  Field referent_field = Field::kId;
  std::uint16_t levels = 0;    ///< 0: the element itself; n: the element of the (n-1)th token above the left one.
  std::uint16_t count = 0;     ///< kDisjunction: number of constants, from `referent` on in Network::disjuncts. In a
                               ///< shared conjunction: steps up from its path to the element.
  std::uint32_t referent = 0;  ///< Symbol bits, or an index.

  friend bool operator==(const NodeTest&, const NodeTest&) = default;
};

/// The kind of a node, and the key that indexes it.
struct NodeShape {
  NodeKind kind = NodeKind::kFree;
  KeyKind key = KeyKind::kNone;  ///< kMemory, kNegative; a join has that of its memory.
  Field key_id_field = Field::kId;
  Field key_value_field = Field::kId;
  std::uint16_t key_id_levels = 0;  ///< Steps up from the memory's own token. kPartner: size of the conjunction.
  std::uint16_t key_value_levels = 0;

  /// All fields as one number.
  std::uint64_t Bits() const {
    std::uint64_t bits;
    std::memcpy(&bits, this, sizeof(bits));
    return bits;
  }
  friend bool operator==(const NodeShape&, const NodeShape&) = default;
};
static_assert(sizeof(NodeShape) == 8);

/// The small integers that pass a join's comparisons with constants, as an interval of element values. Rules that sort
/// one number into many bands have many joins below one memory; one comparison then excludes most of them.
struct ValueFilter {
  std::uint32_t lowest = 0, range = 0xFFFFFFFFu;  ///< Passes: Place(value) - lowest <= range, unsigned.

  /// Grows with a small integer's value.
  static std::uint32_t Place(std::uint32_t bits) { return bits ^ 1u << (Symbol::kIndexBits - 1); }
  static bool Knows(std::uint32_t bits) {
    return bits >> Symbol::kIndexBits == static_cast<std::uint32_t>(Symbol::Tag::kSmallInteger);
  }
  friend bool operator==(const ValueFilter&, const ValueFilter&) = default;
};

struct Node : NodeShape {
  std::uint16_t test_count = 0;
  std::uint32_t first_test = 0;
  std::uint32_t parent = kNil, first_child = kNil, next_sibling = kNil, previous_sibling = kNil;
  std::uint32_t alpha = kNil;        ///< kJoin, kNegative.
  std::uint32_t ancestor = kNil;     ///< kJoin, kNegative: nearest ancestor with the same alpha memory.
                                     ///< Shared conjunctive node: the anchors of its conjunction.
  std::uint32_t counterpart = kNil;  ///< See partner() and rule().
  std::uint32_t share_hash = 0, share_next = kNil;
  std::uint32_t only_memory = kNil;  ///< The only child, if it is a memory: the common case.
  ValueFilter filter;                ///< kJoin.

  /// The other node of a conjunctive node and its partner. For kPaths: the conjunctive node.
  std::uint32_t partner() const { return counterpart; }
  /// Whether a conjunctive node belongs to a shared conjunction.
  bool IsShared() const { return kind == NodeKind::kConjunctive && key != KeyKind::kNone; }
  /// A join whose memory is indexed only by the element's identifier: the common case, tested in one comparison.
  bool IsJoinById() const {
    constexpr auto of_both = [](std::uint8_t of_kind, std::uint8_t of_key) {
      NodeShape shape;
      shape.kind = static_cast<NodeKind>(of_kind);
      shape.key = static_cast<KeyKind>(of_key);
      return std::bit_cast<std::uint64_t>(shape);
    };
    constexpr std::uint64_t kBoth = of_both(0xFF, 0xFF);
    constexpr std::uint64_t kJoinById =
        of_both(static_cast<std::uint8_t>(NodeKind::kJoin), static_cast<std::uint8_t>(KeyKind::kId));
    return (Bits() & kBoth) == kJoinById;
  }
  /// A memory that finds its pairs by the value of their element and a binding of their token: (s ^many x) above (x
  /// ^attribute known).
  bool IsHop() const {
    return key_id_levels == 0 && key_id_field == Field::kValue &&
           (key == KeyKind::kId || (key == KeyKind::kIdValue && key_value_levels != 0));
  }
  /// For kProduction and kGuard: the rule's number.
  std::uint32_t rule() const { return counterpart; }

  friend bool operator==(const Node&, const Node&) = default;
};

static_assert(sizeof(Node) == 64, "nodes are addressed by a shift");

/// The description of a node to find or create.
struct NodePlan {
  // These fields determine whether nodes are equal; rules share equal nodes.
  std::uint32_t parent = kNil;
  std::uint32_t alpha = kNil;
  NodeShape shape;
  std::span<const NodeTest> tests;
  std::span<const std::uint32_t> disjuncts;  ///< Of the tests.
  std::uint32_t digest = 0;                  ///< Distinguishes nodes that FindShared never looks for; 0 for others.
  // These fields are used only if the node is created.
  std::uint32_t ancestor = kNil;
  std::uint32_t rule = kNil;

  /// A hash of the fields that determine equality.
  std::uint32_t Hash() const;
};

/// An alpha memory: the elements that pass constant tests. The constants are symbol bits; 0 means "any".
struct Alpha {
  std::uint32_t constant[3] = {0, 0, 0};  ///< By Field.
  bool acceptable = false;
  std::uint8_t mask = 0;   ///< Bit n: constant[n] is tested.
  std::uint32_t uses = 0;  ///< Number of nodes that use it; 0: free.
  std::uint32_t hash_next = kNil;

  friend bool operator==(const Alpha&, const Alpha&) = default;
};

/// The selection of an element's fields by an alpha memory's mask.
struct MaskUse {
  std::uint32_t field[3];         ///< All bits or none.
  std::uint32_t hash_of_kind[2];  ///< By whether the memory holds acceptable elements.

  explicit constexpr MaskUse(std::uint32_t mask)
      : field{0u - (mask & 1), 0u - (mask >> 1 & 1), 0u - (mask >> 2)},
        hash_of_kind{mask * 2 * 0x27D4EB2Fu, (mask * 2 + 1) * 0x27D4EB2Fu} {}
};

/// The topology of a Rete: the tests of each node. Contains nothing that changes while rules run, so agents with the
/// same rules can share it. Node 0 is the root. Children are listed newest first.
class [[gnu::visibility("hidden")]] Network {
 public:
  Network();

  const Node& node(std::uint32_t index) const {
    return nodes_[index];
  }
  const Node* nodes() const {
    return nodes_.data();
  }
  /// The memory below a memory's only join.
  std::uint32_t MemoryBelow(std::uint32_t memory) const {
    return nodes_[nodes_[memory].first_child].only_memory;
  }
  std::uint32_t node_limit() const {
    return static_cast<std::uint32_t>(nodes_.size());
  }
  const Alpha& alpha(std::uint32_t index) const {
    return alphas_[index];
  }
  std::uint32_t alpha_limit() const {
    return static_cast<std::uint32_t>(alphas_.size());
  }
  std::span<const NodeTest> tests(const Node& node) const {
    return {tests_.data() + node.first_test, node.test_count};
  }
  const std::uint32_t* disjuncts(const NodeTest& test) const {
    return disjuncts_.data() + test.referent;
  }
  const std::shared_ptr<const RuleInfo>& rule(std::uint32_t production) const {
    return rules_[production];
  }
  std::uint32_t rule_limit() const {
    return static_cast<std::uint32_t>(rules_.size());
  }
  std::uint64_t digest() const {
    return digest_;
  }

  /// Visits the alpha memories that an element belongs to, in the order of their masks.
  template <typename Visit>
  void ForEachAlpha(const std::uint32_t(&fields)[3], bool acceptable, Visit&& visit) const {
    const std::uint32_t hashes[3] = {fields[0] * kHashOfField[0], fields[1] * kHashOfField[1],
                                     fields[2] * kHashOfField[2]};
    for (std::uint32_t masks = MasksFor(fields[1], acceptable); masks != 0; masks &= masks - 1) {
      const MaskUse& use = kMaskUse[std::countr_zero(masks)];
      const std::uint32_t hash = (hashes[0] & use.field[0]) ^ (hashes[1] & use.field[1]) ^ (hashes[2] & use.field[2]) ^
                                 use.hash_of_kind[acceptable ? 1 : 0];
      for (std::uint32_t found = alpha_buckets_[hash >> alpha_shift_]; found != kNil;) {
        const Alpha& a = alphas_[found];
        // Fields of elements are never 0, so equal constants imply equal masks.
        if (a.constant[1] == (fields[1] & use.field[1]) && a.constant[2] == (fields[2] & use.field[2]) &&
            a.constant[0] == (fields[0] & use.field[0]) && a.acceptable == acceptable) {
          visit(found);
          break;
        }
        found = a.hash_next;
      }
    }
  }
  std::uint32_t FindAlpha(const std::uint32_t(&constants)[3], std::uint32_t mask, bool acceptable) const {
    std::uint32_t alpha = alpha_buckets_[AlphaHash(constants, mask, acceptable) >> alpha_shift_];
    while (alpha != kNil) {
      const Alpha& a = alphas_[alpha];
      if (a.constant[1] == constants[1] && a.constant[2] == constants[2] && a.constant[0] == constants[0] &&
          a.mask == mask && a.acceptable == acceptable) {
        return alpha;
      }
      alpha = a.hash_next;
    }
    return kNil;
  }

  // Building. The caller updates the agent's state (rete_nodes.cpp). ------------------------------------------------

  std::uint32_t AddAlpha(const std::uint32_t(&constants)[3], std::uint32_t mask, bool acceptable);
  void UseAlpha(std::uint32_t alpha) {
    ++alphas_[alpha].uses;
  }
  /// Returns true if this was the last use; then the memory was removed.
  bool DropAlpha(std::uint32_t alpha);

  /// A node equal to the plan, or kNil. Not for productions. `hash`: of the plan, here and below.
  std::uint32_t FindShared(const NodePlan& plan, std::uint32_t hash) const;
  /// The first production with the plan's parent and digest, or the next one after `after`.
  std::uint32_t FindProduction(const NodePlan& plan, std::uint32_t hash, std::uint32_t after = kNil) const;
  /// Makes a node at the head of its parent's children.
  std::uint32_t AddNode(const NodePlan& plan, std::uint32_t hash);
  /// The node must have no children. Its tests are removed with it.
  void RemoveNode(std::uint32_t node);
  void MoveToHead(std::uint32_t node);
  /// Both must have the same parent.
  void MoveBehind(std::uint32_t node, std::uint32_t sibling);
  void SetPartner(std::uint32_t conjunctive, std::uint32_t partner);
  /// Of a shared conjunction.
  void SetPaths(std::uint32_t conjunctive, std::uint32_t anchors, std::uint32_t paths);

  void AddRule(std::uint32_t number, std::shared_ptr<const RuleInfo> rule);
  void RemoveRule(std::uint32_t number);

  // Sharing. ------------------------------------------------------------------------------------------------------

  /// Lets an agent change its network: forks it if others use it, too.
  static void Own(std::shared_ptr<Network> & network);
  /// A mutable copy. `many`: more copies may follow; they share unchanged pages if there are enough. Callable from any
  /// thread.
  std::shared_ptr<Network> Fork(bool many) const;
  /// Call before changing a network with one owner. Later copies then contain the changes.
  void BeginChange() {
    if (has_images_) {
      ForgetImages();
    }
  }

  std::size_t MemoryBytes() const;
  bool SameAs(const Network& other) const;

 private:
  static constexpr std::uint32_t kHashOfField[3] = {0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du};
  static std::uint32_t AlphaHash(const std::uint32_t(&constants)[3], std::uint32_t mask, bool acceptable) {
    return (constants[0] * kHashOfField[0]) ^ (constants[1] * kHashOfField[1]) ^ (constants[2] * kHashOfField[2]) ^
           kMaskUse[mask].hash_of_kind[acceptable ? 1 : 0];
  }
  static constexpr MaskUse kMaskUse[8] = {MaskUse(0), MaskUse(1), MaskUse(2), MaskUse(3),
                                          MaskUse(4), MaskUse(5), MaskUse(6), MaskUse(7)};
  /// The masks of the alpha memories that an element with this attribute may belong to.
  std::uint32_t MasksFor(std::uint32_t attribute, bool acceptable) const {
    return masks_in_use_[acceptable ? 1 : 0] & masks_of_attribute_[acceptable ? 1 : 0][attribute % kAttributeClasses];
  }
  [[gnu::noinline]] ValueFilter FilterOf(const Node& join) const;
  [[gnu::noinline]] void ForgetImages();
  void InsertShared(std::uint32_t node);
  void LinkChild(std::uint32_t node);
  void FindOnlyMemory(std::uint32_t parent);
  void UnlinkChild(std::uint32_t node);
  std::uint32_t StoreTests(std::span<const NodeTest> tests, std::span<const std::uint32_t> disjuncts);

  PlainVector<Node, ForkableRoom> nodes_;
  std::uint32_t free_nodes_ = kNil;
  PlainVector<NodeTest, ForkableRoom> tests_;
  std::vector<std::uint32_t> free_tests_;  ///< Heads of free lists by number of tests; linked through `referent`.
  PlainVector<std::uint32_t> disjuncts_;
  std::vector<std::uint32_t> free_disjuncts_;  ///< Likewise, linked through the first word.
  PlainVector<Alpha, ForkableRoom> alphas_;
  std::uint32_t free_alphas_ = kNil;
  std::vector<std::uint32_t> alpha_buckets_;
  int alpha_shift_ = 0;
  std::uint32_t alpha_count_ = 0;
  std::uint32_t mask_counts_[2][8] = {};
  std::uint32_t masks_in_use_[2] = {};  ///< Bit n: some memory of that kind has mask n.
  /// Bit n: some memory with mask n has or had an attribute of this class, or the mask does not test the attribute.
  static constexpr std::size_t kAttributeClasses = 512;
  std::uint8_t masks_of_attribute_[2][kAttributeClasses];
  std::vector<std::uint32_t> share_buckets_;
  std::uint32_t share_count_ = 0;
  std::uint32_t most_per_bucket_ = 1;  ///< On average. Higher in forks, because rehashing writes to all pages.
  std::vector<std::shared_ptr<const RuleInfo>> rules_;
  std::uint64_t digest_ = 0x9E3779B97F4A7C15u;
  mutable bool has_images_ = false;  ///< Large arrays also exist as images, for copies to share.
};

}  // namespace soarbox::kernel
