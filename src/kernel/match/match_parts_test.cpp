// SPDX-License-Identifier: BSD-2-Clause
// Tests of the parts of a match in isolation. rete_test.cpp and rete_random_test.cpp test them together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <vector>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/element_links.h"
#include "kernel/match/meeting_order.h"
#include "kernel/match/node_states.h"
#include "kernel/match/only_ids.h"
#include "kernel/match/right_side.h"
#include "kernel/match/rule_numbers.h"
#include "kernel/match/sparse_memories.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Symbol Id(std::uint32_t number) {
  return Symbol(Symbol::Tag::kIdentifier, number);
}
Symbol Number(std::uint32_t number) {
  return Symbol(Symbol::Tag::kSmallInteger, number);
}

class MatchPartsTest : public testing::Test {
 protected:
  /// Adds an element to the match.
  std::uint32_t Enter(std::uint64_t timetag = 1) {
    const std::uint32_t wme = next_wme_++;
    elements.Enter(wme, tokens.TakeSerial(), timetag, 0);
    return wme;
  }
  std::vector<std::uint32_t> TokensOf(std::uint32_t wme) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t token = elements[wme].first_token; token != kNil; token = tokens[token].next_of_wme) {
      found.push_back(token);
    }
    return found;
  }
  std::vector<std::uint32_t> ChildrenOf(std::uint32_t parent) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t token = tokens[parent].first_child; token != kNil; token = tokens[token].next_sibling) {
      found.push_back(token);
    }
    return found;
  }
  std::vector<std::uint32_t> TokensAt(std::uint32_t node) const {
    std::vector<std::uint32_t> found;
    nodes.ForEachToken(tokens, node, [&](std::uint32_t token) { found.push_back(token); });
    return found;
  }
  /// The elements that the right side of a join on memory 0 offers for a key.
  std::vector<std::uint32_t> Offered(KeyKind kind, Symbol id, Symbol value) {
    Node join;
    join.kind = NodeKind::kJoin;
    join.key = kind;
    join.alpha = 0;
    KeyParts key;
    key.id = id.bits();
    key.value = value.bits();
    key.key = kind == KeyKind::kIdValue ? PairKey(key.id, key.value) : key.id;
    const RightSide right(alphas, join);
    std::vector<std::uint32_t> found;
    right.ForEach(key, [&](std::uint32_t wme) { found.push_back(wme); });
    std::vector<std::uint32_t> one_by_one;
    for (std::uint32_t item = right.First(key); item != kNil; item = right.Next(item, key)) {
      one_by_one.push_back(right.Element(item));
    }
    EXPECT_EQ(found, one_by_one);
    return found;
  }

  TokenPool tokens;
  ElementLinks elements;
  AlphaMemories alphas;
  NodeStates nodes;

 private:
  std::uint32_t next_wme_ = 0;
};

// Elements ------------------------------------------------------------------------------------------------------------

TEST_F(MatchPartsTest, ElementsStandNewestFirstAndLeaveFromAnywhere) {
  const std::uint32_t first = Enter(5), second = Enter(9), third = Enter(7);
  EXPECT_EQ(elements.count(), 3u);
  EXPECT_EQ(elements.last_timetag(), 9u);
  elements.BeginLeaving(second, tokens.TakeSerial());
  elements.Leave(elements[second]);
  EXPECT_EQ(elements.newest(), third);
  EXPECT_EQ(elements[third].next, first);
  EXPECT_EQ(elements[first].previous, third);
  EXPECT_FALSE(elements[second].in_match);
  EXPECT_EQ(elements.count(), 2u);
}

TEST_F(MatchPartsTest, WhenALeavingElementCameIsKnownUntilItHasLeft) {
  const std::uint32_t wme = Enter();
  const std::uint64_t arrival = elements[wme].serial;
  elements.BeginLeaving(wme, tokens.TakeSerial());
  EXPECT_EQ(elements.leaving(), wme);
  EXPECT_EQ(elements.ArrivalOf(wme), arrival);
  EXPECT_GT(elements[wme].serial, arrival);
  elements.Leave(elements[wme]);
  EXPECT_EQ(elements.leaving(), kNil);
}

