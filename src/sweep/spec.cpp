// SPDX-License-Identifier: BSD-2-Clause
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "mission/read_mission.h"
#include "sim/table_reader.h"
#include "sweep/design.h"
#include "sweep/plan.h"
#include "sweep/rows.h"

namespace soarbox::sweep {
namespace {

constexpr std::size_t kMostVariants = 1000, kMostTables = 100'000, kMostPlayers = 30, kMostSeats = 8;

class SpecReader : public sim::TableReader {
 public:
  SpecReader(Spec& spec, std::vector<Diagnostic>& problems, bool is_copy)
      : TableReader(spec.file.string(), "docs/sweeps.md", problems), spec_(spec), is_copy_(is_copy) {}

  void Read(const toml::table& root) {
    CheckKeys(root, "a sweep",
              {"scenario", "mission", "seeds", "seconds", "wall", "pass", "record", "check", "variant", "metric",
               "tournament"});
    spec_.scenario = Text(root, "scenario");
    if (const std::string mission = Text(root, "mission"); !mission.empty()) ReadMission(*root.get("mission"), mission);
    if (spec_.scenario.empty()) Problem(root, "this sweep names no scenario", "write scenario = \"thesis\" on top");
    if (spec_.mission.seeds.empty()) Problem(root, "this sweep has no seeds", "write seeds = \"1..100\" on top");
    if (root.contains("record")) spec_.record = Text(root, "record");
    if (spec_.record != "none" && spec_.record != "failed" && spec_.record != "all")
      Problem(*root.get("record"), "'record' is \"none\", \"failed\" or \"all\"");
    for (const toml::table* table : Tables(root, "variant", kMostTables)) ReadVariant(*table);
    if (root.contains("tournament") && !spec_.variants.empty())
      Problem(*root.get("tournament"), "a tournament makes its variants itself", "leave out [[variant]]");
    const toml::table* tournament = root.get_as<toml::table>("tournament");
    if (tournament != nullptr && spec_.variants.empty()) AddSeatings(*tournament);
    if (root.contains("tournament") && tournament == nullptr)
      Problem(*root.get("tournament"), "a tournament is one table", "write [tournament]");
    if (spec_.variants.empty()) spec_.variants.push_back({"default", {}, {}, {}, {}, {}, 0});
    std::set<std::string> names;
    for (const Variant& variant : spec_.variants) {
      if (!names.insert(variant.name).second)
        Problem(root, "there are two variants named '" + variant.name + "'", "give each a name of its own");
      for (const auto& [key, value] : variant.parameters)
        if (std::find(spec_.parameters.begin(), spec_.parameters.end(), key) == spec_.parameters.end())
          spec_.parameters.push_back(key);
    }
    for (const toml::table* table : Tables(root, "metric", kMostTables)) ReadMetric(*table);
    if (!spec_.players.empty()) AddPoints();
  }

 private:
  /// All against all: each group of agents that fills the seats plays once for each rotation of the seats, so that each
  /// agent has each seat once.
  void AddSeatings(const toml::table& table) {
    CheckKeys(table, "a tournament", {"seats", "agents"});
    seats_ = Seats(table);
    const toml::table* agents = table.get_as<toml::table>("agents");
    if (agents == nullptr || agents->size() < 2 || agents->size() > kMostPlayers)
      return Problem(table, "a tournament has 2 to " + std::to_string(kMostPlayers) + " agents",
                     "write agents = { hunter = \"hunter.soar\", other = \"other.soar\" }");
    std::vector<std::string> files;
    for (const auto& [name, file] : *agents) {
      const std::string path = file.value_exact<std::string>().value_or("");
      if (path.empty() || (!is_copy_ && !IsBeside(path)))
        Problem(file, "there is no file '" + path + "' beside this sweep", "an agent takes a file of rules in quotes");
      spec_.players.emplace_back(name.str());
      files.push_back((spec_.file.parent_path() / path).string());
    }
    if (seats_.empty()) return;
    if (files.size() < seats_.size())
      return Problem(table,
                     "there are " + std::to_string(seats_.size()) + " seats and " + std::to_string(files.size()) +
                         " agents: a tournament has at least as many agents as seats",
                     "the same file may play under several names");
    const std::optional<std::vector<Seating>> seatings = AllSeatings(files.size(), seats_.size());
    if (!seatings)
      return Problem(table, "this tournament has more than " + std::to_string(kMostVariants) + " games for each seed",
                     "let fewer agents play, or give fewer seats");
    for (const Seating& seating : *seatings) {
      Variant variant;
      for (std::size_t seat = 0; seat < seating.size(); ++seat) {
        variant.name += (seat == 0 ? "" : " and ") + SafeName(spec_.players[seating[seat]]);
        variant.rules.emplace_back(seats_[seat], files[seating[seat]]);
      }
      variant.line = static_cast<int>(table.source().begin.line);
      spec_.variants.push_back(std::move(variant));
      spec_.seatings.push_back(seating);
    }
  }

