// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>
#include <set>

#include "kernel/match/rete_inline.h"

namespace soarbox::kernel {

namespace {

/// Walks all structures once and collects violations.
class Checker {
 public:
  explicit Checker(const ReteState& state) : s_(state), network_(*state.network) {}

  std::string Run() {
    for (std::uint32_t n = 0; n < network_.alpha_limit(); ++n) {
      if (network_.alpha(n).uses != 0) {
        CheckAlpha(n);
      }
    }
    CheckElements();
    for (std::uint32_t n = 0; n < network_.node_limit(); ++n) {
      if (network_.node(n).kind == NodeKind::kGuard && s_.nodes[n].first_linked == kNil) {
        ended_.insert(BelowRoot(network_, n));
      }
    }
    for (std::uint32_t n = 0; n < network_.node_limit(); ++n) {
      if (network_.node(n).kind != NodeKind::kFree) {
        CheckNode(n);
      }
    }
    s_.tokens.ForEachFree(
        [&](std::uint32_t token) { Expect(s_.tokens[token].pairs == 0, "free token with pairs", token); });
    return std::move(errors_);
  }

 private:
  void Expect(bool condition, const char* what, std::uint32_t where) {
    if (!condition && errors_.size() < 2000) {
      errors_ += std::string(what) + " at " + std::to_string(where) + "\n";
    }
  }

  void CheckAlpha(std::uint32_t alpha) {
    const AlphaState& memory = s_.alphas[alpha];
    std::uint32_t count = 0;
    std::uint32_t previous = kNil;
    for (std::uint32_t item = memory.first; item != kNil; item = s_.alphas.item(item).next) {
      Expect(s_.alphas.item(item).previous == previous, "broken list of items", alpha);
      Expect(s_.alphas.item(item).alpha == alpha, "item of another alpha memory", alpha);
      Expect(s_.links[s_.alphas.item(item).wme].in_match, "item of an element that is not in the match", alpha);
      previous = item;
      ++count;
    }
    Expect(count == memory.count, "wrong count of an alpha memory", alpha);
    if (memory.id_bits != 0) {
      Expect(s_.alphas.CountInIdTable(memory) == count, "wrong id table", alpha);
    }
    if (memory.pair_bits != 0) {
      Expect(s_.alphas.CountInPairTable(memory) == count, "wrong pair table", alpha);
    }
    previous = kNil;
    for (std::uint32_t node = memory.first_node; node != kNil; node = s_.nodes[node].next_right) {
      Expect(s_.nodes.marks(node).Is(NodeMarks::kRightLinked) && network_.node(node).alpha == alpha,
             "wrong node in alpha memory's list", node);
      Expect(s_.nodes[node].previous_right == previous, "broken list of nodes", alpha);
      // It is not maintained while the alpha memory is empty; the first element updates it.
      if ((memory.sparse & AlphaState::kBusy) != 0 && memory.count != 0 && s_.only_ids[node] != 0) {
        CheckOnlyId(node);
      }
      for (std::uint32_t later = s_.nodes[node].next_right; later != kNil; later = s_.nodes[later].next_right) {
        for (std::uint32_t up = network_.node(later).ancestor; up != kNil; up = network_.node(up).ancestor) {
          Expect(up != node, "an ancestor is before its descendant", later);
        }
      }
      previous = node;
    }
    Expect(memory.last_node == previous, "wrong end of a list of nodes", alpha);
  }

  void CheckOnlyId(std::uint32_t join) {
    const Node& memory = network_.node(network_.node(join).parent);
    Expect(memory.kind == NodeKind::kMemory && memory.key != KeyKind::kNone, "node that waits for no identifier", join);
    Expect(!s_.nodes.marks(network_.node(join).parent).Is(NodeMarks::kSparse), "one identifier of a sparse memory",
           join);
    s_.nodes.ForEachToken(s_.tokens, network_.node(join).parent, [&](std::uint32_t token) {
      const Wme& element = s_.wmes[ElementAt(s_.tokens.records(), token, memory.key_id_levels)];
      Expect(BitsOf(element, memory.key_id_field) == s_.only_ids[join], "node that waits for another identifier", join);
    });
  }

  void CheckElements() {
    std::uint32_t count = 0;
    for (std::uint32_t wme = s_.links.newest(); wme != kNil; wme = s_.links[wme].next) {
      ++count;
      const Wme& element = s_.wmes[wme];
      std::size_t wanted = 0;
      const std::uint32_t fields[3] = {element.id.bits(), element.attribute.bits(), element.value.bits()};
      network_.ForEachAlpha(fields, element.acceptable, [&](std::uint32_t) { ++wanted; });
      std::size_t found = 0;
      for (std::uint32_t item = s_.links[wme].first_item; item != kNil; item = s_.alphas.item(item).next_of_wme) {
        Expect(s_.alphas.item(item).wme == wme, "item of another element", wme);
        ++found;
      }
      Expect(found == wanted, "element in the wrong number of alpha memories", wme);
      for (std::uint32_t token = s_.links[wme].first_token; token != kNil; token = s_.tokens[token].next_of_wme) {
        Expect(s_.tokens[token].wme == wme, "token of another element", wme);
      }
    }
    Expect(count == s_.links.count(), "wrong count of elements", count);
  }