// Tokens --------------------------------------------------------------------------------------------------------------

TEST_F(MatchPartsTest, ATokenIsOnTheListsOfItsParentAndItsElementNewestFirst) {
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t top = tokens.Make(elements, 1, kNil, a);
  const std::uint32_t first = tokens.Make(elements, 2, top, b), second = tokens.Make(elements, 2, top, b);
  EXPECT_THAT(ChildrenOf(top), ElementsAre(second, first));
  EXPECT_THAT(TokensOf(b), ElementsAre(second, first));
  EXPECT_TRUE(tokens.Holds(second, b));
  EXPECT_FALSE(tokens.Holds(second, a));  // The topmost token has no element.
  EXPECT_EQ(tokens.TopOf(second), top);
  tokens.Unlink(elements, second);
  tokens.Free(second);
  EXPECT_THAT(ChildrenOf(top), ElementsAre(first));
  EXPECT_THAT(TokensOf(b), ElementsAre(first));
}

TEST_F(MatchPartsTest, TheRecordThatWasGivenBackLastIsUsedFirst) {
  const std::uint32_t wme = Enter();
  const std::uint32_t a = tokens.Make(elements, 1, kNil, wme), b = tokens.Make(elements, 1, kNil, wme);
  for (const std::uint32_t token : {a, b}) {
    tokens.Unlink(elements, token);
    tokens.Free(token);
  }
  EXPECT_EQ(tokens.CountInUse(), 0u);
  EXPECT_EQ(tokens.Make(elements, 1, kNil, wme), b);
  EXPECT_EQ(tokens.Make(elements, 1, kNil, wme), a);
  EXPECT_EQ(tokens.CountInUse(), 2u);
}

TEST_F(MatchPartsTest, ListsThatLateTokensCameIntoAreSortedByTheTimeOfTheirArrival) {
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t top = tokens.Make(elements, 1, kNil, a);
  const std::uint64_t early = tokens.TakeSerial();
  const std::uint32_t on_time = tokens.Make(elements, 2, top, b);
  const std::uint32_t late = tokens.Make(elements, 2, top, b, early);
  tokens[top].node |= Token::kUnsortedBit;
  elements[b].unsorted = true;
  EXPECT_THAT(ChildrenOf(top), ElementsAre(late, on_time));
  tokens.SortChildren(top);
  tokens.SortTokensOf(elements[b]);
  EXPECT_THAT(ChildrenOf(top), ElementsAre(on_time, late));
  EXPECT_THAT(TokensOf(b), ElementsAre(on_time, late));
  EXPECT_EQ(tokens[top].node, 1u);
  EXPECT_FALSE(elements[b].unsorted);
}

// Alpha memories ------------------------------------------------------------------------------------------------------

TEST_F(MatchPartsTest, AnIndexOffersWhatTheListOffers) {
  alphas.Begin(0);
  std::vector<std::uint32_t> of_three, of_pair;
  for (std::uint32_t n = 0; n < 200; ++n) {
    const std::uint32_t wme = Enter();
    Wme element;
    element.id = Id(n % 7);
    element.value = Number(n % 5);
    alphas.Insert(0, wme, element, elements[wme].first_item);
    if (element.id == Id(3)) of_three.insert(of_three.begin(), wme);
    if (element.id == Id(3) && element.value == Number(2)) of_pair.insert(of_pair.begin(), wme);
    EXPECT_EQ(Offered(KeyKind::kId, Id(3), Symbol()), of_three);
    EXPECT_EQ(Offered(KeyKind::kIdValue, Id(3), Number(2)), of_pair);
    EXPECT_EQ(Offered(KeyKind::kNone, Symbol(), Symbol()).size(), alphas[0].count);
  }
  ASSERT_FALSE(of_pair.empty());
  EXPECT_NE(alphas[0].id_bits, 0);
  EXPECT_NE(alphas[0].pair_bits, 0);
  EXPECT_EQ(alphas.CountInIdTable(alphas[0]), alphas[0].count);
  EXPECT_EQ(alphas.CountInPairTable(alphas[0]), alphas[0].count);

  const std::uint32_t item = elements[of_pair.front()].first_item;
  alphas.TakeOut(alphas[0], item);
  --alphas[0].count;
  alphas.Free(item);
  of_pair.erase(of_pair.begin());
  EXPECT_EQ(Offered(KeyKind::kIdValue, Id(3), Number(2)), of_pair);
  EXPECT_EQ(alphas.CountInIdTable(alphas[0]), alphas[0].count);
  EXPECT_EQ(alphas.CountInPairTable(alphas[0]), alphas[0].count);
}

