// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_notes.h"

#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "mind/decision_codec.h"
#include "tell/decision_text.h"

namespace soarbox::sim {

struct MindNotes::Head {
  std::uint64_t number;  ///< The value's bits, a time tag or a level.
  std::array<std::uint32_t, 3> sizes;
  std::uint32_t key;
  Kind kind;
};

std::string NameOfPercept(std::string_view attribute, std::uint32_t key) {
  std::string name(attribute);
  if (key != 0) name.append("#").append(std::to_string(key));
  return name;
}

void MindNotes::Add(Kind kind, std::uint64_t number, std::string_view first, std::string_view second,
                    std::string_view third, std::uint32_t key) {
  Head head{};
  head.number = number;
  head.sizes = {static_cast<std::uint32_t>(first.size()), static_cast<std::uint32_t>(second.size()),
                static_cast<std::uint32_t>(third.size())};
  head.key = key;
  head.kind = kind;
  const std::size_t needed = used_ + sizeof head + first.size() + second.size() + third.size();
  if (needed > bytes_.size()) bytes_.resize(2 * needed);
  char* at = bytes_.data() + used_;
  std::memcpy(at, &head, sizeof head);
  at += sizeof head;
  const auto put = [&at](std::string_view text) {
    if (text.empty()) return;
    std::memcpy(at, text.data(), text.size());
    at += text.size();
  };
  put(first);
  put(second);
  put(third);
  used_ = needed;
}

void MindNotes::NotePercept(std::string_view path, const Percept& constant) {
  if (const auto* integer = std::get_if<std::int64_t>(&constant.value)) {
    Add(Kind::kInteger, std::bit_cast<std::uint64_t>(*integer), path, constant.attribute, {}, constant.key);
  } else if (const auto* number = std::get_if<double>(&constant.value)) {
    NoteNumber(path, constant.attribute, constant.key, *number);
  } else if (const std::string* text = constant.Text()) {
    Add(Kind::kText, 0, path, constant.attribute, *text, constant.key);
  }
}
void MindNotes::NoteNumber(std::string_view path, std::string_view attribute, std::uint32_t key, double value) {
  Add(Kind::kFloat, std::bit_cast<std::uint64_t>(value), path, attribute, {}, key);
}
void MindNotes::NotePerceptGone(std::string_view path, std::string_view attribute, std::uint32_t key) {
  Add(Kind::kGone, 0, path, attribute, {}, key);
}
void MindNotes::NoteCommand(std::string_view command, std::uint64_t tag) {
  Add(Kind::kCommand, tag, command);
}
void MindNotes::NoteOutcome(std::string_view command, std::string_view how, std::string_view reason) {
  Add(Kind::kOutcome, 0, command, how, reason);
}
void MindNotes::NoteRuleOfCommand(std::uint64_t tag, std::string_view rule) {
  Add(Kind::kRuleOfCommand, tag, rule);
}

void MindNotes::NoteOperator(int level, std::string_view id, std::string_view name) {
  Add(Kind::kOperator, static_cast<std::uint64_t>(level), id, name);
}
void MindNotes::NoteState(int level, std::string_view state, std::string_view impasse, std::string_view attribute) {
  Add(Kind::kState, static_cast<std::uint64_t>(level), state, impasse, attribute);
}
void MindNotes::NoteStateGone(int level, std::string_view state) {
  Add(Kind::kStateGone, static_cast<std::uint64_t>(level), state);
}
void MindNotes::NoteHalt() {
  Add(Kind::kHalt, 0);
}
void MindNotes::NoteRecall(int level, bool is_episode, std::uint64_t number, std::string_view question,
                           std::string_view answer) {
  const std::string what =
      number == 0 ? (is_episode ? "no episode" : "no fact") : (is_episode ? "episode " : "@") + std::to_string(number);
  Add(Kind::kRecall, static_cast<std::uint64_t>(level), what, question, answer);
}
void MindNotes::NoteLearned(int level, std::string_view rule) {
  Add(Kind::kLearned, static_cast<std::uint64_t>(level), rule);
}
void MindNotes::NoteValue(std::string_view rule, double value) {
  Add(Kind::kValue, std::bit_cast<std::uint64_t>(value), rule);
}
void MindNotes::NoteReward(double reward) {
  Add(Kind::kReward, std::bit_cast<std::uint64_t>(reward));
}
void MindNotes::NoteEpisodeEnd() {
  Add(Kind::kEpisodeEnd, 0);
}
void MindNotes::NoteReason(std::string_view reason) {
  if (!reason.empty()) Add(Kind::kReason, 0, reason);
}
void MindNotes::NoteDecided(std::string_view decision) {
  if (!decision.empty()) Add(Kind::kDecided, 0, decision);
}

void MindNotes::NoteFiring(std::string_view rule, bool retracts) {
  Add(retracts ? Kind::kRetract : Kind::kFire, 0, rule);
}
void MindNotes::NoteElement(bool added, std::uint64_t tag, std::string_view id, std::string_view attribute,
                            std::string_view value, bool acceptable) {
  Add(added ? Kind::kAdded : Kind::kRemoved, tag, id, attribute, value, acceptable ? 1 : 0);
}

namespace {

/// Three blanks per level below the first.
std::string Indent(std::uint64_t level) {
  return std::string(level > 1 && level < 1'000'000 ? 3 * static_cast<std::size_t>(level - 1) : 0, ' ');
}

std::string Joined(std::string_view path, std::string_view attribute, std::uint32_t key) {
  return std::string(path) + NameOfPercept(attribute, key);
}

}  // namespace

bool MindNotes::Next(std::size_t& at, View& view) const {
  if (at + sizeof(Head) > used_) return false;
  Head head;
  std::memcpy(&head, bytes_.data() + at, sizeof head);
  at += sizeof head;
  std::string_view* texts[] = {&view.first, &view.second, &view.third};
  for (std::size_t i = 0; i < head.sizes.size(); ++i) {
    *texts[i] = std::string_view(bytes_).substr(at, head.sizes[i]);
    at += head.sizes[i];
  }
  view.kind = head.kind;
  view.number = head.number;
  view.key = head.key;
  return true;
}

MindWords MindNotes::Words(bool with_details) const {
  MindWords words;
  std::vector<std::pair<std::uint64_t, std::string_view>> rules;
  const auto decided = [&words](std::string line) {
    words.decisions.push_back(std::move(line));
    words.reasons.emplace_back();
  };
  const auto detail = [&words](std::string_view what) {
    return std::to_string(words.decisions.size()).append(" ").append(what);
  };
  View head;
  for (std::size_t at = 0; Next(at, head);) {
    const std::string_view first = head.first, second = head.second, third = head.third;
    const auto percept = [&, path = first, attribute = second](const auto& value) {
      words.percepts.push_back(Joined(path, attribute, head.key) + " " + DescribeValue({{}, 0, value}));
    };
    const auto real = [&] { return std::bit_cast<double>(head.number); };
    switch (head.kind) {
      case Kind::kInteger:
        percept(std::bit_cast<std::int64_t>(head.number));
        break;
      case Kind::kFloat:
        percept(std::bit_cast<double>(head.number));
        break;
      case Kind::kText:
        percept(std::string(third));
        break;
      case Kind::kGone:
        words.percepts.push_back("-" + Joined(first, second, head.key));
        break;
      case Kind::kCommand: {
        words.commands.emplace_back(first);
        std::string& rule = words.command_rules.emplace_back();
        for (const auto& [tag, name] : rules) {
          if (tag != head.number) continue;
          rule = name;
          break;
        }
        break;
      }
      case Kind::kOutcome: {
        std::string& line = words.commands.emplace_back(first);
        line.append(": ").append(second);
        if (!third.empty()) line.append(" ").append(third);
        words.command_rules.emplace_back();
        break;
      }
      case Kind::kRuleOfCommand:
        rules.emplace_back(head.number, first);
        break;
      case Kind::kOperator: {
        std::string line = Indent(head.number).append("O: ").append(first);
        if (!second.empty()) line.append(" (").append(second).append(")");
        decided(std::move(line));
        break;
      }
      case Kind::kState: {
        std::string line = Indent(head.number).append("==>S: ").append(first);
        if (head.number > 1) line.append(" (").append(third).append(" ").append(second).append(")");
        decided(std::move(line));
        break;
      }
      case Kind::kStateGone:
        decided(Indent(head.number).append("<==S: ").append(first));
        break;
      case Kind::kRecall: {
        std::string line = Indent(head.number).append("recall ").append(first);
        line.append(" {").append(third).append("} for {").append(second).append("}");
        decided(std::move(line));
        break;
      }
      case Kind::kLearned:
        decided(Indent(head.number).append("learn ").append(first));
        break;
      case Kind::kValue:
        decided(std::string("value ").append(first).append(" ") + DescribeValue({{}, 0, real()}));
        break;
      case Kind::kReward:
        decided("reward " + DescribeValue({{}, 0, real()}));
        break;
      case Kind::kEpisodeEnd:
        decided("episode ends");
        break;
      case Kind::kHalt:
        decided("halt");
        break;
      case Kind::kReason:
        if (!words.reasons.empty()) words.reasons.back() = first;
        break;
      case Kind::kDecided:
        if (words.reasons.empty()) break;
        if (const std::optional<mind::Decision> decision = mind::Unpack(first))
          words.reasons.back() = tell::WhyDecided(*decision);
        break;
      case Kind::kFire:
      case Kind::kRetract:
        if (with_details)
          words.details.push_back(detail(head.kind == Kind::kFire ? "fire " : "retract ").append(first));
        break;
      case Kind::kAdded:
      case Kind::kRemoved: {
        if (!with_details) break;
        std::string line = detail(head.kind == Kind::kAdded ? "+ " : "- ").append(std::to_string(head.number));
        line.append(": ").append(first).append(" ^").append(second).append(" ").append(third);
        if (head.key != 0) line.append(" +");
        words.details.push_back(std::move(line));
        break;
      }
    }
  }
  return words;
}

}  // namespace soarbox::sim
