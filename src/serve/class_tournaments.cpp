// SPDX-License-Identifier: BSD-2-Clause
#include "serve/class_tournaments.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <utility>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::serve {
namespace {

namespace files = std::filesystem;

constexpr std::size_t kMatchesAtOnce = 2, kMostRuleFiles = 64;
constexpr std::uintmax_t kMostRuleBytes = 512u << 10;
constexpr auto kLongestMatch = std::chrono::minutes(5);
constexpr double kForWin = 2, kForDraw = 1;

std::int64_t SecondsNow() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

Result<void> WriteFile(const files::path& file, std::string_view text) {
  std::error_code error;
  files::create_directories(file.parent_path(), error);
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (out) return {};
  return NewProblem("the server cannot write " + file.filename().string(), "try again later");
}

/// Copies the rules of a place that are in the folder of `main` or below it.
Result<void> CopyRules(const Place& place, const std::string& main, const files::path& to) {
  const std::string folder = main.substr(0, main.rfind('/') + 1);
  std::size_t count = 0;
  std::uintmax_t bytes = 0;
  const files::path part = to.parent_path() / (to.filename().string() + ".part");
  std::error_code error;
  files::remove_all(part, error);
  bool has_main = false;
  for (const PlaceFile& file : place.Files()) {
    if (!file.path.starts_with(folder) || !file.path.ends_with(".soar")) continue;
    bytes += file.bytes;
    if (++count > kMostRuleFiles || bytes > kMostRuleBytes)
      return NewProblem("this folder holds more than 64 files of rules, or more than 512 KB",
                        "put what you hand in into a folder of its own");
    const Result<std::string> text = place.Read(file.path);
    if (!text) return text.error();
    if (const Result<void> wrote = WriteFile(part / file.path.substr(folder.size()), *text); !wrote) return wrote;
    has_main |= file.path == main;
  }
  if (!has_main)
    return NewProblem("there is no file of rules '" + main + "' in your place", "apply it first: that saves it");
  files::remove_all(to, error);
  files::rename(part, to, error);
  return error ? Result<void>(NewProblem("the server cannot keep this: " + error.message())) : Result<void>();
}

}  // namespace

std::string AgentNameOf(std::string_view learner) {
  constexpr std::size_t kMost = 20;
  std::string name;
  for (const char c : learner) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_plain)
      name += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    else if (!name.empty() && name.back() != '-')
      name += '-';
    if (name.size() == kMost) break;
  }
  while (name.ends_with('-')) name.pop_back();
  return name.empty() ? "player" : name;
}

Result<std::unique_ptr<Arena>> Arena::Make(boost::asio::io_context& io, Work& work, const Settings& settings,
                                           std::vector<Game> games) {
  std::unique_ptr<Arena> arena(new Arena(io, work, settings, std::move(games)));
  if (const Result<void> read = arena->Read(); !read) return read.error();
  return arena;
}

const Game* Arena::FindGame(std::string_view name) const {
  const auto found = std::ranges::find(games_, name, &Game::name);
  return found == games_.end() ? nullptr : &*found;
}

files::path Arena::EntryFolder(const std::string& game, const std::string& place) const {
  return folder_ / "entries" / game / place;
}

Result<void> Arena::Read() {
  const std::optional<std::string> text = ReadText(folder_ / "arena.json");
  if (!text) return {};
  try {
    const Json json = Json::parse(*text);
    for (const auto& [game, entries] : json.at("entries").items())
      for (const auto& [place, entry] : entries.items())
        entries_[game][place] = {entry.at("learner"), entry.at("file"), entry.at("when")};
    for (const auto& [game, told] : json.at("tournaments").items()) {
      Tournament& tournament = tournaments_[game];
      tournament.seeds = told.at("seeds");
      for (const Json& each : told.at("matches")) {
        Match match;
        match.learners = each.at("learners");
        match.places = each.at("places");
        match.seed = each.at("seed");
        match.id = each.at("id");
        match.trouble = each.at("trouble");
        if (!each.at("scores").is_null()) match.scores = each.at("scores").get<std::array<double, 2>>();
        if (!match.scores && match.trouble.empty()) match.trouble = "the server was stopped before this match";
        tournament.matches.push_back(std::move(match));
      }
      tournament.next = tournament.matches.size();
    }
  } catch (const Json::exception&) {
    return ProblemIn(folder_ / "arena.json", "this file is damaged: it holds what learners have handed in",
                     "restore it, or move the folder away; then everybody has to hand in again");
  }
  return {};
}

