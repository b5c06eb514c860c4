// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <unordered_set>

#include "mission/read_mission.h"

namespace soarbox::mission {
namespace {

constexpr std::size_t kMostSeeds = 1'000'000;

std::optional<std::uint64_t> Whole(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  std::uint64_t value = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || at != text.data() + text.size() || value > 9'000'000'000'000'000) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::vector<std::uint64_t>> ParseSeeds(std::string_view text) {
  std::vector<std::uint64_t> seeds;
  std::unordered_set<std::uint64_t> seen;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view part = text.substr(0, comma);
    const std::size_t dots = part.find("..");
    const auto first = Whole(part.substr(0, dots));
    const auto last = dots == std::string_view::npos ? first : Whole(part.substr(dots + 2));
    if (!first || !last || *last < *first || *last - *first >= kMostSeeds - seeds.size()) return std::nullopt;
    for (std::uint64_t seed = *first; seed <= *last; ++seed)
      if (seen.insert(seed).second) seeds.push_back(seed);
    if (comma == std::string_view::npos) return seeds;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace soarbox::mission
