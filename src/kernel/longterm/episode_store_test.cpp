// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_store.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "kernel/longterm/naive_episodes_test_support.h"

namespace soarbox::kernel {
namespace {

constexpr EpisodeTerm kColor = 1, kPart = 2, kRed = 10, kBlue = 11;

EpisodeTriple Constant(EpisodeNode parent, EpisodeTerm attribute, EpisodeTerm value) {
  return {parent, attribute, EpisodeValue::Constant(value)};
}

EpisodeTriple LinkTriple(EpisodeNode parent, EpisodeTerm attribute, EpisodeNode value) {
  return {parent, attribute, EpisodeValue::Node(value)};
}

TEST(EpisodeStore, AFactHoldsInTheEpisodesInWhichItWasHeld) {
  EpisodeStore store;
  const EpisodeFact red = store.Intern(Constant(0, kColor, kRed));
  store.Hold(red);
  EXPECT_EQ(store.Commit(), 1u);
  store.Commit();
  store.Release(red);
  store.Commit();
  store.Hold(red);
  store.Commit();
  EXPECT_EQ(store.Latest(red, 4), 4u);
  EXPECT_EQ(store.Latest(red, 3), 2u);
  EXPECT_EQ(store.SameSince(red, 3), 3u);
  EXPECT_EQ(store.SameSince(red, 2), 1u);
  EXPECT_TRUE(store.Replay(3).empty());
  EXPECT_EQ(store.Replay(4), std::vector<EpisodeFact>{red});
}

TEST(EpisodeStore, WhatGoesAndComesBackBetweenTwoEpisodesIsNoChange) {
  EpisodeStore store;
  const EpisodeFact red = store.Intern(Constant(0, kColor, kRed));
  store.Hold(red);
  store.Commit();
  store.Release(red);
  store.Hold(red);
  store.Commit();
  EXPECT_TRUE(store.LastChanges().empty());
  EXPECT_EQ(store.OpenSince(red), 1u);
}

TEST(EpisodeStore, AFactThatIsHeldTwiceStaysUntilBothAreGone) {
  EpisodeStore store;
  const EpisodeFact red = store.Intern(Constant(0, kColor, kRed));
  store.Hold(red);
  store.Hold(red);
  store.Commit();
  store.Release(red);
  store.Commit();
  EXPECT_TRUE(store.Holds(red, 2));
  store.Release(red);
  store.Commit();
  EXPECT_FALSE(store.Holds(red, 3));
}

TEST(EpisodeStore, ReleasingAllEndsEverything) {
  EpisodeStore store;
  const EpisodeFact red = store.Intern(Constant(0, kColor, kRed));
  const EpisodeFact blue = store.Intern(Constant(0, kColor, kBlue));
  store.Hold(red);
  store.Commit();
  store.Hold(blue);
  store.ReleaseAll();
  store.Hold(blue);
  store.Commit();
  EXPECT_EQ(store.Replay(2), std::vector<EpisodeFact>{blue});
  EXPECT_EQ(store.Replay(1), std::vector<EpisodeFact>{red});
}

TEST(EpisodeStore, ANodesLinkIsThatOfTheEpisode) {
  EpisodeStore store;
  const EpisodeNode node = store.NewNode();
  store.Commit();
  store.SetLink(node, 7);
  store.Commit();
  store.SetLink(node, 0);
  store.Commit();
  EXPECT_EQ(store.Link(node, 1), 0u);
  EXPECT_EQ(store.Link(node, 2), 7u);
  EXPECT_EQ(store.Link(node, 3), 0u);
}

TEST(EpisodeCue, ALinkBackToAnObjectOnTheWayIsLeftOut) {
  // (<q> ^part <a>) (<a> ^color red ^part <b>) (<b> ^color blue ^part <a>)
  const std::vector<EpisodeCueElement> elements = {{0, kPart, true, 1, 1},
                                                   {1, kColor, false, kRed, 1},
                                                   {1, kPart, true, 2, 1},
                                                   {2, kColor, false, kBlue, 1},
                                                   {2, kPart, true, 1, 1}};
  const EpisodeCue cue(elements, 3);
  EXPECT_EQ(cue.variable_count(), 3u);
  EXPECT_EQ(cue.edges().size(), 4u);
  EXPECT_EQ(cue.leaf_count(), 2u);
  EXPECT_EQ(cue.TopDown().size(), 3u);
}

TEST(EpisodeCue, AnObjectThatLeadsNowhereButBackIsLeftOut) {
  const std::vector<EpisodeCueElement> elements = {{0, kPart, true, 1, 1}, {1, kPart, true, 1, 1}};
  const EpisodeCue cue(elements, 2);
  EXPECT_EQ(cue.variable_count(), 1u);
  EXPECT_TRUE(cue.edges().empty());
  EXPECT_EQ(cue.leaf_count(), 0u);
}

TEST(EpisodeCue, AnObjectWithoutElementsIsALeaf) {
  const std::vector<EpisodeCueElement> elements = {{0, kPart, true, 1, 1}, {0, kColor, true, 1, 1}};
  const EpisodeCue cue(elements, 2);
  EXPECT_EQ(cue.leaf_count(), 2u);
  // Each link is matched separately.
  EXPECT_EQ(cue.variable_count(), 3u);
  EXPECT_EQ(cue.ObjectOf(1), cue.ObjectOf(2));
}

TEST(EpisodeCue, AChainOfAHundredThousandObjectsIsRead) {
  std::vector<EpisodeCueElement> elements;
  EpisodeStore store;
  constexpr std::uint32_t kLength = 100'000;
  for (std::uint32_t n = 0; n < kLength; ++n) {
    elements.push_back({n, kPart, true, n + 1, 1});
    store.Hold(store.Intern(LinkTriple(n, kPart, n + 1)));
  }
  store.Commit();
  EpisodeQuery query;
  query.positive = EpisodeCue(elements, kLength + 1);
  query.window.last = 1;
  query.graph_match = false;
  EXPECT_EQ(Answer(store, query).cardinality, 1);
}

TEST(EpisodeWindow, ProhibitedEpisodesAreSkippedAlsoWhenNamedTwice) {
  const EpisodeWindow window{2, 9, {3, 5, 6, 6, 7, 40}};
  EXPECT_EQ(window.Latest(12), 9u);
  EXPECT_EQ(window.Latest(7), 4u);
  EXPECT_EQ(window.Latest(6), 4u);
  EXPECT_EQ(window.Latest(3), 2u);
  EXPECT_EQ(window.Latest(1), 0u);
}

// Random worlds -------------------------------------------------------------------------------------------------------

class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed) {}

