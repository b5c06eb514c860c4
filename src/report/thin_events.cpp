// SPDX-License-Identifier: BSD-2-Clause
#include "report/thin_events.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "diagnostics/plain_text.h"

namespace soarbox::report {
namespace {

/// Size of an event without its texts: braces, keys, the time.
constexpr std::size_t kEventBytes = 36;

std::size_t BytesOf(const StoryEvent& event) {
  return kEventBytes + event.agent.size() + event.kind.size() + event.text.size();
}

}  // namespace

std::string CutText(std::string text, std::size_t most_bytes) {
  constexpr std::string_view kDots = " ...";
  if (text.size() <= most_bytes) return text;
  text.resize(Beginning(text, most_bytes > kDots.size() ? most_bytes - kDots.size() : 0).size());
  return text.append(kDots);
}

void ThinEvents(std::vector<StoryEvent>& events, std::size_t most_bytes) {
  while (true) {
    std::map<std::string_view, std::pair<std::size_t, std::size_t>> of_kinds;  // Bytes and number of events.
    std::size_t all = 0;
    for (const StoryEvent& event : events) {
      auto& [bytes, count] = of_kinds[event.kind];
      bytes += BytesOf(event);
      all += BytesOf(event);
      ++count;
    }
    if (all <= most_bytes) return;
    const auto heaviest = std::max_element(
        of_kinds.begin(), of_kinds.end(), [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    if (heaviest->second.second <= 1) return;
    const std::string kind(heaviest->first);
    std::size_t number = 0;
    std::erase_if(events, [&](const StoryEvent& event) { return event.kind == kind && number++ % 2 == 1; });
  }
}

std::vector<StorySpan> MergeSpans(const std::vector<StorySpan>& spans, double seconds, std::size_t columns) {
  if (columns == 0 || seconds <= 0) return spans;
  const double width_s = seconds / static_cast<double>(columns);
  struct Group {
    StorySpan span;
    double longest_s = 0, column = -1;
    std::size_t count = 0;
  };
  std::vector<StorySpan> merged;
  const auto close = [&merged](Group& group) {
    if (group.count > 1) group.span.name += " and " + std::to_string(group.count - 1) + " more";
    if (group.count > 0) merged.push_back(std::move(group.span));
    group = {};
  };
  std::map<std::size_t, Group> open;
  for (const StorySpan& span : spans) {
    Group& group = open[span.agent];
    const double length_s = span.to_s - span.from_s, column = std::floor(span.from_s / width_s);
    if (length_s >= width_s || column != group.column) close(group);
    if (length_s >= width_s) {
      merged.push_back(span);
      continue;
    }
    if (group.count++ == 0) {
      group.span = span;
      group.column = column;
      group.longest_s = length_s;
      continue;
    }
    group.span.to_s = span.to_s;
    if (length_s > group.longest_s) {
      group.longest_s = length_s;
      group.span.name = span.name;
    }
  }
  for (auto& [agent, group] : open) close(group);
  std::stable_sort(merged.begin(), merged.end(),
                   [](const StorySpan& a, const StorySpan& b) { return a.from_s < b.from_s; });
  return merged;
}

std::vector<std::size_t> KeptMoments(std::size_t count, std::size_t every) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, every)) kept.push_back(i);
  if (count > 0 && kept.back() != count - 1) kept.push_back(count - 1);
  return kept;
}

StoryWay ThinWay(const StoryWay& way, const std::vector<std::size_t>& kept) {
  StoryWay thin;
  thin.from = kept.size();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] < way.from || kept[i] - way.from >= way.x_cm.size()) continue;
    const std::size_t at = kept[i] - way.from;
    thin.from = std::min(thin.from, i);
    thin.x_cm.push_back(way.x_cm[at]);
    thin.z_cm.push_back(way.z_cm[at]);
    thin.health.push_back(way.health[at]);
    thin.speed_dmps.push_back(way.speed_dmps[at]);
  }
  return thin;
}

std::vector<std::int32_t> Differences(std::vector<std::int32_t> numbers) {
  for (std::size_t i = numbers.size(); i-- > 1;) numbers[i] -= numbers[i - 1];
  return numbers;
}

}  // namespace soarbox::report
