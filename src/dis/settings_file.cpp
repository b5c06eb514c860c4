// SPDX-License-Identifier: BSD-2-Clause
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "dis/dis_settings.h"
#include "sim/table_reader.h"

namespace soarbox::dis {
namespace {

constexpr std::size_t kMostRows = 1000;

/// Reads `[dis]`.
class SettingsReader : public sim::TableReader {
 public:
  SettingsReader(std::string file, Settings& settings, std::vector<Diagnostic>& problems)
      : TableReader(std::move(file), "docs/dis.md", problems), settings_(settings) {}

  void Read(const toml::table& table) {
    CheckKeys(
        table, "[dis]",
        {"address", "interface", "port", "site", "application", "exercise", "version", "anchor", "heartbeat", "timeout",
         "threshold", "most_entities", "takes_orders", "listens_only", "forces", "entity", "munition"});
    ReadText(table, "address", settings_.address);
    ReadText(table, "interface", settings_.interface);
    Whole(table, "port", 1, 65535, settings_.port);
    Whole(table, "site", 1, 65534, settings_.site);
    Whole(table, "application", 1, 65534, settings_.application);
    Whole(table, "exercise", 1, 255, settings_.exercise);
    Whole(table, "version", 6, 7, settings_.version);
    Whole(table, "most_entities", 0, 10'000, settings_.most_entities);
    Measure(table, "heartbeat", 0.1, 3600, settings_.heartbeat_s);
    settings_.timeout_s = 2.4 * settings_.heartbeat_s;
    Measure(table, "timeout", 0.1, 36000, settings_.timeout_s);
    Measure(table, "threshold", 0.01, 100, settings_.threshold_m);
    settings_.takes_orders = Truth(table, "takes_orders", settings_.takes_orders);
    settings_.listens_only = Truth(table, "listens_only", settings_.listens_only);
    Anchor(table);
    Forces(table);
    Rows(table);
  }

 private:
  void ReadText(const toml::table& table, const char* key, std::string& value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    const auto text = node->value_exact<std::string>();
    if (!text || text->empty() || text->size() > 200)
      return Problem(*node, "'" + std::string(key) + "' takes a text in quotes");
    value = *text;
  }

  template <class Integer>
  void Whole(const toml::table& table, const char* key, int least, int most, Integer& value) {
    if (const std::optional<int> number = WholeNumber(table, key, least, most)) value = static_cast<Integer>(*number);
  }
  template <class Real>
  void Measure(const toml::table& table, const char* key, double least, double most, Real& value) {
    if (const std::optional<double> number = Number(table, key, least, most)) value = static_cast<Real>(*number);
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
    if (!good) return Problem(*node, "'anchor' takes [latitude, longitude, height], in degrees and metres");
    settings_.anchor = {parts[0], parts[1], parts[2]};
  }

  void Forces(const toml::table& table) {
    const toml::node* node = table.get("forces");
    if (node == nullptr) return;
    if (node->as_table() == nullptr)
      return Problem(*node, "write [dis.forces] above lines such as: blue = \"friendly\"");
    for (const auto& [team, value] : *node->as_table()) {
      constexpr std::string_view kNames[] = {"other", "friendly", "opposing", "neutral"};
      const auto name = value.value_exact<std::string>();
      const auto number = value.value_exact<std::int64_t>();
      const auto at = std::find(std::begin(kNames), std::end(kNames), name.value_or(""));
      if (at == std::end(kNames) && (!number || *number < 0 || *number > 255)) {
        Problem(value, "a force is \"friendly\", \"opposing\", \"neutral\", \"other\" or a number up to 255");
        continue;
      }
      settings_.forces[std::string(team.str())] =
          static_cast<std::uint8_t>(number ? *number : std::distance(std::begin(kNames), at));
    }
  }

  TypePattern Type(const toml::table& row) {
    std::string text;
    ReadText(row, "type", text);
    const std::optional<TypePattern> pattern = ParseTypePattern(text);
    if (!pattern)
      Problem(row.contains("type") ? *row.get("type") : static_cast<const toml::node&>(row),
              "'type' takes up to seven numbers: \"3.1.225.1\" or \"3.1.*.1\"",
              "kind, domain, country, category, subcategory, specific, extra");
    return pattern.value_or(TypePattern{});
  }

  /// A scenario's own rows precede the existing ones.
  void Rows(const toml::table& table) {
    std::vector<EntityRow> entities;
    for (const toml::table* row : Tables(table, "entity", kMostRows, "dis.")) {
      CheckKeys(*row, "[[dis.entity]]", {"type", "body"});
      EntityRow& made = entities.emplace_back(EntityRow{Type(*row), {}});
      ReadText(*row, "body", made.body);
      if (made.body.empty()) Problem(*row, "this [[dis.entity]] has no 'body'", "a kind of body, such as \"soldier\"");
    }
    settings_.entities.insert(settings_.entities.begin(), entities.begin(), entities.end());
    std::vector<MunitionRow> munitions;
    for (const toml::table* row : Tables(table, "munition", kMostRows, "dis.")) {
      CheckKeys(*row, "[[dis.munition]]", {"type", "damage", "radius"});
      MunitionRow& made = munitions.emplace_back(MunitionRow{Type(*row)});
      Measure(*row, "damage", 0, 1e6, made.damage);
      Measure(*row, "radius", 0, 1000, made.radius_m);
    }
    settings_.munitions.insert(settings_.munitions.begin(), munitions.begin(), munitions.end());
  }

  Settings& settings_;
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
    Diagnostic problem = ProblemIn(file, std::string(error.description()));
    problem.line = static_cast<int>(error.source().begin.line);
    return problem;
  }
  const toml::node* node = root.get("dis");
  if (node == nullptr) return std::optional<Settings>();
  std::vector<Diagnostic> problems;
  SettingsReader reader(file.string(), settings, problems);
  if (const toml::table* table = node->as_table()) {
    reader.Read(*table);
  } else {
    reader.Problem(*node, "write [dis] above the options of the exercise");
  }
  if (!problems.empty()) return problems.front();
  return std::optional<Settings>(std::move(settings));
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