  /// All seatings in order; nothing if there are too many.
  static std::optional<std::vector<Seating>> AllSeatings(std::size_t players, std::size_t seats) {
    std::vector<Seating> all;
    std::vector<bool> plays(players);
    std::fill(plays.begin(), plays.begin() + static_cast<std::ptrdiff_t>(seats), true);
    do {
      Seating group;
      for (std::size_t i = 0; i < players; ++i)
        if (plays[i]) group.push_back(i);
      for (std::size_t turned = 0; turned < seats; ++turned) {
        all.push_back(group);
        std::rotate(group.begin(), group.begin() + 1, group.end());
      }
      if (all.size() > kMostVariants) return std::nullopt;
    } while (std::prev_permutation(plays.begin(), plays.end()));
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<std::string> Seats(const toml::table& table) {
    std::vector<std::string> seats;
    const toml::array* names = table.get_as<toml::array>("seats");
    for (std::size_t i = 0; names != nullptr && i < names->size(); ++i)
      seats.push_back(names->get(i)->value_exact<std::string>().value_or(""));
    const std::set<std::string> different(seats.begin(), seats.end());
    if (seats.size() < 2 || seats.size() > kMostSeats || different.size() < seats.size() || different.contains("")) {
      Problem(table, "a tournament has 2 to " + std::to_string(kMostSeats) + " seats: different agents of the scenario",
              "write seats = [\"tank\", \"tank-2\"]");
      seats.clear();
    }
    return seats;
  }

  /// Adds the points of the seats after the file's metrics.
  void AddPoints() {
    for (const std::string& seat : seats_) {
      mission::Condition condition;
      condition.row = mission::FindKey("score");
      Metric metric;
      metric.name = "score of " + seat;
      metric.asked.conditions.push_back(std::move(condition));
      metric.asked.agents = {seat};
      spec_.metrics.push_back(std::move(metric));
    }
  }

  static bool IsOfThisMachine(std::string_view address) {
    const std::size_t colon = address.rfind(':');
    const std::string_view host = address.substr(0, colon);
    if (colon == std::string_view::npos || (host != "127.0.0.1" && host != "localhost")) return false;
    const std::string_view port = address.substr(colon + 1);
    const bool is_number = !port.empty() && port.find_first_not_of("0123456789") == std::string_view::npos;
    return is_number && port.size() <= 5 && std::stoi(std::string(port)) >= 1 && std::stoi(std::string(port)) <= 65535;
  }

  /// Whether a path is a plain file in the sweep's folder or below it, after resolving links.
  bool IsBeside(const std::string& name) const {
    const std::filesystem::path own =
        spec_.file.has_parent_path() ? spec_.file.parent_path() : std::filesystem::path(".");
    return IsPlainFileBelow(own / name, {&own, 1});
  }

  void ReadMission(const toml::node& at, const std::string& name) {
    const std::filesystem::path file = spec_.file.parent_path() / name;
    const std::optional<std::string> text = IsBeside(name) ? ReadText(file) : std::nullopt;
    if (!text) return Problem(at, "there is no mission '" + name + "' beside this sweep");
    mission::Mission read = mission::ParseMission(
        *text, file, text->find("\nscenario") == std::string::npos && !text->starts_with("scenario"), problems());
    if (spec_.scenario.empty()) {
      spec_.scenario =
          read.scenario.empty() ? file.string() : (file.parent_path() / read.scenario).lexically_normal().string();
      if (!std::filesystem::exists(spec_.scenario)) spec_.scenario = read.scenario;
    }
    if (spec_.mission.seeds.empty()) spec_.mission.seeds = read.seeds;
    if (!spec_.mission.seconds) spec_.mission.seconds = read.seconds;
    if (spec_.mission.checks.empty()) spec_.mission.checks = std::move(read.checks);
  }

  static std::string ValueText(const toml::node& node) {
    std::ostringstream out;
    node.visit([&out](const auto& value) { out << value; });
    return out.str();
  }

  void ReadVariant(const toml::table& table) {
    CheckKeys(table, "a variant", {"name", "scenario", "rules", "parameters", "setup", "kernel", "draw"});
    Variant base;
    base.line = static_cast<int>(table.source().begin.line);
    base.name = Text(table, "name");
    if (base.name.empty()) base.name = "variant-" + std::to_string(spec_.variants.size() + 1);
    const auto is_odd = [](unsigned char c) { return c == '/' || std::iscntrl(c) != 0; };
    if (std::ranges::any_of(base.name, is_odd) || base.name.starts_with('.') || base.name.size() > 100)
      Problem(table, "'" + base.name + "' is not a name for a variant",
              "it names a folder: use letters, digits, - and _");
    base.scenario = Text(table, "scenario");
    base.kernel = Text(table, "kernel");
    if (!base.kernel.empty() && !IsOfThisMachine(base.kernel))
      Problem(*table.get("kernel"), "'" + base.kernel + "' is not a kernel of this machine",
              "write \"127.0.0.1:12121\"; sweeps may come from strangers, so they cannot reach other machines");
    if (const toml::node* rules = table.get("rules")) {
      const toml::table* named = rules->as_table();
      if (named == nullptr) Problem(*rules, "'rules' takes { AGENT = \"file.soar\" }");
      for (const auto& [agent, file] : named != nullptr ? *named : toml::table{}) {
        const auto path = file.value_exact<std::string>();
        if (!path) Problem(file, "'" + std::string(agent.str()) + "' takes a file of rules in quotes");
        if (path && !is_copy_ && !IsBeside(*path)) Problem(file, "there is no file '" + *path + "' beside this sweep");
        base.rules.emplace_back(std::string(agent.str()), (spec_.file.parent_path() / path.value_or("")).string());
      }
    }
    if (const toml::node* setup = table.get("setup")) {
      const toml::array* lines = setup->as_array();
      for (std::size_t i = 0; lines != nullptr && i < lines->size(); ++i)
        if (const auto line = lines->get(i)->value_exact<std::string>()) base.setup.push_back(*line);
      if (lines == nullptr || base.setup.size() != lines->size())
        Problem(*setup, "'setup' takes a list of command lines in quotes");
    }
    std::vector<Variant> expanded = {base};
    std::vector<Range> ranges;
    if (const toml::node* node = table.get("parameters")) {
      const toml::table* parameters = node->as_table();
      if (parameters == nullptr) Problem(*node, "'parameters' takes { \"agent.scout.senses.sight\" = 40 }");
      for (const auto& [key, value] : parameters != nullptr ? *parameters : toml::table{}) {
        if (const toml::table* range = value.as_table()) {
          AddRange(std::string(key.str()), *range, ranges);
          continue;
        }
        const toml::array* list = value.as_array();
        std::vector<Variant> next;
        for (const Variant& variant : expanded) {
          for (std::size_t i = 0; i < (list != nullptr ? list->size() : 1); ++i) {
            Variant made = variant;
            const std::string text = ValueText(list != nullptr ? *list->get(i) : value);
            made.parameters.emplace_back(std::string(key.str()), text);
            if (list != nullptr && list->size() > 1) made.name += "-" + SafeName(text);
            next.push_back(std::move(made));
            if (next.size() > kMostVariants)
              return Problem(value, "these are more than " + std::to_string(kMostVariants) + " variants");
          }
        }
        expanded = std::move(next);
      }
    }
    if (table.contains("draw") || !ranges.empty()) expanded = Drawn(table, expanded, ranges);
    spec_.variants.insert(spec_.variants.end(), expanded.begin(), expanded.end());
  }

  /// A parameter that is drawn from a range. The upper limit is included for integers.
  struct Range {
    std::string key;
    double from = 0, to = 0;
    bool is_whole = false, is_log = false;

    std::string TextAt(double share) const {
      if (is_whole) return std::to_string(static_cast<std::int64_t>(from + std::floor(share * (to - from + 1))));
      const double value = is_log ? from * std::pow(to / from, share) : from + share * (to - from);
      char text[32];
      // Six digits are sufficient to distinguish variants, and the table shows the same text as the scenario.
      std::snprintf(text, sizeof text, "%.6g", value);
      std::string number = text;
      // An integer would have another type.
      return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
    }
  };

  void AddRange(std::string key, const toml::table& table, std::vector<Range>& ranges) {
    CheckKeys(table, "a range of a parameter", {"from", "to", "log"});
    const toml::node *from = table.get("from"), *to = table.get("to");
    const bool are_numbers = from != nullptr && to != nullptr && from->is_number() && to->is_number();
    Range range{std::move(key), are_numbers ? from->value<double>().value_or(0) : 0,
                are_numbers ? to->value<double>().value_or(0) : 0,
                are_numbers && from->is_integer() && to->is_integer(), table["log"].value_or(false)};
    if (!are_numbers || !std::isfinite(range.from) || !std::isfinite(range.to) || range.from >= range.to)
      return Problem(table, "a range of a parameter goes from one number to a greater one",
                     "write { from = 2.0, to = 9.0 }; from = 2 and to = 9 draw whole numbers");
    if (range.is_log && (range.is_whole || range.from <= 0))
      return Problem(table, "only positive numbers with a point are drawn evenly over their logarithms",
                     "write { from = 0.01, to = 1.0, log = true }");
    ranges.push_back(std::move(range));
  }

  /// Repeats each variant, with numbers drawn from the ranges.
  std::vector<Variant> Drawn(const toml::table& table, const std::vector<Variant>& variants,
                             const std::vector<Range>& ranges) {
    const toml::table* const draw = table.get_as<toml::table>("draw");
    const std::string design = draw != nullptr ? Text(*draw, "design") : std::string();
    const std::int64_t count = draw != nullptr ? (*draw)["variants"].value_or(std::int64_t{0}) : 0;
    if (draw != nullptr) CheckKeys(*draw, "draw", {"variants", "design", "seed"});
    const auto refuse = [&](std::string what) {
      Problem(table, std::move(what),
              "write draw = { variants = 20, design = \"latin\" } and parameters = { \"agent.scout.speed\" = { from = "
              "2.0, to = 9.0 } }");
      return variants;
    };
    if (ranges.empty()) return refuse("'draw' needs parameters with ranges");
    if (draw == nullptr) return refuse("ranges of parameters need 'draw'");
    if (design != "latin" && design != "random") return refuse("the design of 'draw' is \"latin\" or \"random\"");
    if (count < 1 || static_cast<std::size_t>(count) * variants.size() > kMostVariants)
      return refuse("'draw' takes 1 to " + std::to_string(kMostVariants) + " variants");
    const auto seed = static_cast<std::uint64_t>((*draw)["seed"].value_or(std::int64_t{1}));
    const auto number = static_cast<std::size_t>(count);
    const Points points =
        design == "latin" ? LatinPoints(number, ranges.size(), seed) : RandomPoints(number, ranges.size(), seed);
    std::vector<Variant> drawn;
    for (const Variant& variant : variants) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        Variant made = variant;
        made.name += "-" + std::to_string(i + 1);
        for (std::size_t side = 0; side < ranges.size(); ++side)
          made.parameters.emplace_back(ranges[side].key, ranges[side].TextAt(points[i][side]));
        drawn.push_back(std::move(made));
      }
    }
    return drawn;
  }

