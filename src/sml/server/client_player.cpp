// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/client_player.h"

#include <charconv>
#include <cstdlib>

#include "kernel/base/random.h"
#include "sml/server/hosted_agent.h"
#include "sml/server/kernel_host.h"
#include "sml/server/scene_calls.h"

namespace soarbox::server {

using kernel::InputElement;
using kernel::RunUnit;

namespace {

std::uint64_t NumberIn(const std::string& text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

void ReadValue(const std::string& type, const std::string& text, InputWme& wme) {
  wme.text = text;
  if (type == "int") {
    wme.type = InputWme::Type::kInt;
    wme.integer = std::strtoll(text.c_str(), nullptr, 10);
  } else if (type == "double") {
    wme.type = InputWme::Type::kDouble;
    wme.real = std::strtod(text.c_str(), nullptr);
  } else if (type == "id") {
    wme.type = InputWme::Type::kId;
  }
}

std::string AnswerKey(std::string_view function, std::string_view argument) {
  return std::string(function) + '\t' + std::string(argument);
}

bool IsNone(const std::string& handle) {
  return handle == std::to_string(static_cast<std::uint32_t>(InputElement::kNone));
}

constexpr std::size_t kPartsOfAdd = 8, kPartsOfSet = 6, kPartsOfGo = 6, kPartsOfAnswer = 5;

}  // namespace

std::string ClientPlayer::Play(HostedAgent& hosted, const Parts& parts) {
  const std::string& kind = parts.front();
  if (kind == "go" && parts.size() >= kPartsOfGo) return Go(hosted, parts);
  if (kind == "add" && parts.size() >= kPartsOfAdd) return Add(hosted, parts);
  if (kind == "set" && parts.size() >= kPartsOfSet) return Set(hosted, parts);
  if (parts.size() < 3) return "the log has an incomplete line: " + kind;
  if (kind == "line") return Line(hosted, parts[2]);
  if (kind == "remove") return Remove(hosted, parts[2]);
  if (kind == "function") {
    functions_.insert(parts[2]);
  } else if (kind == "agent") {
    // Resets the random numbers to those of a new agent.
    hosted.agent().random() = kernel::RandomStream();
  } else if (kind == "answer" && parts.size() >= kPartsOfAnswer) {
    answers_[{hosted.number(), AnswerKey(parts[2], parts[3])}].next.push_back(parts[4]);
  } else if (kind == "drop") {
    hosted.input().RemoveByTag(std::strtoll(parts[2].c_str(), nullptr, 10));
  } else if (kind == "scene") {
    if (!SendScene(hosted, parts[2])) return "lines for the scene were dropped: its spatial visual system is off";
  } else {
    return "the log has an unknown line: " + kind;
  }
  return {};
}

std::optional<std::string> ClientPlayer::Answer(const HostedAgent* hosted, std::string_view function,
                                                std::string_view argument) {
  const auto found = answers_.find({hosted == nullptr ? 0 : hosted->number(), AnswerKey(function, argument)});
  if (found == answers_.end()) return std::nullopt;
  Answers& answers = found->second;
  if (!answers.next.empty()) {
    answers.last = std::move(answers.next.front());
    answers.next.pop_front();
  }
  return answers.last;
}

std::string ClientPlayer::Go(HostedAgent& hosted, const Parts& parts) {
  const RunPosition goal{NumberIn(parts[2]), static_cast<int>(NumberIn(parts[3])), NumberIn(parts[4])};
  kernel::Agent& agent = hosted.agent();
  hosted.PrepareRun();
  for (RunPosition at = PositionOf(hosted); at < goal && !agent.halted() && !agent.out_of_memory();) {
    agent.ClearStopRequest();
    const bool is_last_phase = goal.elaborations != 0 && at.cycles == goal.cycles && at.phase == goal.phase;
    agent.Step(is_last_phase ? RunUnit::kElaboration : RunUnit::kPhase);
    hosted.DeliverOutput();
    hosted.FlushPrint();
    const RunPosition now = PositionOf(hosted);
    if (now == at) break;
    at = now;
  }
  hosted.run_state = agent.halted() || agent.out_of_memory() ? ::sml::sml_RUNSTATE_HALTED : ::sml::sml_RUNSTATE_STOPPED;
  hosted.input().Tidy();
  if (parts[5] == "-" || astray_.contains(hosted.number())) return {};
  const std::uint64_t recorded = NumberIn(parts[5]), now = hosted.agent().counters().firings;
  if (recorded == now && PositionOf(hosted) == goal) return {};
  astray_.insert(hosted.number());
  return "from here on, its run differs from the recording: rules fired " + std::to_string(now) +
         " times so far, not " + std::to_string(recorded);
}

std::string ClientPlayer::Line(HostedAgent& hosted, const std::string& line) {
  is_in_line_ = true;
  KernelHost::LineOptions options;
  options.filter = false;
  options.recorded = true;
  const cli::CommandResult result = host_.Execute(&hosted, line, options);
  is_in_line_ = false;
  return result.ok ? std::string() : result.text;
}

std::string ClientPlayer::Add(HostedAgent& hosted, const Parts& parts) {
  InputWme wme;
  wme.tag = std::strtoll(parts[3].c_str(), nullptr, 10);
  wme.id = parts[4];
  wme.attribute = parts[5];
  ReadValue(parts[6], parts[7], wme);
  const InputElement element = hosted.input().Add(wme);
  elements_[{hosted.number(), parts[2]}] = element;
  if (element != InputElement::kNone || IsNone(parts[2])) return {};
  return "the client gave ^" + parts[5] + " " + parts[7] + " to " + parts[4] +
         ", which does not exist: the output differs from the recording";
}

std::string ClientPlayer::Set(HostedAgent& hosted, const Parts& parts) {
  const auto found = elements_.find({hosted.number(), parts[2]});
  if (found == elements_.end() || found->second == InputElement::kNone) return {};
  InputWme wme;
  wme.tag = std::strtoll(parts[3].c_str(), nullptr, 10);
  ReadValue(parts[4], parts[5], wme);
  found->second = hosted.input().Update(found->second, wme);
  return {};
}

std::string ClientPlayer::Remove(HostedAgent& hosted, const std::string& handle) {
  const auto found = elements_.find({hosted.number(), handle});
  if (found == elements_.end()) return {};
  if (found->second != InputElement::kNone) hosted.input().Remove(found->second);
  elements_.erase(found);
  return {};
}

}  // namespace soarbox::server
