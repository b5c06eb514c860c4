// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/nearest_hint.h"

namespace soarbox::sim {

/// Base of the readers of TOML files. Each problem has its position.
class TableReader {
 public:
  /// `page` is the document that lists the allowed contents: "docs/missions.md".
  TableReader(std::string file, std::string page, std::vector<Diagnostic>& problems)
      : file_(std::move(file)), page_(std::move(page)), problems_(problems) {}
  virtual ~TableReader() = default;

  void Problem(const toml::node& at, std::string message, std::string hint = {}) {
    Diagnostic& problem = problems_.emplace_back();
    problem.file = file_;
    problem.line = static_cast<int>(at.source().begin.line);
    problem.column = static_cast<int>(at.source().begin.column);
    problem.message = std::move(message);
    problem.hint = std::move(hint);
  }

  /// Reports keys that are not in `known`.
  void CheckKeys(const toml::table& table, std::string_view what, const std::vector<std::string_view>& known) {
    for (const auto& [key, value] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      Problem(value, std::string(what) + " has no '" + std::string(key.str()) + "'",
              NearestHint(key.str(), known, HintFor(key.str(), known)));
    }
  }

  std::string Text(const toml::table& table, std::string_view key, std::string otherwise = {}) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return otherwise;
    if (const auto text = node->value_exact<std::string>()) return *text;
    Problem(*node, "'" + std::string(key) + "' takes a text in quotes");
    return otherwise;
  }

  /// A number between these limits; nothing if the key is absent, or after an error.
  std::optional<double> Number(const toml::table& table, std::string_view key, double min, double max) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const auto number = node->is_number() ? node->value<double>() : std::nullopt;
    if (number && *number >= min && *number <= max) return number;
    char limits[80];
    std::snprintf(limits, sizeof limits, "' takes a number from %.10g to %.10g", min, max);
    Problem(*node, "'" + std::string(key) + limits);
    return std::nullopt;
  }
  std::optional<int> WholeNumber(const toml::table& table, std::string_view key, int min, int max) {
    const std::optional<double> number = Number(table, key, min, max);
    if (!number) return std::nullopt;
    if (*number == std::floor(*number)) return static_cast<int>(*number);
    Problem(*table.get(key), "'" + std::string(key) + "' takes a whole number");
    return std::nullopt;
  }
  bool Truth(const toml::table& table, std::string_view key, bool otherwise = false) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return otherwise;
    if (!node->is_boolean()) Problem(*node, "'" + std::string(key) + "' takes true or false");
    return node->value_exact<bool>().value_or(otherwise);
  }

  /// The tables of [[key]]; at most `most`. `above` is the prefix of the key in the file: "dis.".
  std::vector<const toml::table*> Tables(const toml::table& root, std::string_view key, std::size_t most,
                                         const std::string& above = {}) {
    std::vector<const toml::table*> tables;
    const toml::node* node = root.get(key);
    if (node == nullptr) return tables;
    const toml::array* list = node->as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
      if (list->get(i)->is_table()) tables.push_back(list->get(i)->as_table());
    if (list == nullptr || tables.size() != list->size())
      Problem(*node, "write [[" + above + std::string(key) + "]] above each one");
    if (tables.size() > most) {
      Problem(*node, "there are more than " + std::to_string(most) + " of them");
      tables.resize(most);
    }
    return tables;
  }

 protected:
  /// The hint for an unknown key without a similar known key.
  virtual std::string HintFor(std::string_view, const std::vector<std::string_view>&) const {
    return page_ + " lists what there is";
  }
  const std::string& file() const { return file_; }
  std::vector<Diagnostic>& problems() { return problems_; }

 private:
  std::string file_, page_;
  std::vector<Diagnostic>& problems_;
};

}  // namespace soarbox::sim
