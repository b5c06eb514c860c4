// SPDX-License-Identifier: BSD-2-Clause
#include "world/shown_state.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "diagnostics/plain_text.h"

namespace soarbox::world {
namespace {

constexpr std::size_t kLongestText = 200;
constexpr int kDeepest = 16;

/// The text on one line, without tabs.
std::string OneLine(std::string_view text) {
  std::string line(Beginning(text, kLongestText));
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20; }, ' ');
  return line;
}

/// The rows of one topic, from its row of depth 0 to the next topic.
struct Part {
  std::size_t begin = 0, end = 0;
};

Part FindTopic(std::span<const ShownRow> rows, std::string_view topic) {
  Part part{rows.size(), rows.size()};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].depth != 0) continue;
    if (part.begin < rows.size()) {
      part.end = i;
      return part;
    }
    if (rows[i].name == topic) part.begin = i;
  }
  return part;
}

/// A unique path for each row, to compare two versions of a topic: the names of its ancestors, its own name, and a
/// number if several are equal.
std::vector<std::string> PathsOf(std::span<const ShownRow> rows) {
  std::vector<std::string> paths, above;
  std::map<std::string, int> seen;
  for (const ShownRow& row : rows) {
    above.resize(std::min(static_cast<std::size_t>(row.depth), above.size()));
    std::string path = (above.empty() ? std::string() : above.back()) + "\n" + row.name;
    path += "\t" + std::to_string(++seen[path]);
    above.push_back(path);
    paths.push_back(std::move(path));
  }
  return paths;
}

void AppendLine(const ShownRow& row, std::string& text) {
  text += std::to_string(row.depth) + (row.active ? "*" : "-") + std::to_string(row.since_tick) + " " + row.name +
          "\t" + row.value + "\n";
}

}  // namespace

bool ShownState::Show(std::string_view topic, std::vector<ShownRow> rows, std::uint64_t tick) {
  const std::string name = OneLine(topic);
  const Part part = FindTopic(rows_, name);
  const std::span<const ShownRow> before = std::span(rows_).subspan(part.begin, part.end - part.begin);
  if (!rows.empty()) {
    rows.front().depth = 0;
    rows.front().name = name;
  }
  rows.resize(std::min(rows.size(), kMostRows - std::min(kMostRows, rows_.size() - before.size())));
  std::map<std::string, const ShownRow*> earlier;
  const std::vector<std::string> paths_before = PathsOf(before);
  for (std::size_t i = 0; i < before.size(); ++i) earlier[paths_before[i]] = &before[i];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ShownRow& row = rows[i];
    if (i > 0) {
      row.depth = std::clamp(row.depth, 1, std::min(kDeepest, rows[i - 1].depth + 1));
      row.name = OneLine(row.name);
    }
    row.value = OneLine(row.value);
    row.since_tick = tick;
  }
  const std::vector<std::string> paths = PathsOf(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto same = earlier.find(paths[i]);
    if (same != earlier.end() && same->second->value == rows[i].value && same->second->active == rows[i].active)
      rows[i].since_tick = same->second->since_tick;
  }
  if (std::ranges::equal(rows, before)) return false;
  const auto at = rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(part.begin),
                              rows_.begin() + static_cast<std::ptrdiff_t>(part.end));
  rows_.insert(at, rows.begin(), rows.end());
  text_.clear();
  for (const ShownRow& row : rows_) AppendLine(row, text_);
  return true;
}

std::vector<ShownRow> ReadShown(std::string_view text) {
  std::vector<ShownRow> rows;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ShownRow row;
    const char* const stop = line.data() + line.size();
    const auto [mark, no_depth] = std::from_chars(line.data(), stop, row.depth);
    if (no_depth != std::errc{} || mark == stop || (*mark != '*' && *mark != '-')) continue;
    row.active = *mark == '*';
    const auto [blank, no_tick] = std::from_chars(mark + 1, stop, row.since_tick);
    if (no_tick != std::errc{} || blank == stop || *blank != ' ') continue;
    const std::string_view rest = line.substr(static_cast<std::size_t>(blank + 1 - line.data()));
    const std::size_t tab = std::min(rest.find('\t'), rest.size());
    row.depth = std::clamp(row.depth, 0, kDeepest);
    row.name = rest.substr(0, tab);
    row.value = rest.substr(std::min(tab + 1, rest.size()));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string DoingOf(std::span<const ShownRow> rows) {
  if (const Part doing = FindTopic(rows, "doing"); doing.begin < rows.size()) return rows[doing.begin].value;
  if (rows.empty()) return {};
  if (!rows[0].value.empty()) return rows[0].value;
  std::string path;
  int depth = 1;
  for (std::size_t i = 1; i < rows.size() && rows[i].depth != 0; ++i) {
    if (rows[i].depth != depth || !rows[i].active) continue;
    path += (path.empty() ? "" : " > ") + rows[i].name;
    ++depth;
  }
  return path;
}

}  // namespace soarbox::world
