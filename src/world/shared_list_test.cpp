// SPDX-License-Identifier: BSD-2-Clause
#include "world/shared_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "world/shared.h"
#include "world/world_random.h"

namespace soarbox::world {
namespace {

struct Thing {
  std::uint32_t id = 0;
  int value = 0;
  friend bool operator==(const Thing&, const Thing&) = default;
};
using List = SharedList<Thing>;

std::vector<Thing> All(const List& list) {
  return {list.begin(), list.end()};
}

TEST(SharedList, DoesWhatAPlainListDoesAndCopiesStayAsTheyWere) {
  RandomStream random(5, 1);
  List list;
  std::vector<Thing> plain;
  std::vector<std::pair<List, std::vector<Thing>>> copies;
  for (int i = 0; i < 3000; ++i) {
    const std::uint32_t id = 1 + random.Below(400);
    const auto at = std::lower_bound(plain.begin(), plain.end(), id, [](const Thing& t, auto n) { return t.id < n; });
    const List::Place place = list.Find(id, {random.Below(4), random.Below(40)});
    const bool is_there = at != plain.end() && at->id == id;
    ASSERT_EQ(list.IsEnd(place), at == plain.end());
    if (at != plain.end()) {
      ASSERT_EQ(list.At(place), *at);
    }
    if (!is_there) {
      plain.insert(at, {id, i});
      ASSERT_EQ(list.At(list.Insert(place, {id, i})).id, id);
    } else if (random.Below(2) == 0) {
      at->value = list.Edit(place).value = i;
    } else {
      const auto after = plain.erase(at);
      const List::Place next = list.Erase(place);
      ASSERT_EQ(list.IsEnd(next), after == plain.end());
      if (after != plain.end()) {
        ASSERT_EQ(list.At(next), *after);
      }
    }
    ASSERT_EQ(list.size(), plain.size());
    if (i % 300 == 7) copies.emplace_back(list, plain);
  }
  EXPECT_EQ(All(list), plain);
  for (std::size_t i = 0; i < plain.size(); i += 17) EXPECT_EQ(list[i], plain[i]);
  for (const auto& [copy, then] : copies) EXPECT_EQ(All(copy), then);
}

TEST(SharedList, ACopySharesAllBlocksButTheChangedOne) {
  List list;
  for (std::uint32_t id = 1; id <= 5 * List::kMostPerBlock; ++id) list.push_back({id, 0});
  const List copy = list;
  list.Edit(list.Find(2 * List::kMostPerBlock + 3)).value = 1;
  for (std::size_t block = 0; block < 5; ++block) EXPECT_EQ(list.SharesBlock(block, copy, block), block != 2);
  EXPECT_EQ(copy[2 * List::kMostPerBlock + 2].value, 0);
}

TEST(Shared, ReadsLikeItsValueAndIsSharedByCopies) {
  const Shared<std::string> empty, red = "Red";
  const Shared<std::string> copy = red;
  EXPECT_TRUE(empty.empty());
  EXPECT_EQ(red, "Red");
  EXPECT_EQ(red, Shared<std::string>(std::string("Red")));
  EXPECT_TRUE(copy.IsSame(red));
  EXPECT_FALSE(copy == empty);
}

}  // namespace
}  // namespace soarbox::world
