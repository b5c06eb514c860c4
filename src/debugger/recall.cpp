// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/recall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "debugger/recorded_mind.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostRecalls = 2000;

/// The constants of an episode, and the objects that an object leads to: by object and attribute.
using Values = std::map<std::uint32_t, std::map<std::string, std::string>>;
using Links = std::map<std::uint32_t, std::map<std::string, std::uint32_t>>;

/// The value of ^io.input-link.time in an episode.
std::optional<double> TimeIn(const Values& values, const Links& links) {
  std::uint32_t object = 0;
  for (const char* attribute : {"io", "input-link"}) {
    const auto from = links.find(object);
    if (from == links.end()) return std::nullopt;
    const auto to = from->second.find(attribute);
    if (to == from->second.end()) return std::nullopt;
    object = to->second;
  }
  const auto of = values.find(object);
  if (of == values.end()) return std::nullopt;
  const auto time = of->second.find("time");
  if (time == of->second.end()) return std::nullopt;
  return std::strtod(time->second.c_str(), nullptr);
}

}  // namespace

void RecallLog::Add(std::uint64_t tick, const record::MindRecord& mind) {
  mind.events.ForEachOf<mind::Recalled>([&](const mind::Recalled& recalled) {
    recalls_.push_back({tick, recalled.level, recalled.is_episode, recalled.number, std::string(recalled.answer),
                        std::string(recalled.question), std::string(recalled.reason)});
    ++count_;
    if (recalls_.size() > kMostRecalls) recalls_.pop_front();
  });
}

void RecallLog::CutFrom(std::uint64_t tick) {
  while (!recalls_.empty() && recalls_.back().tick >= tick) {
    recalls_.pop_back();
    --count_;
  }
}

RecallLog RecallLog::Until(std::uint64_t tick) const {
  RecallLog until;
  for (const Recall& recall : recalls_) {
    if (recall.tick <= tick) until.recalls_.push_back(recall);
  }
  until.count_ = until.recalls_.size();
  return until;
}

LongTermView LookAtLongTerm(explain::Inspector& mind, const std::string& text, std::size_t most) {
  LongTermView view;
  auto* const source = dynamic_cast<explain::LongTermSource*>(&mind);
  if (source == nullptr) {
    view.note = "what it knows and remembers: " + std::string(Absence(mind));
    return view;
  }
  view.facts = source->LongTerm(most, text);
  if (!view.facts.semantic && !view.facts.episodic) {
    view.note = "No long-term memory is switched on. A rule file switches one on: smem --enable, epmem --enable";
  }
  return view;
}

EpisodeView LookAtEpisode(explain::Inspector& mind, std::size_t number) {
  EpisodeView view;
  auto* const source = dynamic_cast<explain::LongTermSource*>(&mind);
  if (source == nullptr || number == 0) return view;
  const std::vector<explain::RememberedFact> facts = source->Episode(number);
  if (facts.empty()) return view;
  view.number = number;
  std::map<std::uint32_t, std::string> paths{{0, ""}};  // By object: the first path that leads to it.
  std::map<std::uint32_t, std::string> ways;            // By object: the last attribute of that path.
  Values values;
  Links links;
  for (const explain::RememberedFact& fact : facts) {
    const auto path = paths.find(fact.object);
    const std::string here = (path == paths.end() ? std::string("?.") : path->second) + fact.attribute;
    if (fact.is_object) {
      paths.try_emplace(fact.value_object, here + ".");
      ways.try_emplace(fact.value_object, fact.attribute);
      links[fact.object].try_emplace(fact.attribute, fact.value_object);
    } else {
      values[fact.object].try_emplace(fact.attribute, fact.value);
      view.lines.push_back(here + " " + fact.value);
    }
  }
  std::ranges::sort(view.lines);
  view.time_s = TimeIn(values, links);
  for (const auto& [object, way] : ways) {
    const auto position = links[object].find("position");
    if (position == links[object].end()) continue;
    const std::map<std::string, std::string>& at = values[position->second];
    const auto x = at.find("x"), z = at.find("z");
    if (x == at.end() || z == at.end()) continue;
    RememberedThing thing;
    thing.kind = way;
    const auto name = values[object].find("name");
    thing.name = way == "self" ? "self" : name == values[object].end() ? way : name->second;
    thing.x = std::strtod(x->second.c_str(), nullptr);
    thing.z = std::strtod(z->second.c_str(), nullptr);
    view.things.push_back(std::move(thing));
  }
  return view;
}

void TellRecalls(const RecallLog& log, WhyNode& answer) {
  constexpr std::size_t kMostTold = 3;
  const std::deque<Recall>& recalls = log.recalls();
  for (std::size_t n = 0; n < std::min(recalls.size(), kMostTold); ++n) {
    Recall recall = recalls[recalls.size() - 1 - n];
    const std::string reason = std::exchange(recall.reason, {});
    WhyNode node{(n == 0 ? "recalled last: " : "before that: ") + ToText(recall), WhyKind::kRecall};
    if (!reason.empty()) node.below.push_back({reason});
    answer.below.push_back(std::move(node));
  }
}

std::string ToText(const LongTermView& view) {
  std::string text;
  if (!view.note.empty()) text += view.note + "\n";
  const explain::LongTermFacts& facts = view.facts;
  if (facts.semantic || facts.objects > 0) {
    text += fmt::format("semantic memory{}: {} objects, {} augmentations\n", facts.semantic ? "" : " (off)",
                        facts.objects, facts.augmentations);
    for (const explain::KnownObjectFact& object : facts.known) {
      text += fmt::format("{:>8} {:>9.3f} {:>6}  {}\n", "@" + std::to_string(object.number), object.activation,
                          object.uses, object.text);
    }
  }
  if (facts.episodic || facts.episodes > 0) {
    text += fmt::format("episodic memory{}: {} episodes\n", facts.episodic ? "" : " (off)", facts.episodes);
  }
  return text;
}

std::string ToText(const EpisodeView& view) {
  if (view.number == 0) return "there is no such episode\n";
  std::string text = fmt::format("episode {}\n", view.number);
  for (const std::string& line : view.lines) text += "  " + line + "\n";
  return text;
}

std::string ToText(const Recall& recall) {
  std::string text = recall.number == 0  ? (recall.is_episode ? "no episode" : "no fact")
                     : recall.is_episode ? fmt::format("episode {}", recall.number)
                                         : fmt::format("@{}", recall.number);
  if (!recall.answer.empty()) text += " (" + recall.answer + ")";
  text += " for " + recall.question;
  if (!recall.reason.empty()) text += ": " + recall.reason;
  return text;
}

}  // namespace soarbox::debugger