TEST_F(MatchPartsTest, AMemoryThatGoesTakesItsItemsOffTheirElements) {
  alphas.Begin(0);
  alphas.Begin(1);
  const std::uint32_t wme = Enter();
  alphas.Insert(0, wme, Wme(), elements[wme].first_item);
  alphas.Insert(1, wme, Wme(), elements[wme].first_item);
  alphas.Drop(0, elements);
  const std::uint32_t left = elements[wme].first_item;
  EXPECT_EQ(alphas.item(left).alpha, 1u);
  EXPECT_EQ(alphas.item(left).next_of_wme, kNil);
  EXPECT_EQ(alphas[0].count, 0u);
}

// Nodes ---------------------------------------------------------------------------------------------------------------

TEST_F(MatchPartsTest, TokensOfOneKeyStandNewestFirstHoweverTheTableGrows) {
  nodes.MakeRoom(2);
  const std::uint32_t wme = Enter();
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t n = 0; n < 300; ++n) {
    const std::uint32_t token = tokens.Make(elements, 1, kNil, wme);
    nodes.Insert(tokens, 1, token, n % 11, true);
    if (n % 11 == 4) wanted.insert(wanted.begin(), token);
  }
  EXPECT_EQ(nodes[1].count, 300u);
  EXPECT_EQ(TokensAt(1).size(), 300u);
  EXPECT_NE(nodes.marks(1).bits(), 0u);
  std::vector<std::uint32_t> found;
  for (std::uint32_t token = nodes.BucketHead(1, 4); token != kNil; token = tokens[token].next_in_bucket) {
    if (tokens[token].key == 4) found.push_back(token);
  }
  EXPECT_EQ(found, wanted);
  for (const std::uint32_t token : TokensAt(1)) nodes.RemoveFromBucket(tokens, 1, token);
  EXPECT_EQ(nodes[1].count, 0u);
  EXPECT_THAT(TokensAt(1), IsEmpty());
}

TEST_F(MatchPartsTest, ATableGrowsWithItsKeysNotWithTokensOfTheSame) {
  nodes.MakeRoom(3);
  const std::uint32_t wme = Enter();
  for (std::uint32_t n = 0; n < 5000; ++n) {
    nodes.Insert(tokens, 1, tokens.Make(elements, 1, kNil, wme), n % 3, true);
    nodes.Insert(tokens, 2, tokens.Make(elements, 2, kNil, wme), n < 1000 ? n % 3 : n, true);
  }
  EXPECT_EQ(nodes.marks(1).bits(), 8u);
  EXPECT_EQ(nodes.marks(2).bits(), 12u);  // Checked at 2,048 and 4,096 tokens; by then there are many keys.
  EXPECT_EQ(TokensAt(1).size(), 5000u);
  EXPECT_EQ(TokensAt(2).size(), 5000u);
}

TEST_F(MatchPartsTest, AJoinIsOnItsMemorysListWhileItIsLinked) {
  nodes.MakeRoom(4);
  nodes.LinkLeft(2, 1);
  nodes.LinkLeft(3, 1);
  EXPECT_EQ(nodes[1].first_linked, 3u);
  EXPECT_EQ(nodes[3].next_left, 2u);
  nodes.UnlinkLeft(3, 1);
  EXPECT_EQ(nodes[1].first_linked, 2u);
  EXPECT_FALSE(nodes.marks(3).Is(NodeMarks::kLeftLinked));
  EXPECT_TRUE(nodes.marks(2).Is(NodeMarks::kLeftLinked));
}