  static std::string SafeName(std::string text) {
    for (char& c : text)
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
    return text;
  }

  /// Databases compare names of columns without case.
  static bool IsSameName(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char one, unsigned char other) { return std::tolower(one) == std::tolower(other); });
  }

  void ReadMetric(const toml::table& table) {
    CheckKeys(table, "a metric", {"name", "time_of", "at_end", "max", "mean", "agent", "team"});
    Metric metric;
    metric.name = Text(table, "name");
    if (const std::string check = Text(table, "time_of"); !check.empty()) {
      metric.of = Metric::Of::kTimeOf;
      const auto& checks = spec_.mission.checks;
      const auto at =
          std::find_if(checks.begin(), checks.end(), [&](const mission::Check& each) { return each.name == check; });
      if (at == checks.end()) return Problem(*table.get("time_of"), "there is no check '" + check + "'");
      metric.check = static_cast<std::size_t>(at - checks.begin());
      if (metric.name.empty()) metric.name = "time of " + check;
    } else {
      std::string key;
      for (const auto& [word, of] :
           {std::pair{"at_end", Metric::Of::kAtEnd}, {"max", Metric::Of::kMax}, {"mean", Metric::Of::kMean}}) {
        if (!table.contains(word)) continue;
        if (!key.empty()) return Problem(table, "a metric is one of time_of, at_end, max and mean");
        metric.of = of;
        key = Text(table, word);
      }
      const mission::KeyRow* row = mission::FindKey(key);
      if (row == nullptr || row->names != mission::Names::kNothing)
        return Problem(table, "a metric is the time_of a check, or at_end, max or mean of a number such as \"health\"");
      mission::Condition condition;
      condition.row = row;
      metric.asked.conditions.push_back(std::move(condition));
      if (const std::string agent = Text(table, "agent"); !agent.empty()) metric.asked.agents = {agent};
      metric.asked.team = Text(table, "team");
      if (metric.asked.agents.empty() && metric.asked.team.empty()) metric.asked.agents = {"*"};
      const char* const how = metric.of == Metric::Of::kMax    ? "most"
                              : metric.of == Metric::Of::kMean ? "mean"
                                                               : "final";
      if (metric.name.empty()) metric.name = std::string(how) + " " + key;
    }
    if (IsOwnColumn(metric.name))
      return Problem(table, "each table has a column '" + metric.name + "' already", "give this metric another name");
    const auto is_it = [&](const Metric& other) { return IsSameName(other.name, metric.name); };
    if (std::ranges::any_of(spec_.metrics, is_it))
      return Problem(table, "there are two metrics named '" + metric.name + "'", "give each a name of its own");
    if (std::ranges::any_of(spec_.parameters, [&](const std::string& one) { return IsSameName(one, metric.name); }))
      return Problem(table, "there is a parameter '" + metric.name + "' already", "give this metric another name");
    spec_.metrics.push_back(std::move(metric));
  }

  Spec& spec_;
  std::vector<std::string> seats_;  ///< For a tournament.
  bool is_copy_;
};

