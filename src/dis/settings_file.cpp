// SPDX-License-Identifier: BSD-2-Clause
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "dis/settings.h"

namespace soarbox::dis {
namespace {

constexpr std::size_t kMostRows = 1000;

/// Reads `[dis]`; what is wrong first stays.
class TableReader {
 public:
  TableReader(std::string file, Settings& settings) : file_(std::move(file)), settings_(settings) {}

  const std::optional<Diagnostic>& problem() const { return problem_; }

  void Read(const toml::table& table) {
    CheckKeys(
        table, "[dis]",
        {"address", "interface", "port", "site", "application", "exercise", "version", "anchor", "heartbeat", "timeout",
         "threshold", "most_entities", "takes_orders", "listens_only", "forces", "entity", "munition"});
    Text(table, "address", settings_.address);
    Text(table, "interface", settings_.interface);
    Whole(table, "port", 1, 65535, settings_.port);
    Whole(table, "site", 1, 65534, settings_.site);
    Whole(table, "application", 1, 65534, settings_.application);
    Whole(table, "exercise", 1, 255, settings_.exercise);
    Whole(table, "version", 6, 7, settings_.version);
    Whole(table, "most_entities", 0, 10'000, settings_.most_entities);
    Number(table, "heartbeat", 0.1, 3600, settings_.heartbeat_s);
    settings_.timeout_s = 2.4 * settings_.heartbeat_s;
    Number(table, "timeout", 0.1, 36000, settings_.timeout_s);
    Number(table, "threshold", 0.01, 100, settings_.threshold_m);
    Flag(table, "takes_orders", settings_.takes_orders);
    Flag(table, "listens_only", settings_.listens_only);
    Anchor(table);
    Forces(table);
    Rows(table);
  }

 private:
  void Fail(const toml::node& at, std::string message, std::string hint = {}) {
    if (problem_) return;
    problem_.emplace();
    problem_->file = file_;
    problem_->line = static_cast<int>(at.source().begin.line);
    problem_->column = static_cast<int>(at.source().begin.column);
    problem_->message = std::move(message);
    problem_->hint = std::move(hint);
  }

  void CheckKeys(const toml::table& table, const std::string& what, std::initializer_list<std::string_view> known) {
    for (const auto& [key, value] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      const std::string_view near = Suggest(key.str(), known);
      Fail(value, what + " has no '" + std::string(key.str()) + "'",
           near.empty() ? "docs/dis.md lists what it has" : "did you mean '" + std::string(near) + "'?");
    }
  }

  void Text(const toml::table& table, const char* key, std::string& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto text = node->value_exact<std::string>();
    if (!text || text->empty() || text->size() > 200)
      return Fail(*node, "'" + std::string(key) + "' takes a text in quotes");
    value = *text;
  }

  template <class Integer>
  void Whole(const toml::table& table, const char* key, std::int64_t least, std::int64_t most, Integer& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto number = node->value_exact<std::int64_t>();
    if (!number || *number < least || *number > most)
      return Fail(*node, "'" + std::string(key) + "' takes a whole number from " + std::to_string(least) + " to " +
                             std::to_string(most));
    value = static_cast<Integer>(*number);
  }

  template <class Real>
  void Number(const toml::table& table, const char* key, double least, double most, Real& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto number = node->is_number() ? node->value<double>() : std::nullopt;
    if (!number || !(*number >= least && *number <= most))
      return Fail(*node, "'" + std::string(key) + "' takes a number of that size: more than 0, and not too large");
    value = static_cast<Real>(*number);
  }

  void Flag(const toml::table& table, const char* key, bool& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto flag = node->value_exact<bool>();
    if (!flag) return Fail(*node, "'" + std::string(key) + "' takes true or false");
    value = *flag;
  }

  void Anchor(const toml::table& table) {
    const toml::node* node = table.get("anchor");
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    double parts[3] = {};
    bool good = list != nullptr && list->size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
      const auto number = list->get(i)->is_number() ? list->get(i)->value<double>() : std::nullopt;
      constexpr double kMost[3] = {90, 180, 100'000};
      good = number && std::abs(*number) <= kMost[i];
      parts[i] = number.value_or(0);
    }
    if (!good) return Fail(*node, "'anchor' takes [latitude, longitude, height], in degrees and metres");
    settings_.anchor = {parts[0], parts[1], parts[2]};
  }

  void Forces(const toml::table& table) {
    const toml::node* node = table.get("forces");
    if (node == nullptr) return;
    if (node->as_table() == nullptr) return Fail(*node, "write [dis.forces] above lines such as: blue = \"friendly\"");
    for (const auto& [team, value] : *node->as_table()) {
      constexpr std::string_view kNames[] = {"other", "friendly", "opposing", "neutral"};
      const auto name = value.value_exact<std::string>();
      const auto number = value.value_exact<std::int64_t>();
      const auto at = std::find(std::begin(kNames), std::end(kNames), name.value_or(""));
      if (at == std::end(kNames) && (!number || *number < 0 || *number > 255)) {
        Fail(value, "a force is \"friendly\", \"opposing\", \"neutral\", \"other\" or a number up to 255");
        continue;
      }
      settings_.forces[std::string(team.str())] =
          static_cast<std::uint8_t>(number ? *number : std::distance(std::begin(kNames), at));
    }
  }

  /// The tables of [[dis.KEY]].
  std::vector<const toml::table*> Tables(const toml::table& table, const char* key) {
    std::vector<const toml::table*> tables;
    const toml::node* node = table.get(key);
    if (node == nullptr) return tables;
    const toml::array* list = node->as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size() && i < kMostRows; ++i)
      if (const toml::table* one = list->get(i)->as_table()) tables.push_back(one);
    if (list == nullptr || tables.size() != list->size())
      Fail(*node, "write [[dis." + std::string(key) + "]] above each one");
    return tables;
  }

