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
#include "serve/settings.h"
#include "serve/work.h"

namespace soarbox::serve {

/// Where learners of a class hand in rules for a game, and the server plays all pairs against each other. Each match is
/// a process of its own and leaves a recording. Kept in `arena` in the state folder. It belongs to the thread of `io`.
class Arena {
 public:
  using Json = nlohmann::ordered_json;
  static constexpr int kMostSeeds = 10;

  /// The error says that the file of an earlier run is damaged.
  static Result<std::unique_ptr<Arena>> Make(boost::asio::io_context& io, Work& work, const Settings& settings,
                                             std::vector<Game> games);

  /// Copies the file and all rules beside and below its folder; they take the place of what this learner has handed in
  /// before. `done` gets what was wrong.
  void HandIn(const std::string& game, const Place& place, const std::string& learner, const std::string& file,
              std::function<void(const Result<void>&)> done);
  /// Plays all pairs of those who have handed in, with the seeds from 1 to `seeds`. The matches before are removed. The
  /// error says why it cannot.
  Result<void> Play(const std::string& game, int seeds);
  /// All games with entries, ladder and matches; `place` says whose own entry is marked, empty: nobody's.
  Json ToJson(const std::string& place) const;
  /// The recording of a match; empty: there is none of this id.
  std::filesystem::path RecordingOf(std::string_view match) const;

 private:
  struct Entry {
    std::string learner;
    std::string file;  ///< Below the entry's folder.
    std::int64_t when_s = 0;
  };
  struct Match {
    std::array<std::string, 2> learners, places;
    std::uint64_t seed = 1;
    std::string id;
    std::optional<std::array<double, 2>> scores;
    std::string trouble;  ///< Why there are no scores, once it is over.
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
  /// Starts matches, as many at a time as it may.
  void Pump(const std::string& game);
  void Start(const std::string& game, std::size_t index);
  /// Writes the scenario of a match and both players' rules into its folder, and starts its process; on any thread.
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
  std::map<std::string, Tournament> tournaments_;                ///< By game: the last one.
  /// A match that is played.
  struct Running {
    std::shared_ptr<EngineProcess> process;
    std::unique_ptr<boost::asio::steady_timer> limit;
  };
  std::map<std::string, Running> running_;                 ///< By match.
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  ///< For what comes back when it may be gone.
};

/// A name for an agent that shows whose it is: letters, digits and hyphens.
std::string AgentNameOf(std::string_view learner);

}  // namespace soarbox::serve