/// Sets Spec::whole and Spec::judgement. If the spec refers to a mission, they contain the mission's seeds, seconds and
/// checks.
void KeepWhole(toml::table root, Spec& spec) {
  if (const auto named = root["mission"].value<std::string>()) {
    const std::string text = ReadText(spec.file.parent_path() / *named).value_or("");
    const toml::table mission = toml::parse(text);
    const toml::node* frame = mission.get("mission");
    const toml::table& says = frame != nullptr && frame->is_table() ? *frame->as_table() : mission;
    for (const char* key : {"seeds", "seconds"}) {
      if (const toml::node* value = says.get(key); value != nullptr && !root.contains(key))
        value->visit([&](const auto& concrete) { root.insert_or_assign(key, concrete); });
    }
    if (const toml::node* checks = mission.get("check"); checks != nullptr && !root.contains("check"))
      checks->visit([&](const auto& concrete) { root.insert_or_assign("check", concrete); });
    root.erase("mission");
    root.insert_or_assign("scenario", spec.scenario);
  }
  std::ostringstream whole;
  whole << root << '\n';
  spec.whole = whole.str();
  toml::table judged;
  for (const char* key : {"check", "metric"}) {
    if (const toml::node* value = root.get(key))
      value->visit([&](const auto& concrete) { judged.insert_or_assign(key, concrete); });
  }
  if (const toml::array* seats = root["tournament"]["seats"].as_array()) judged.insert_or_assign("seats", *seats);
  std::ostringstream judgement;
  judgement << judged;
  spec.judgement = judgement.str();
}

}  // namespace

Spec ReadSpec(const std::filesystem::path& file, std::vector<Diagnostic>& problems, bool is_copy) {
  Spec spec;
  spec.file = file;
  const std::optional<std::string> text = ReadText(file);
  if (!text) {
    std::error_code error;
    const bool is_there = std::filesystem::exists(file, error);
    problems.push_back(ProblemIn(file, is_there ? "this sweep cannot be read" : "there is no such file",
                                 "a sweep is a .toml file that names a scenario and seeds: docs/sweeps.md shows one"));
    return spec;
  }
  // Checks and seeds are parsed like those of missions.
  spec.mission = mission::ParseChecksBeside(*text, file, problems);
  if (!problems.empty()) return spec;
  const toml::table root = toml::parse(*text, file.string());
  SpecReader(spec, problems, is_copy).Read(root);
  if (problems.empty()) KeepWhole(root, spec);
  return spec;
}

}  // namespace soarbox::sweep