  TypePattern Type(const toml::table& row) {
    std::string text;
    Text(row, "type", text);
    const std::optional<TypePattern> pattern = ParseTypePattern(text);
    if (!pattern)
      Fail(row.contains("type") ? *row.get("type") : static_cast<const toml::node&>(row),
           "'type' takes up to seven numbers: \"3.1.225.1\" or \"3.1.*.1\"",
           "kind, domain, country, category, subcategory, specific, extra");
    return pattern.value_or(TypePattern{});
  }

  /// A scenario's own rows come before those that are there.
  void Rows(const toml::table& table) {
    std::vector<EntityRow> entities;
    for (const toml::table* row : Tables(table, "entity")) {
      CheckKeys(*row, "[[dis.entity]]", {"type", "body"});
      EntityRow& made = entities.emplace_back(EntityRow{Type(*row), {}});
      Text(*row, "body", made.body);
      if (made.body.empty()) Fail(*row, "this [[dis.entity]] has no 'body'", "a kind of body, such as \"soldier\"");
    }
    settings_.entities.insert(settings_.entities.begin(), entities.begin(), entities.end());
    std::vector<MunitionRow> munitions;
    for (const toml::table* row : Tables(table, "munition")) {
      CheckKeys(*row, "[[dis.munition]]", {"type", "damage", "radius"});
      MunitionRow& made = munitions.emplace_back(MunitionRow{Type(*row)});
      Number(*row, "damage", 0, 1e6, made.damage);
      Number(*row, "radius", 0, 1000, made.radius_m);
    }
    settings_.munitions.insert(settings_.munitions.begin(), munitions.begin(), munitions.end());
  }

  std::string file_;
  Settings& settings_;
  std::optional<Diagnostic> problem_;
};

Result<std::optional<Settings>> ReadFile(const std::filesystem::path& file, Settings settings) {
  const std::optional<std::string> text = ReadText(file);
  if (!text) {
    return ProblemIn(file.string(), "this file cannot be read");
  }
  toml::table root;
  try {
    root = toml::parse(*text, file.string());
  } catch (const toml::parse_error& error) {
    Diagnostic problem;
    problem.file = file.string();
    problem.line = static_cast<int>(error.source().begin.line);
    problem.message = std::string(error.description());
    return problem;
  }
  const toml::node* node = root.get("dis");
  if (node == nullptr) return std::optional<Settings>();
  TableReader reader(file.string(), settings);
  if (const toml::table* table = node->as_table()) {
    reader.Read(*table);
    if (!reader.problem()) return std::optional<Settings>(std::move(settings));
    return *reader.problem();
  }
  Diagnostic problem;
  problem.file = file.string();
  problem.line = static_cast<int>(node->source().begin.line);
  problem.message = "write [dis] above the options of the exercise";
  return problem;
}

}  // namespace

Result<std::optional<Settings>> ReadSettings(const std::filesystem::path& scenario, Settings over) {
  if (scenario.empty()) return std::optional<Settings>();
  return ReadFile(scenario, std::move(over));
}

Result<Settings> ReadTable(const std::filesystem::path& table) {
  Result<std::optional<Settings>> read = ReadFile(table, {});
  if (!read) return read.error();
  return std::move(*read).value_or(Settings{});
}

}  // namespace soarbox::dis