void Arena::Save() {
  Json entries = Json::object(), tournaments = Json::object();
  for (const auto& [game, all] : entries_)
    for (const auto& [place, entry] : all)
      entries[game][place] = {{"learner", entry.learner}, {"file", entry.file}, {"when", entry.when_s}};
  for (const auto& [game, tournament] : tournaments_) {
    Json matches = Json::array();
    for (const Match& match : tournament.matches)
      matches.push_back({{"learners", match.learners},
                         {"places", match.places},
                         {"seed", match.seed},
                         {"id", match.id},
                         {"trouble", match.trouble},
                         {"scores", match.scores ? Json(*match.scores) : Json()}});
    tournaments[game] = {{"seeds", tournament.seeds}, {"matches", std::move(matches)}};
  }
  std::string text = JsonText(Json{{"entries", std::move(entries)}, {"tournaments", std::move(tournaments)}}) + "\n";
  work_.Do(
      "arena",
      [folder = folder_, text = std::move(text)] {
        if (!WriteFile(folder / "arena.json.part", text)) return;
        std::error_code error;
        files::rename(folder / "arena.json.part", folder / "arena.json", error);
      },
      [] {});
}

void Arena::HandIn(const std::string& game, const Place& place, const std::string& learner, const std::string& file,
                   std::function<void(const Result<void>&)> done) {
  if (FindGame(game) == nullptr) return done(NewProblem("there is no game '" + game + "' to hand in rules for"));
  if (!file.ends_with(".soar"))
    return done(NewProblem("this is not a file of rules", "hand in a file whose name ends with .soar"));
  const auto result = std::make_shared<Result<void>>(NewProblem("the server could not copy your rules", "try again"));
  // Jobs named "arena" run one after another. So no match is started with partly copied rules.
  work_.Do(
      "arena", [result, place, file, to = EntryFolder(game, place.id())] { *result = CopyRules(place, file, to); },
      [this, alive = std::weak_ptr<int>(alive_), result, game, id = place.id(), learner, file, done = std::move(done)] {
        if (alive.expired()) return;
        if (*result) {
          entries_[game][id] = {learner, file.substr(file.rfind('/') + 1), SecondsNow()};
          Save();
        }
        done(*result);
      });
}

Result<void> Arena::Play(const std::string& game, int seeds) {
  if (FindGame(game) == nullptr) return NewProblem("there is no game '" + game + "'");
  if (seeds < 1 || seeds > kMostSeeds)
    return NewProblem("a tournament has 1 to " + std::to_string(kMostSeeds) + " seeds");
  const std::map<std::string, Entry>& entries = entries_[game];
  if (entries.size() < 2) return NewProblem("two learners have to hand in rules before they can play");
  Tournament& tournament = tournaments_[game];
  if (tournament.is_playing()) return NewProblem("this tournament is being played", "wait until it is over");
  std::vector<files::path> old;
  for (const Match& match : tournament.matches) old.push_back(folder_ / "matches" / match.id);
  work_.Do(
      "arena",
      [old = std::move(old)] {
        std::error_code ignored;
        for (const files::path& folder : old) files::remove_all(folder, ignored);
      },
      [] {});
  tournament = {};
  tournament.seeds = seeds;
  // Sorts the players by name. With each second seed, the two players of a match change places.
  std::vector<std::pair<std::string, std::string>> players;
  for (const auto& [place, entry] : entries) players.emplace_back(entry.learner, place);
  std::ranges::sort(players);
  for (std::size_t one = 0; one < players.size(); ++one)
    for (std::size_t two = one + 1; two < players.size(); ++two)
      for (int seed = 1; seed <= seeds; ++seed) {
        Match match;
        match.learners = {players[one].first, players[two].first};
        match.places = {players[one].second, players[two].second};
        match.seed = static_cast<std::uint64_t>(seed);
        if (seed % 2 == 0) std::swap(match.learners[0], match.learners[1]), std::swap(match.places[0], match.places[1]);
        match.id = NewId();
        tournament.matches.push_back(std::move(match));
      }
  Save();
  Pump(game);
  return {};
}

