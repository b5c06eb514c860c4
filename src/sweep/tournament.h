// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// What one agent of a tournament has reached.
struct Standing {
  std::string player;
  std::size_t seats = 2;  ///< Of each game.
  std::size_t games = 0, wins = 0, draws = 0, losses = 0;
  double place = 0;                        ///< On average; 1 is the best of a game. Equal agents share places.
  double points = 0;                       ///< Per game.
  double rating = 0;                       ///< On Elo's scale, 1500 on average: 400 more wins ten games of eleven.
  double rating_low = 0, rating_high = 0;  ///< 95 %, from resampling the seeds, each with all its games.
};

/// The agents of a tournament by what the rows say, best first. The agent with the most points wins a game; it is drawn
/// for those who share the most. For ratings, each two of its agents have played against each other.
std::vector<Standing> Standings(const Spec& spec, const std::vector<Row>& rows);

/// The table of a tournament as text.
std::string TournamentTable(const Spec& spec, const std::vector<Row>& rows);

}  // namespace soarbox::sweep
