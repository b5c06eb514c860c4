// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/tournament.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soarbox::sweep {
namespace {

/// Two agents that play on `boards` boards, `copies` times in both seats of each. The first agent wins on two of three
/// boards.
std::vector<Row> Games(Spec& spec, std::size_t boards, std::size_t copies) {
  spec = {};
  spec.players = {"hunter", "wanderer"};
  spec.seatings = {{0, 1}, {1, 0}};
  spec.metrics.resize(2);
  std::vector<Row> rows;
  for (std::size_t board = 0; board < boards; ++board) {
    for (std::size_t game = 0; game < 2 * copies; ++game) {
      Row row;
      row.variant = game % 2;
      row.seed = board + 1;
      row.result.outcome = "ok";
      const bool first_wins = board % 3 != 0;
      const bool seat_0_wins = first_wins == (row.variant == 0);
      row.metrics = {seat_0_wins ? 10.0 : 0.0, seat_0_wins ? 0.0 : 10.0};
      rows.push_back(row);
    }
  }
  return rows;
}

double WidthOf(const Standing& standing) {
  return standing.rating_high - standing.rating_low;
}

TEST(Tournament, MoreGamesOnABoardMakeNoIntervalNarrower) {
  Spec spec;
  const std::vector<Row> one = Games(spec, 30, 1), ten = Games(spec, 30, 10);
  const Standing once = Standings(spec, one).front(), often = Standings(spec, ten).front();
  EXPECT_EQ(once.player, "hunter");
  EXPECT_EQ(often.games, 10 * once.games);
  EXPECT_GT(WidthOf(often), 0.9 * WidthOf(once));
}

TEST(Tournament, MoreBoardsMakeIntervalsNarrower) {
  Spec spec;
  const std::vector<Row> few = Games(spec, 30, 1), many = Games(spec, 480, 1);
  const double narrow = WidthOf(Standings(spec, many).front()), wide = WidthOf(Standings(spec, few).front());
  // Sixteen times as many boards give a quarter of the width.
  EXPECT_NEAR(narrow / wide, 0.25, 0.1);
}

TEST(Tournament, RatingsAreThoseOfBradleyAndTerryWithOneDrawAgainstAnAverageOpponent) {
  Spec spec;
  const std::vector<Row> rows = Games(spec, 30, 1);
  const std::vector<Standing> standings = Standings(spec, rows);
  // 40 wins of 60 and a draw against strength 1: s = 40.5 / (1 / (s + 1) + 60 / (s + 1 / s)), as the other has 1 / s.
  double strength = 1;
  for (int i = 0; i < 500; ++i) strength = 40.5 / (1 / (strength + 1) + 60 / (strength + 1 / strength));
  EXPECT_NEAR(standings[0].rating, 1500 + 400 * std::log10(strength), 0.5);
  EXPECT_NEAR(standings[0].rating + standings[1].rating, 3000, 1e-6);
}

}  // namespace
}  // namespace soarbox::sweep
