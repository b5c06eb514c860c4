// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/tournament.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <sstream>

namespace soarbox::sweep {
namespace {

constexpr int kResamples = 300;
constexpr int kRounds = 200;
constexpr double kMean = 1500, kScale = 400;

/// One game: the agents in the seats, and their points.
struct Game {
  const Seating* seating = nullptr;
  std::vector<double> points;  ///< By seat.
  std::uint64_t seed = 0;      ///< Games with the same seed have the same initial world.

  /// The result of an agent against another: 1, a half, or 0.
  double Share(std::size_t seat, std::size_t other) const {
    return points[seat] > points[other] ? 1 : points[seat] < points[other] ? 0 : 0.5;
  }
};

std::vector<Game> Games(const Spec& spec, const std::vector<Row>& rows) {
  std::vector<Game> games;
  for (const Row& row : rows) {
    if (row.result.outcome != "ok" || row.variant >= spec.seatings.size()) continue;
    Game game{&spec.seatings[row.variant], {}, row.seed};
    const std::size_t seats = game.seating->size(), metric = spec.metrics.size() - seats;
    for (std::size_t i = metric; i < metric + seats && i < row.metrics.size() && row.metrics[i]; ++i)
      game.points.push_back(*row.metrics[i]);
    if (game.points.size() == seats) games.push_back(std::move(game));
  }
  return games;
}

/// Ratings by the Bradley-Terry model. Each agent has one additional draw against an average agent, so that agents that
/// won or lost all games have a rating, too. A game with several agents counts as one game for each of them.
std::vector<double> Ratings(std::size_t players, const std::vector<Game>& games) {
  std::vector<double> won(players, 0.5), strength(players, 1), met(players * players);
  for (const Game& game : games) {
    const Seating& seats = *game.seating;
    const double weight = 1 / static_cast<double>(seats.size() - 1);
    for (std::size_t a = 0; a < seats.size(); ++a) {
      for (std::size_t b = 0; b < seats.size(); ++b) {
        if (a == b) continue;
        won[seats[a]] += weight * game.Share(a, b);
        met[seats[a] * players + seats[b]] += weight;
      }
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> next(players);
    for (std::size_t i = 0; i < players; ++i) {
      double expected = 1 / (strength[i] + 1);
      for (std::size_t j = 0; j < players; ++j) expected += met[i * players + j] / (strength[i] + strength[j]);
      next[i] = won[i] / expected;
    }
    strength = std::move(next);
  }
  double mean = 0;
  for (double& one : strength) mean += (one = kScale * std::log10(one)) / static_cast<double>(players);
  for (double& one : strength) one += kMean - mean;
  return strength;
}

/// Adds the result of a game to the standing of the agent at a seat.
void Count(const Game& game, std::size_t seat, Standing& standing) {
  double place = 1;
  bool is_first = true, is_alone = true;
  for (std::size_t other = 0; other < game.points.size(); ++other) {
    if (other == seat) continue;
    const double share = game.Share(seat, other);
    place += 1 - share;
    is_first &= share > 0.25;
    is_alone &= share > 0.75;
  }
  ++standing.games;
  ++(is_alone ? standing.wins : is_first ? standing.draws : standing.losses);
  standing.place += place;
  standing.points += game.points[seat];
}

/// A deterministic random generator.
class Picker {
 public:
  std::size_t Below(std::size_t count) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>((state_ >> 33) % count);
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

std::vector<Standing> Standings(const Spec& spec, const std::vector<Row>& rows) {
  const std::size_t players = spec.players.size();
  const std::vector<Game> games = Games(spec, rows);
  std::vector<Standing> standings(players);
  for (std::size_t i = 0; i < players; ++i) {
    standings[i].player = spec.players[i];
    if (!spec.seatings.empty()) standings[i].seats = spec.seatings.front().size();
  }
  for (const Game& game : games) {
    for (std::size_t seat = 0; seat < game.points.size(); ++seat) Count(game, seat, standings[(*game.seating)[seat]]);
  }
  const std::vector<double> ratings = Ratings(players, games);
  std::vector<std::vector<double>> resampled(players);
  Picker picker;
  // Games of one seed are not independent, so seeds are resampled, each with all its games.
  std::map<std::uint64_t, std::vector<Game>> by_seed;
  for (const Game& game : games) by_seed[game.seed].push_back(game);
  std::vector<const std::vector<Game>*> boards;
  for (const auto& [seed, of_seed] : by_seed) boards.push_back(&of_seed);
  for (int i = 0; i < kResamples && !games.empty(); ++i) {
    std::vector<Game> drawn;
    for (std::size_t board = 0; board < boards.size(); ++board) {
      const std::vector<Game>& one = *boards[picker.Below(boards.size())];
      drawn.insert(drawn.end(), one.begin(), one.end());
    }
    const std::vector<double> found = Ratings(players, drawn);
    for (std::size_t player = 0; player < players; ++player) resampled[player].push_back(found[player]);
  }
  for (std::size_t i = 0; i < players; ++i) {
    Standing& standing = standings[i];
    standing.rating = standing.rating_low = standing.rating_high = ratings[i];
    if (standing.games > 0) {
      standing.points /= static_cast<double>(standing.games);
      standing.place /= static_cast<double>(standing.games);
    }
    if (games.empty()) continue;
    std::vector<double>& found = resampled[i];
    std::ranges::sort(found);
    standing.rating_low = found[found.size() / 40];
    standing.rating_high = found[found.size() - 1 - found.size() / 40];
  }
  std::ranges::stable_sort(standings, [](const Standing& a, const Standing& b) { return a.rating > b.rating; });
  return standings;
}

std::string TournamentTable(const Spec& spec, const std::vector<Row>& rows) {
  const std::vector<Standing> standings = Standings(spec, rows);
  std::size_t width = 5;
  for (const Standing& standing : standings) width = std::max(width, standing.player.size());
  const bool has_places = !standings.empty() && standings.front().seats > 2;
  std::ostringstream out;
  out << "agent" << std::string(width - 5, ' ') << "  rating  (95 %)        games  won  drawn  lost"
      << (has_places ? "  place" : "") << "  points per game\n";
  for (const Standing& standing : standings) {
    std::array<char, 200> line{};
    std::array<char, 16> place{};
    if (has_places) std::snprintf(place.data(), place.size(), "  %5.2f", standing.place);
    std::snprintf(
        line.data(), line.size(), "  %6.0f  %-12s  %5zu  %3zu  %5zu  %4zu%s  %15.4g\n", standing.rating,
        (std::to_string(std::lround(standing.rating_low)) + " to " + std::to_string(std::lround(standing.rating_high)))
            .c_str(),
        standing.games, standing.wins, standing.draws, standing.losses, place.data(), standing.points);
    out << standing.player << std::string(width - standing.player.size(), ' ') << line.data();
  }
  return std::move(out).str();
}

}  // namespace soarbox::sweep