  unsigned Draw(unsigned limit) { return static_cast<unsigned>(random_() % limit); }

  EpisodeTriple DrawTriple() {
    const EpisodeNode parent = Draw(5);
    if (Draw(2) == 0) return LinkTriple(parent, kPart + Draw(2), 1 + Draw(4));
    return Constant(parent, Draw(2), 10 + Draw(3));
  }

  void Step() {
    for (unsigned n = Draw(5); n > 0; --n) {
      const EpisodeTriple triple = DrawTriple();
      const EpisodeFact fact = store.Intern(triple);
      if (naive.Holds(triple)) {
        naive.Release(triple);
        store.Release(fact);
      } else {
        naive.Hold(triple);
        store.Hold(fact);
      }
    }
    naive.Commit();
    store.Commit();
  }

  /// A cue that is copied from an episode with small changes: nodes become objects, and some become two objects.
  EpisodeCue DrawCue(unsigned largest, bool uneven) {
    const std::set<NaiveEpisodes::Fact>& episode = naive.Episode(1 + Draw(store.last()));
    std::vector<EpisodeCueElement> elements;
    std::vector<EpisodeNode> node_of = {0};
    for (std::uint32_t object = 0; object < node_of.size() && elements.size() < largest; ++object) {
      for (const auto& [parent, attribute, bits] : episode) {
        if (parent != node_of[object] || Draw(3) == 0 || elements.size() >= largest) continue;
        const EpisodeValue value = EpisodeValue::FromBits(bits);
        EpisodeCueElement element{object, attribute, value.IsNode(), 0, uneven ? Draw(5) * 0.5 - 0.5 : 1.0};
        if (Draw(12) == 0) element.attribute = kPart;
        if (!value.IsNode()) {
          element.value = Draw(10) == 0 ? 10 + Draw(3) : value.term();
        } else {
          std::uint32_t to = 0;
          while (to < node_of.size() && node_of[to] != value.node()) ++to;
          if (to == node_of.size() || Draw(6) == 0) {
            to = static_cast<std::uint32_t>(node_of.size());
            node_of.push_back(value.node());
          }
          element.value = to;
        }
        elements.push_back(element);
      }
    }
    return EpisodeCue(elements, static_cast<std::uint32_t>(node_of.size()));
  }

