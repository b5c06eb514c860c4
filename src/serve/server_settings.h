// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "serve/place.h"

namespace soarbox::serve {

/// Limits of a server. Users who exceed one get a message that says so.
struct Limits {
  std::size_t sessions = 128;      ///< Maximum number of runs at a time.
  std::size_t connections = 2000;  ///< Maximum number of open connections.
  std::size_t connections_per_address = 400;
  std::size_t places_per_hour = 300;  ///< New places from one address.
  std::size_t message_bytes = 1u << 20;
  std::size_t upload_bytes = 4u << 20;
  double requests_per_s = 60;        ///< Average for one page.
  int wrong_tokens_per_minute = 10;  ///< For one address.
  int idle_min = 30;                 ///< A run that no page shows ends after this time.
  int run_hours = 12;                ///< Maximum duration of a run.
  int hang_s = 60;                   ///< A run that sends nothing for this time is ended.
  std::size_t sessions_per_address = 96;
  std::size_t bytes_in_flight = 128u << 20;             ///< Total of uploads and answers.
  std::size_t bytes_in_flight_per_address = 48u << 20;  ///< The same for one address.
  int kept_days = 30;                                   ///< A place that is not visited for this time is removed.
  int engine_data_mb = 1024;                            ///< Memory limit of the process of a run.
  PlaceLimits place;
};

struct Lesson {
  std::string name, title;
  std::string course = {};  ///< Empty: the first course.
};
/// A user's progress in a lesson.
struct Progress {
  bool is_passed = false;
  int attempts = 0, hints = 0;
  std::string last_hint = {};  ///< Empty if none was requested.
};

/// A player of a match: the name of an agent, and its file of rules relative to the scenario.
struct Player {
  std::string name, rules;
};
/// A game for two players, in which learners of a class can compare their rules.
struct Game {
  std::string name, title;
  int seconds = 60;  ///< Maximum simulated duration of a match.
  /// The text of scenario.toml for a match.
  std::function<std::string(const std::vector<Player>&)> scenario;
};

/// Provides lessons and worlds to the server. The program implements it.
class Catalog {
 public:
  virtual ~Catalog() = default;
  virtual std::vector<Lesson> Lessons() const = 0;
  struct Scenario {
    std::string name, about;
  };
  virtual std::vector<Scenario> Scenarios() const = 0;
  virtual std::vector<Game> Games() const = 0;
  /// Information about a recording; `world` is empty if it cannot be read.
  struct Recording {
    std::string world;
    double seconds = 0;
  };
  virtual Recording Describe(const std::filesystem::path& recording) const = 0;
  /// Reads the progress from a place's `state` folder.
  virtual Progress ProgressOf(const std::filesystem::path& state, const std::string& lesson) const = 0;
};

struct Settings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;           ///< 0: any free port.
  std::vector<std::string> hosts;      ///< Host names of the server that browsers may use, besides IP addresses and
                                       ///< localhost.
  std::vector<std::string> proxies;    ///< Addresses of proxies whose X-Forwarded-For is trusted.
  std::string token;                   ///< Empty: no token is required.
  std::filesystem::path state;         ///< Folder of the places.
  std::filesystem::path page;          ///< The folder of the built page.
  std::filesystem::path class_list;    ///< Names of learners, one a line; empty: no class.
  std::filesystem::path lti;           ///< Learning platforms that may open lessons (docs/lti.md); empty: none.
  std::vector<std::string> embedders;  ///< Sites that may show worlds in their pages: "https://school.example".
  std::string opens;                   ///< What a new place opens at once: "scenario:scout"; empty: nothing.
  /// Returns the command line of the engine for `what`: "lesson:NAME", "scenario:NAME", "recording:FILE" or "match:ID".
  /// Empty if there is no such lesson, scenario, recording or match.
  std::function<std::vector<std::string>(const std::string& what, const Place& place)> engine;
  /// Returns the command line for a match. The program plays the scenario `home/match` in its working directory for
  /// `seconds` of simulated time, records it as `state/match.soarrec`, and sends {"message":"match","scores":[...]}, in
  /// the order of its agents.
  std::function<std::vector<std::string>(std::uint64_t seed, int seconds)> match;
  bool ends_when_alone = false;  ///< End some seconds after the last page has disconnected.
  Limits limits;
};

}  // namespace soarbox::serve
