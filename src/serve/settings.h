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

/// What a server lets people do. Whoever exceeds a limit is told so in a sentence.
struct Limits {
  std::size_t sessions = 128;      ///< Runs at a time.
  std::size_t connections = 2000;  ///< Open at a time.
  std::size_t connections_per_address = 400;
  std::size_t places_per_hour = 300;  ///< New ones from one address.
  std::size_t message_bytes = 1u << 20;
  std::size_t upload_bytes = 4u << 20;
  double requests_per_s = 60;        ///< Of one page, on average.
  int wrong_tokens_per_minute = 10;  ///< Of one address.
  int idle_min = 30;                 ///< A run that nobody looks at ends after so long.
  int run_hours = 12;                ///< No run is longer.
  int hang_s = 60;                   ///< A run that is silent for so long is ended.
  std::size_t sessions_per_address = 96;
  std::size_t bytes_in_flight = 128u << 20;             ///< Of uploads and answers, in all.
  std::size_t bytes_in_flight_per_address = 48u << 20;  ///< Likewise, of one address.
  int kept_days = 30;                                   ///< A place that nobody visits is removed after so long.
  int engine_data_mb = 1024;                            ///< That its process may have in all.
  PlaceLimits place;
};

struct Lesson {
  std::string name, title;
  std::string course = {};  ///< Empty: of the first one.
};
/// How far somebody is with a lesson.
struct Progress {
  bool is_passed = false;
  int attempts = 0, hints = 0;
  std::string last_hint = {};  ///< Its text; empty: none was asked for.
};

/// Who plays a match: the name of an agent, and its file of rules relative to the scenario.
struct Player {
  std::string name, rules;
};
/// A game for two in which learners of a class can measure their rules.
struct Game {
  std::string name, title;
  int seconds = 60;  ///< Simulated, at most, of a match.
  /// The text of scenario.toml for a match.
  std::function<std::string(const std::vector<Player>&)> scenario;
};

/// What the program around the server knows of lessons and worlds.
class Catalog {
 public:
  virtual ~Catalog() = default;
  virtual std::vector<Lesson> Lessons() const = 0;
  struct Scenario {
    std::string name, about;
  };
  virtual std::vector<Scenario> Scenarios() const = 0;
  virtual std::vector<Game> Games() const = 0;
  /// What a recording says of itself; an empty world: it cannot be read.
  struct Recording {
    std::string world;
    double seconds = 0;
  };
  virtual Recording Describe(const std::filesystem::path& recording) const = 0;
  /// As noted below this folder, a place's `state`.
  virtual Progress ProgressOf(const std::filesystem::path& state, const std::string& lesson) const = 0;
};

struct Settings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;           ///< 0: any free one.
  std::vector<std::string> hosts;      ///< Names by which browsers may call the server, besides numbers and localhost.
  std::vector<std::string> proxies;    ///< Addresses whose X-Forwarded-For is believed.
  std::string token;                   ///< Empty: none is needed.
  std::filesystem::path state;         ///< Where places are kept.
  std::filesystem::path page;          ///< The folder of the built page.
  std::filesystem::path class_list;    ///< Names of learners, one a line; empty: no class.
  std::filesystem::path lti;           ///< Learning platforms that may open lessons (docs/lti.md); empty: none.
  std::vector<std::string> embedders;  ///< Sites that may show worlds in their pages: "https://school.example".
  std::string opens;                   ///< What a new place opens at once: "scenario:scout"; empty: nothing.
  /// The program of an engine with its arguments, for what a page wants to see: "lesson:...", "scenario:...", or
  /// "recording:..." with the name of the file, or "match:..." with the id of a match. Empty: there is no such thing.
  std::function<std::vector<std::string>(const std::string& what, const Place& place)> engine;
  /// The program that plays the scenario `home/match` of the folder in which it begins, for so many simulated seconds,
  /// records it as `state/match.soarrec` and sends {"message":"match","scores":[...]}, in the order of its agents.
  std::function<std::vector<std::string>(std::uint64_t seed, int seconds)> match;
  bool ends_when_alone = false;  ///< Once its last page has been gone for some seconds.
  Limits limits;
};

}  // namespace soarbox::serve
