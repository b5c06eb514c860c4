// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/tournament.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace soarbox::sweep {
namespace {

constexpr int kResamples = 300;
constexpr int kRounds = 200;
constexpr double kMean = 1500, kScale = 400;

/// One game: who sat where, and what share of the win each has: 1, a half, or 0.
struct Game {
  std::size_t first = 0, second = 0;
  double first_points = 0, second_points = 0;

  double share() const { return first_points > second_points ? 1 : first_points < second_points ? 0 : 0.5; }
};

std::vector<Game> Games(const Spec& spec, const std::vector<Row>& rows) {
  std::vector<Game> games;
  for (const Row& row : rows) {
    if (row.result.outcome != "ok" || row.variant >= spec.pairings.size()) continue;
    const std::size_t metric = spec.metrics.size() - 2;
    if (row.metrics.size() < metric + 2 || !row.metrics[metric] || !row.metrics[metric + 1]) continue;
    const Pairing& pairing = spec.pairings[row.variant];
    games.push_back({pairing.first, pairing.second, *row.metrics[metric], *row.metrics[metric + 1]});
  }
  return games;
}

/// Ratings after Bradley and Terry. Each agent has drawn one game against an average one besides, so that whoever won
/// or lost all has a rating, too.
std::vector<double> Ratings(std::size_t players, const std::vector<Game>& games) {
  std::vector<double> won(players, 0.5), strength(players, 1);
  for (const Game& game : games) {
    won[game.first] += game.share();
    won[game.second] += 1 - game.share();
  }
  std::vector<double> met(players * players);
  for (const Game& game : games) {
    met[game.first * players + game.second] += 1;
    met[game.second * players + game.first] += 1;
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

/// The same numbers in each run of the program.
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
  for (std::size_t i = 0; i < players; ++i) standings[i].player = spec.players[i];
  for (const Game& game : games) {
    const auto add = [&](std::size_t who, double share, double points) {
      Standing& standing = standings[who];
      ++standing.games;
      ++(share > 0.75 ? standing.wins : share < 0.25 ? standing.losses : standing.draws);
      standing.points += points;
    };
    add(game.first, game.share(), game.first_points);
    add(game.second, 1 - game.share(), game.second_points);
  }
  const std::vector<double> ratings = Ratings(players, games);
  std::vector<std::vector<double>> resampled(players);
  Picker picker;
  for (int i = 0; i < kResamples && !games.empty(); ++i) {
    std::vector<Game> drawn(games.size());
    for (Game& game : drawn) game = games[picker.Below(games.size())];
    const std::vector<double> found = Ratings(players, drawn);
    for (std::size_t player = 0; player < players; ++player) resampled[player].push_back(found[player]);
  }
  for (std::size_t i = 0; i < players; ++i) {
    Standing& standing = standings[i];
    standing.rating = standing.rating_low = standing.rating_high = ratings[i];
    if (standing.games > 0) standing.points /= static_cast<double>(standing.games);
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
  std::ostringstream out;
  out << "agent" << std::string(width - 5, ' ') << "  rating  (95 %)        games  won  drawn  lost  points per game\n";
  for (const Standing& standing : standings) {
    std::array<char, 160> line{};
    std::snprintf(
        line.data(), line.size(), "  %6.0f  %-12s  %5zu  %3zu  %5zu  %4zu  %15.4g\n", standing.rating,
        (std::to_string(std::lround(standing.rating_low)) + " to " + std::to_string(std::lround(standing.rating_high)))
            .c_str(),
        standing.games, standing.wins, standing.draws, standing.losses, standing.points);
    out << standing.player << std::string(width - standing.player.size(), ' ') << line.data();
  }
  return std::move(out).str();
}

}  // namespace soarbox::sweep