  void CheckNode(std::uint32_t index) {
    const Node& node = network_.node(index);
    const NodeState& state = s_.nodes[index];
    const NodeMarks marks = s_.nodes.marks(index);
    const bool left_linked = marks.Is(NodeMarks::kLeftLinked);
    const bool right_linked = marks.Is(NodeMarks::kRightLinked);
    if (node.kind == NodeKind::kJoin) {
      const bool left = s_.nodes[node.parent].count != 0;
      const bool right = s_.alphas[node.alpha].count != 0;
      Expect(left_linked || right_linked, "join unlinked on both sides", index);
      Expect(!(left && right) || (left_linked && right_linked), "join is not linked", index);
      Expect(!(left_linked && right_linked) || (left && right), "join is linked although one side is empty", index);
      Expect(left_linked || !right, "join left-unlinked from a full alpha memory", index);
      Expect(right_linked || !left, "join right-unlinked with a full memory", index);
      return;
    }
    if (node.kind == NodeKind::kRoot || node.kind == NodeKind::kPartner) {
      return;
    }
    if (node.kind == NodeKind::kAnchors) {
      CheckAnchors(index);
      return;
    }
    std::uint32_t count = 0;
    s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t token) {
      ++count;
      Expect((s_.tokens[token].node & Token::kNodeMask) == index, "token of another node", token);
      if (node.kind == NodeKind::kMemory || node.kind == NodeKind::kNegative || node.kind == NodeKind::kPaths) {
        Expect(s_.tokens[token].key == KeyOfPair(s_, node, s_.tokens[token].parent, s_.tokens[token].wme).key,
               "wrong key", token);
      }
    });
    if (marks.Is(NodeMarks::kSparse)) {
      Expect(count == s_.SparseOf(index).tokens, "wrong count of a sparse memory's tokens", index);
      CheckSparse(index);
    } else {
      Expect(count == state.count, "wrong count of a memory", index);
      Expect(node.kind != NodeKind::kMemory || state.score == kNil || SparseMemories::CanBeSparse(network_, index),
             "score on a memory that cannot be sparse", index);
    }
    count = state.count;
    Expect(ended_.count(index) != 0
               ? count == 0
               : TestsLinks(network_.node(node.parent)) || s_.emissions().Of(node.parent).size() == count,
           "tokens of a memory differ from the pairs that reach it", index);
    if (node.kind == NodeKind::kNegative) {
      Expect(right_linked == (count != 0), "negative node linked wrongly", index);
      s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t token) { CheckResults(node, token); });
    }
    if (node.kind == NodeKind::kConjunctive) {
      s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t token) {
        if ((s_.tokens[token].node & Token::kBlockedBit) == 0) {
          return;
        }
        Expect(s_.tokens[token].first_child != kNil, "blocked by nothing", token);
        for (std::uint32_t r = s_.tokens[token].first_child; r != kNil; r = s_.tokens[r].next_in_bucket) {
          Expect(s_.tokens[r].node == node.partner() && s_.tokens[r].key == token, "wrong result", r);
          ++results_;
        }
      });
      Expect(ResultsWanted(index) == results_, "results are missing", index);
      results_ = 0;
    }
  }

  /// The total number of results of a conjunctive node's tokens.
  std::size_t ResultsWanted(std::uint32_t index) {
    const std::uint32_t bottom = network_.node(network_.node(index).partner()).parent;
    if (network_.node(bottom).kind != NodeKind::kPaths) {
      return s_.emissions().Of(bottom).size();
    }
    std::size_t wanted = 0;
    s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t owner) {
      std::uint32_t found = 0;
      s_.nodes.ForEachToken(s_.tokens, bottom, [&](std::uint32_t path) {
        if (s_.tokens.TopOf(path) == s_.tokens[owner].pairs &&
            SharedConjunctions::Pairs(network_, s_.tokens, s_.wmes, s_.pair_tests, owner, path)) {
          ++found;
        }
      });
      for (std::uint32_t r = s_.tokens[owner].first_child;
           r != kNil && (s_.tokens[owner].node & Token::kBlockedBit) != 0; r = s_.tokens[r].next_in_bucket) {
        --found;
      }
      Expect(found == 0, "wrong results of a token", owner);
      wanted += found;
    });
    return wanted + results_;
  }

  /// Checks that each identifier with which tokens wait for a shared conjunction has one anchor, which counts them.
  void CheckAnchors(std::uint32_t index) {
    std::map<std::uint32_t, std::uint32_t> owners, ids;
    for (std::uint32_t n = 0; n < network_.node_limit(); ++n) {
      const Node& node = network_.node(n);
      if (node.IsShared() && node.ancestor == index) {
        s_.nodes.ForEachToken(s_.tokens, n, [&](std::uint32_t token) { ++owners[s_.tokens[token].pairs]; });
      }
    }
    std::uint32_t count = 0;
    s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t token) {
      ++count;
      Expect(s_.tokens[token].previous_sibling == owners[token], "anchor with a wrong number of owners", token);
      Expect(++ids[s_.tokens[token].key] == 1, "two anchors of one identifier", token);
    });
    Expect(count == owners.size(), "owners without an anchor", index);
    Expect(count == s_.nodes[index].count, "wrong count of anchors", index);
  }

  /// Checks that every pair is either a token or parked, and that the tokens above have the right counts.
  void CheckSparse(std::uint32_t index) {
    const Node& node = network_.node(index);
    const std::uint32_t above = network_.node(node.parent).parent;
    Expect(s_.nodes.marks(node.parent).Is(NodeMarks::kFeedsSparse), "unmarked join of a sparse memory", index);
    Expect(s_.nodes.marks(above).Is(NodeMarks::kAboveSparse) && network_.MemoryBelow(above) == index,
           "unmarked memory above a sparse one", index);
    std::map<Emission, int> pairs;
    std::map<std::uint32_t, std::uint32_t> of_token;
    for (const Emission& emission : s_.emissions().Of(node.parent)) {
      pairs[emission] = 1;
      ++of_token[emission.first];
    }
    s_.nodes.ForEachToken(s_.tokens, index, [&](std::uint32_t token) {
      --pairs[{s_.tokens[token].parent, s_.tokens[token].wme}];
    });
    const SparseState& memory = s_.SparseOf(index);
    for (std::uint32_t n = 0; n < memory.logged; ++n) {
      if (!SparseMemories::IsStale(s_.tokens, s_.links, memory.log[n])) {
        --pairs[{memory.log[n].parent, memory.log[n].wme}];
      }
    }
    std::uint32_t indexed = 0;
    s_.sparse.ForEachIndexed(memory, [&](const ParkedPair& pair) {
      ++indexed;
      if (!SparseMemories::IsStale(s_.tokens, s_.links, pair)) {
        --pairs[{pair.parent, pair.wme}];
        Expect(pair.key == KeyOfPair(s_, node, pair.parent, pair.wme).key, "wrong key of a parked pair", index);
      }
    });
    for (const ParkedRun& run : memory.runs) {
      if (!SparseMemories::IsStale(s_.tokens, run)) {
        ForEachOfRun(s_, index, run, [&](std::uint32_t wme) {
          --pairs[{run.parent, wme}];
          return false;
        });
      }
    }
    Expect(indexed == memory.indexed, "wrong count of parked pairs", index);
    for (const auto& [pair, missing] : pairs) {
      Expect(missing == 0, "pair of a sparse memory is missing or duplicated", index);
    }
    s_.nodes.ForEachToken(s_.tokens, above, [&](std::uint32_t token) {
      Expect(s_.tokens[token].pairs == of_token[token], "wrong number of pairs of a token", token);
    });
  }

  /// Whether a node tests links to long-term memory. As in Soar, later changes of a link affect no match, so the
  /// current links may differ from those that were matched.
  bool TestsLinks(const Node& node) const {
    const auto tests = network_.tests(node);
    return std::any_of(tests.begin(), tests.end(), [](const NodeTest& test) {
      return test.op == TestOp::kIsLti || test.op == TestOp::kIsNotLti || test.op == TestOp::kSameLti ||
             test.op == TestOp::kNotSameLti;
    });
  }

  void CheckResults(const Node& node, std::uint32_t token) {
    std::size_t wanted = 0;
    for (std::uint32_t item = s_.alphas[node.alpha].first; item != kNil; item = s_.alphas.item(item).next) {
      const Wme& wme = s_.wmes[s_.alphas.item(item).wme];
      if (KeyOfElement(node, wme) == s_.tokens[token].key && HasKey(s_.tokens, s_.wmes, node, token, wme) &&
          s_.pair_tests.Passes(node, token, wme)) {
        ++wanted;
      }
    }
    std::size_t found = 0;
    for (std::uint32_t child = s_.tokens[token].first_child; child != kNil; child = s_.tokens[child].next_sibling) {
      found += (s_.tokens[child].node & Token::kResultBit) != 0 ? 1 : 0;
    }
    Expect(found == wanted || TestsLinks(node), "wrong results of a negative token", token);
  }

  const ReteState& s_;
  const Network& network_;
  std::string errors_;
  std::set<std::uint32_t> ended_;  ///< The nodes above the negations of guarded rules that never match again.
  std::size_t results_ = 0;
};

}  // namespace

std::string Rete::CheckInvariants() const {
  return Checker(*state_).Run();
}

}  // namespace soarbox::kernel