void Arena::Pump(const std::string& game) {
  Tournament& tournament = tournaments_[game];
  while (tournament.running < kMatchesAtOnce && tournament.next < tournament.matches.size()) {
    ++tournament.running;
    Start(game, tournament.next++);
  }
}

Result<EngineProcess::Spawned> Arena::Spawn(const Game& game, const Match& match,
                                            const std::array<std::string, 2>& mains) const {
  const files::path root = folder_ / "matches" / match.id, folder = root / "home" / "match";
  std::array<Player, 2> players;
  std::error_code error;
  files::create_directories(root / "state", error);
  for (std::size_t i = 0; i < players.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    files::create_directories(folder, error);
    files::copy(EntryFolder(game.name, match.places[i]), folder / number, files::copy_options::recursive, error);
    if (error) return NewProblem("the rules of " + match.learners[i] + " cannot be copied: " + error.message());
    players[i] = {AgentNameOf(match.learners[i]), number + "/" + mains[i]};
  }
  if (players[0].name == players[1].name) players[1].name += "-2";
  const Result<void> wrote = WriteFile(folder / "scenario.toml", game.scenario({players.begin(), players.end()}));
  if (!wrote) return wrote.error();
  return EngineProcess::Spawn(settings_.match(match.seed, game.seconds), Place(match.id, root, settings_.limits.place),
                              settings_.limits);
}

void Arena::Start(const std::string& game, std::size_t index) {
  const Match match = tournaments_[game].matches[index];
  const auto process = std::make_shared<Result<EngineProcess::Spawned>>(NewProblem("the match could not be started"));
  std::array<std::string, 2> mains;
  for (std::size_t i = 0; i < mains.size(); ++i) mains[i] = entries_[game][match.places[i]].file;
  work_.Do(
      "arena", [this, process, rules = *FindGame(game), match, mains] { *process = Spawn(rules, match, mains); },
      [this, alive = std::weak_ptr<int>(alive_), process, game, id = match.id] {
        if (alive.expired()) return;
        if (!*process) {
          FindMatch(game, id)->trouble = process->error().message;
          return Finish(game, id);
        }
        EngineProcess::Hooks hooks;
        hooks.on_frame = [this, game, id](const Frame& frame) {
          if (frame.kind == FrameKind::kReason) FindMatch(game, id)->trouble = frame.bytes;
          if (frame.kind != FrameKind::kText) return;
          const Json told = Json::parse(frame.bytes, nullptr, false);
          if (!told.is_object() || told.value("message", "") != "match") return;
          const Json scores = told.value("scores", Json());
          Match& played = *FindMatch(game, id);
          if (scores.is_array() && scores.size() == 2 && scores[0].is_number() && scores[1].is_number())
            played.scores = {scores[0].get<double>(), scores[1].get<double>()};
        };
        hooks.on_end = [this, game, id](EngineProcess::Ending) {
          Match& played = *FindMatch(game, id);
          if (!played.scores && played.trouble.empty()) played.trouble = "the match gave no scores";
          Finish(game, id);
        };
        Running& running = running_[id];
        running.process = EngineProcess::Adopt(io_, **process, std::move(hooks));
        running.limit = std::make_unique<boost::asio::steady_timer>(io_, kLongestMatch);
        running.limit->async_wait([this, alive, game, id](boost::system::error_code error) {
          if (error || alive.expired()) return;
          FindMatch(game, id)->trouble = "the match took longer than 5 minutes";
          running_[id].process->Kill();
        });
      });
}

