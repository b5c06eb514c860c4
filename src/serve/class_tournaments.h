// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "serve/engine_process.h"
#include "serve/server_settings.h"
#include "serve/work.h"

namespace soarbox::serve {

/// Tournaments of a class: learners submit rules for a game, and the server plays all pairs against each other. Each
/// match is a separate process and produces a recording. The data are stored in the folder `arena` of the state folder.
/// Used only on the thread of `io`.
class Arena {
 public:
  using Json = nlohmann::ordered_json;
  static constexpr int kMostSeeds = 10;

  /// Fails if the file of an earlier run is damaged.
  static Result<std::unique_ptr<Arena>> Make(boost::asio::io_context& io, Work& work, const Settings& settings,
                                             std::vector<Game> games);

  /// Submits rules for a learner: copies the file and all rules in its folder and below. They replace the learner's
  /// earlier submission. `done` gets the result.
  void HandIn(const std::string& game, const Place& place, const std::string& learner, const std::string& file,
              std::function<void(const Result<void>&)> done);
  /// Plays all pairs of submissions, with the seeds 1 to `seeds`. Removes the earlier matches. Fails if that is not
  /// possible now.
  Result<void> Play(const std::string& game, int seeds);
  /// All games with submissions, ladder and matches. Marks the submission of `place`; empty: marks none.
  Json ToJson(const std::string& place) const;

 private:
  struct Entry {
    std::string learner;
    std::string file;  ///< Relative to the submission's folder.
    std::int64_t when_s = 0;
  };
  struct Match {
    std::array<std::string, 2> learners, places;
    std::uint64_t seed = 1;
    std::string id;
    std::optional<std::array<double, 2>> scores;
    std::string trouble;  ///< After the match: why there are no scores.
  };
  struct Tournament {
    int seeds = 1;
    std::vector<Match> matches;
    std::size_t next = 0, running = 0;
    bool is_playing() const { return next < matches.size() || running > 0; }
  };

  Arena(boost::asio::io_context& io, Work& work, const Settings& settings, std::vector<Game> games)
      : io_(io), work_(work), settings_(settings), games_(std::move(games)), folder_(settings.state / "arena") {}
  const Game* FindGame(std::string_view name) const;
  std::filesystem::path EntryFolder(const std::string& game, const std::string& place) const;
  Result<void> Read();
  void Save();
  /// Starts matches until the limit of parallel matches is reached.
  void Pump(const std::string& game);
  void Start(const std::string& game, std::size_t index);
  /// Writes the scenario of a match and the rules of both players to its folder, and starts its process. Can be called
  /// on any thread.
  Result<EngineProcess::Spawned> Spawn(const Game& game, const Match& match,
                                       const std::array<std::string, 2>& files) const;
  void Finish(const std::string& game, const std::string& match);
  Match* FindMatch(const std::string& game, const std::string& id);
  Json LadderOf(const Tournament& tournament) const;

  boost::asio::io_context& io_;
  Work& work_;
  const Settings& settings_;
  std::vector<Game> games_;
  std::filesystem::path folder_;
  std::map<std::string, std::map<std::string, Entry>> entries_;  ///< By game, then by place.
  std::map<std::string, Tournament> tournaments_;                ///< By game: the last tournament.
  /// A match in progress.
  struct Running {
    std::shared_ptr<EngineProcess> process;
    std::unique_ptr<boost::asio::steady_timer> limit;
  };
  std::map<std::string, Running> running_;                 ///< By match.
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  ///< Callbacks hold a weak pointer to it, to detect that the
                                                           ///< arena was destroyed.
};

/// A name for an agent that identifies its learner: letters, digits and hyphens.
std::string AgentNameOf(std::string_view learner);

}  // namespace soarbox::serve