  EpisodeQuery DrawQuery() {
    EpisodeQuery query;
    const bool uneven = Draw(4) == 0;
    query.positive = DrawCue(1 + Draw(5), uneven);
    if (Draw(2) == 0) query.negative = DrawCue(1 + Draw(2), uneven);
    query.window.last = Draw(2) == 0 ? store.last() : Draw(store.last() + 1);
    query.window.first = 1 + (Draw(2) == 0 ? 0 : Draw(store.last()));
    for (unsigned n = Draw(2) * Draw(8); n > 0; --n) query.window.prohibited.push_back(1 + Draw(store.last()));
    // If the first episode is prohibited, Soar leaves the window; exhaustive search does not.
    std::erase(query.window.prohibited, query.window.first);
    std::sort(query.window.prohibited.begin(), query.window.prohibited.end());
    query.graph_match = Draw(4) != 0;
    return query;
  }

  EpisodeStore store;
  NaiveEpisodes naive;

 private:
  std::mt19937 random_;
};

TEST(EpisodeStoreRandom, ReplayGivesEachEpisodeBack) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomWorld world(seed);
    for (int step = 0; step < 80; ++step) world.Step();
    EXPECT_STREQ(world.store.CheckInvariants(), "") << "seed " << seed;
    for (EpisodeNumber episode = 1; episode <= world.store.last(); ++episode) {
      std::set<NaiveEpisodes::Fact> facts;
      for (const EpisodeFact fact : world.store.Replay(episode)) {
        const EpisodeTriple triple = world.store.triple(fact);
        facts.insert({triple.parent, triple.attribute, triple.value.bits()});
      }
      EXPECT_EQ(facts, world.naive.Episode(episode)) << "seed " << seed << ", episode " << episode;
    }
  }
}

TEST(EpisodeStoreRandom, QueriesAreAnsweredAsByTryingEverything) {
  unsigned graphs = 0, surfaces = 0, failures = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    RandomWorld world(seed);
    for (int step = 0; step < 40; ++step) world.Step();
    for (int n = 0; n < 60; ++n) {
      const EpisodeQuery query = world.DrawQuery();
      const EpisodeAnswer expected = world.naive.Answer(query), answer = Answer(world.store, query);
      ASSERT_EQ(answer.episode, expected.episode) << "seed " << seed << ", query " << n;
      ASSERT_EQ(answer.graph_matched, expected.graph_matched) << "seed " << seed << ", query " << n;
      ASSERT_EQ(answer.cardinality, expected.cardinality) << "seed " << seed << ", query " << n;
      ASSERT_NEAR(answer.score, expected.score, 1e-12) << "seed " << seed << ", query " << n;
      if (answer.graph_matched) {
        ++graphs;
        ASSERT_TRUE(NaiveEpisodes::IsMatch(world.naive.Episode(answer.episode), query.positive, answer.nodes));
      } else {
        ++(answer.episode == 0 ? failures : surfaces);
      }
    }
  }
  // The generator must produce all three kinds.
  EXPECT_GT(graphs, 100u);
  EXPECT_GT(surfaces, 100u);
  EXPECT_GT(failures, 100u);
}

}  // namespace
}  // namespace soarbox::kernel