void Arena::Finish(const std::string& game, const std::string& match) {
  // A callback of the process or of its timer may be the caller. So both are destroyed after it has returned.
  if (const auto found = running_.find(match); found != running_.end()) {
    const auto ended = std::make_shared<Running>(std::move(found->second));
    running_.erase(found);
    ended->limit->cancel();
    boost::asio::post(io_, [ended] {});
  }
  Tournament& tournament = tournaments_[game];
  --tournament.running;
  constexpr std::size_t kSavedEvery = 20;
  if (!tournament.is_playing() || tournament.next % kSavedEvery == 0) Save();
  Pump(game);
}

Arena::Match* Arena::FindMatch(const std::string& game, const std::string& id) {
  return &*std::ranges::find(tournaments_[game].matches, id, &Match::id);
}

Arena::Json Arena::LadderOf(const Tournament& tournament) const {
  struct Row {
    std::string learner;
    int won = 0, drawn = 0, lost = 0;
    double scored = 0, conceded = 0;
    double points() const { return kForWin * won + kForDraw * drawn; }
  };
  std::map<std::string, Row> rows;  // By place, because two learners may have the same name.
  for (const Match& match : tournament.matches)
    for (std::size_t i = 0; i < 2; ++i) {
      Row& row = rows[match.places[i]];
      row.learner = match.learners[i];
      if (!match.scores) continue;
      const double own = (*match.scores)[i], other = (*match.scores)[1 - i];
      own > other ? ++row.won : own < other ? ++row.lost : ++row.drawn;
      row.scored += own;
      row.conceded += other;
    }
  std::vector<Row> sorted;
  for (auto& [place, row] : rows) sorted.push_back(std::move(row));
  std::ranges::sort(sorted, [](const Row& a, const Row& b) {
    if (a.points() != b.points()) return a.points() > b.points();
    if (a.scored - a.conceded != b.scored - b.conceded) return a.scored - a.conceded > b.scored - b.conceded;
    return a.learner < b.learner;
  });
  Json ladder = Json::array();
  for (const Row& row : sorted)
    ladder.push_back({{"learner", row.learner},
                      {"points", row.points()},
                      {"won", row.won},
                      {"drawn", row.drawn},
                      {"lost", row.lost},
                      {"scored", row.scored},
                      {"conceded", row.conceded}});
  return ladder;
}

Arena::Json Arena::ToJson(const std::string& place) const {
  Json games = Json::array();
  for (const Game& game : games_) {
    Json entries = Json::array(), mine, played;
    if (const auto found = entries_.find(game.name); found != entries_.end())
      for (const auto& [id, entry] : found->second) {
        entries.push_back({{"learner", entry.learner}, {"file", entry.file}, {"when", entry.when_s}});
        if (id == place) mine = entries.back();
      }
    const auto by_name = [](const Json& a, const Json& b) { return a["learner"] < b["learner"]; };
    std::sort(entries.begin(), entries.end(), by_name);
    if (const auto found = tournaments_.find(game.name);
        found != tournaments_.end() && !found->second.matches.empty()) {
      const Tournament& tournament = found->second;
      Json matches = Json::array();
      for (const Match& match : tournament.matches)
        matches.push_back({{"learners", match.learners},
                           {"seed", match.seed},
                           {"scores", match.scores ? Json(*match.scores) : Json()},
                           {"trouble", match.trouble},
                           {"replay", match.scores ? Json(match.id) : Json()}});
      played = {{"is_playing", tournament.is_playing()},
                {"played", tournament.next - tournament.running},
                {"seeds", tournament.seeds},
                {"ladder", LadderOf(tournament)},
                {"matches", std::move(matches)}};
    }
    games.push_back({{"name", game.name},
                     {"title", game.title},
                     {"seconds", game.seconds},
                     {"entries", std::move(entries)},
                     {"mine", std::move(mine)},
                     {"tournament", std::move(played)}});
  }
  return {{"games", std::move(games)}};
}

}  // namespace soarbox::serve