TEST_F(MatchPartsTest, ElementsAreFoundByTheirValueWithAndWithoutATable) {
  alphas.Begin(0);
  std::vector<std::uint32_t> entered;
  const auto found = [&](std::uint32_t value) {
    std::vector<std::uint32_t> all;
    alphas.ForEachWithValue(0, Number(value).bits(), [&](const AlphaItem& item) { all.push_back(item.wme); });
    return all;
  };
  for (std::uint32_t n = 0; n < 300; ++n) {
    Wme element;
    element.id = Id(1 + n % 7);
    element.value = Number(n % 100);
    entered.push_back(Enter());
    alphas.Insert(0, entered[n], element, elements[entered[n]].first_item);
    if (n == 5 || n == 50) {
      EXPECT_THAT(found(3), ElementsAre(entered[3]));
    }
  }
  EXPECT_THAT(found(3), testing::UnorderedElementsAre(entered[3], entered[103], entered[203]));
  alphas.TakeOut(alphas[0], elements[entered[103]].first_item);
  EXPECT_THAT(found(3), testing::UnorderedElementsAre(entered[3], entered[203]));
  EXPECT_THAT(found(100), IsEmpty());
}

// Parked pairs --------------------------------------------------------------------------------------------------------

TEST_F(MatchPartsTest, AParkedPairIsFoundByItsKeyUntilItsElementHasLeft) {
  SparseMemories sparse;
  SparseState& memory = sparse[sparse.Take()];
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t above = tokens.Make(elements, 1, kNil, a);
  sparse.MakeRoomToPark(tokens, elements, memory);
  for (const std::uint32_t wme : {a, b}) memory.log[memory.logged++] = {above, wme, tokens.TakeSerial(), 17, kNil};
  elements.BeginLeaving(b, tokens.TakeSerial());
  elements.Leave(elements[b]);
  sparse.Index(tokens, elements, memory);
  EXPECT_EQ(memory.logged, 0u);
  EXPECT_EQ(memory.indexed, 1u);
  std::vector<std::uint32_t> taken;
  const auto take = [&](const ParkedPair& pair) {
    taken.push_back(pair.wme);
    return true;
  };
  sparse.TakePairs(memory, 18, take);
  EXPECT_THAT(taken, IsEmpty());
  sparse.TakePairs(memory, 17, take);
  EXPECT_THAT(taken, ElementsAre(a));
  EXPECT_EQ(memory.indexed, 0u);
}

TEST_F(MatchPartsTest, AFullLogKeepsThePairsWhoseElementsAndTokensAreStillThere) {
  SparseMemories sparse;
  SparseState& memory = sparse[sparse.Take()];
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t first = tokens.Make(elements, 1, kNil, a), second = tokens.Make(elements, 1, kNil, a);
  const auto park = [&](std::uint32_t parent, std::uint32_t wme) {
    if (memory.logged == memory.log_limit) sparse.MakeRoomToPark(tokens, elements, memory);
    memory.log[memory.logged++] = {parent, wme, tokens.TakeSerial(), 17, kNil};
  };
  for (int n = 0; n < 4; ++n) park(first, a), park(second, a), park(first, b);
  elements.BeginLeaving(b, tokens.TakeSerial());
  elements.Leave(elements[b]);
  tokens.ForgetPairs(tokens[second]);
  for (int n = 0; n < 5; ++n) park(second, a);  // The log is full at the last one.
  EXPECT_EQ(memory.saved, 8u);
  EXPECT_EQ(memory.logged, 4u + 5u);
  for (std::uint32_t n = 0; n < memory.logged; ++n) {
    EXPECT_FALSE(sparse.IsStale(tokens, elements, memory.log[n])) << n;
  }
}

