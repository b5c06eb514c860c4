// SPDX-License-Identifier: BSD-2-Clause
#include "record/percept_values.h"

#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

void Apply(const mind::PerceptChanged& percept, PerceptValues& values) {
  std::string path = wording::PerceptPath(percept.path, percept.attribute, percept.key);
  std::visit(mind::Cases{[&](std::string_view word) { values.insert_or_assign(std::move(path), std::string(word)); },
                         [&](auto number) { values.insert_or_assign(std::move(path), number); }},
             percept.value);
}

void Apply(const mind::PerceptGone& gone, PerceptValues& values) {
  const std::string path = wording::PerceptPath(gone.path, gone.attribute, gone.key);
  const auto is_below = [&](std::string_view key) {
    return key.starts_with(path) && (key.size() == path.size() || key[path.size()] == '.');
  };
  for (auto at = values.lower_bound(path); at != values.end() && at->first.starts_with(path);)
    at = is_below(at->first) ? values.erase(at) : std::next(at);
}

}  // namespace

std::string TextOf(const PerceptValue& value) {
  return std::visit([](const auto& constant) { return wording::ValueText(constant); }, value);
}

void ApplyPercepts(const mind::EventLog& events, PerceptValues& values) {
  events.ForEach(mind::Cases{[&](const mind::PerceptChanged& percept) { Apply(percept, values); },
                             [&](const mind::PerceptGone& gone) { Apply(gone, values); }, [](const auto&) {}});
}

}  // namespace soarbox::record
