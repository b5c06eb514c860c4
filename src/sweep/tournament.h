// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// The results of one agent of a tournament.
struct Standing {
  std::string player;
  std::size_t seats = 2;  ///< Per game.
  std::size_t games = 0, wins = 0, draws = 0, losses = 0;
  double place = 0;                        ///< Mean rank; 1 is the best of a game. Agents with equal points share
                                           ///< ranks.
  double points = 0;                       ///< Mean per game.
  double rating = 0;                       ///< Elo rating with a mean of 1500. An agent with 400 more points wins ten
                                           ///< games of eleven.
  double rating_low = 0, rating_high = 0;  ///< 95 % interval, from resampling the seeds, each with all its games.
};

/// The agents of a tournament according to the rows, best first. The agent with most points wins a game; if several
/// have most points, it is a draw for them. For ratings, a game counts as a game of each pair of its agents.
std::vector<Standing> Standings(const Spec& spec, const std::vector<Row>& rows);

/// The table of a tournament as text.
std::string TournamentTable(const Spec& spec, const std::vector<Row>& rows);

}  // namespace soarbox::sweep