TEST_F(MatchPartsTest, ARunIsStaleOnceItsTokenHasLeftAndThenMakesRoom) {
  SparseMemories sparse;
  SparseState& memory = sparse[sparse.Take()];
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t first = tokens.Make(elements, 1, kNil, a), second = tokens.Make(elements, 1, kNil, b);
  for (int n = 0; n < 20; ++n) {
    sparse.Park(tokens, memory,
                {n == 0 ? second : first, 3, tokens.TakeSerial(), elements[b].serial, elements[a].serial});
    if (n == 10) tokens.ForgetPairs(tokens[first]);
  }
  EXPECT_EQ(memory.saved, 3 * 10u);  // The log has room for sixteen pairs, and ten of these were stale.
  EXPECT_EQ(memory.runs.size(), 10u);
  EXPECT_EQ(memory.runs.front().parent, second);
  EXPECT_TRUE(std::ranges::none_of(memory.runs, [&](const ParkedRun& run) { return sparse.IsStale(tokens, run); }));
}

TEST_F(MatchPartsTest, AMemoryBecomesSparseWhenItsScoreReachesTheThreshold) {
  SparseMemories sparse;
  sparse.ParkAfter(3);
  std::uint32_t score = 0;
  sparse.AddToScore(score, 5, false);
  sparse.AddToScore(score, 5, true);  // A pair that joins lowers the score.
  for (int n = 0; n < 2; ++n) sparse.AddToScore(score, 5, false);
  EXPECT_FALSE(sparse.HasChanges());
  sparse.AddToScore(score, 5, false);
  EXPECT_THAT(sparse.becoming_sparse(), ElementsAre(5u));
}

TEST_F(MatchPartsTest, ALogThatMayNotGrowIsTold) {
  SparseMemories sparse;
  sparse.SetLimit(0);
  SparseState& memory = sparse[sparse.Take()];
  EXPECT_THROW(sparse.MakeRoomToPark(tokens, elements, memory), std::bad_alloc);
  EXPECT_TRUE(sparse.at_limit());
}

// The rest ------------------------------------------------------------------------------------------------------------

TEST(RuleNumbers, ANumberIsFreeAgainWhenTheLastMatchOfItsRuleHasGone) {
  MatchSet matches;
  RuleNumbers numbers;
  EXPECT_EQ(numbers.Take(matches, 0), 0u);
  matches.RuleAdded(0, 0, false);
  MatchSet::Arrival arrival;
  arrival.production = 0;
  const MatchId match = matches.AddFired(arrival, InstantiationId::kNone);
  numbers.Retire(0, nullptr);
  EXPECT_EQ(numbers.Take(matches, 1), 1u);
  matches.Drop(match);
  EXPECT_EQ(numbers.Take(matches, 2), 0u);
  numbers.GiveBack(0, 2);
  EXPECT_EQ(numbers.Take(matches, 2), 0u);
}

TEST(OnlyIds, ThereAreNoneUntilAMemoryIsBusyAndThenOnePerNode) {
  OnlyIds ids;
  ids.MakeRoom(10);
  EXPECT_TRUE(ids.empty());
  ids.Begin(3);
  ids[2] = 7;
  ids.MakeRoom(4);
  EXPECT_EQ(ids[2], 7u);
  EXPECT_EQ(ids[3], 0u);
}

TEST_F(MatchPartsTest, TheOwnerThatCameLastMeetsAPathFirst) {
  const std::uint32_t a = Enter(), b = Enter();
  const std::uint32_t anchor = tokens.Make(elements, 1, kNil, kNil);
  const std::uint32_t older = tokens.Make(elements, 2, kNil, a), newer = tokens.Make(elements, 2, kNil, b);
  const std::uint32_t wme = Enter();
  const std::uint32_t path = tokens.Make(elements, 3, anchor, wme);
  const MeetingOrder order(tokens, elements);
  EXPECT_TRUE(order.CameLater(order.Meeting(older, path), order.Meeting(newer, path)));
  EXPECT_FALSE(order.CameLater(order.Meeting(newer, path), order.Meeting(older, path)));
}

}  // namespace
}  // namespace soarbox::kernel
