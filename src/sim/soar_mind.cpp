// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_mind.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "sim/senses.h"
#include "sim/work_limit.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#include "soarbox_Observation.h"
#endif
#include "vocabulary/vocabulary_percepts.h"

namespace soarbox::sim {
namespace {

constexpr int kDeepestParameter = 4;
/// Limits for parameters of one command, including everything below it, and of all commands of a mind in one tick.
constexpr std::size_t kMostParameters = 1'000, kMostParametersPerTick = 20'000;

#ifdef SOARBOX_OWN_KERNEL
using Batch = CallBatch;
#else
/// With another kernel, each call locks it.
struct Batch {
  explicit Batch(sml::Agent&) {}
};
#endif

/// The thesis' percept, with which each new mind begins.
PerceptSlot NewDistance() {
  const vocabulary::PerceptRow& row = vocabulary::RowOf("distance");
  PerceptSlot slot;
  slot.number = 0;
  slot.row = &row;
  slot.kind = PerceptSlot::Kind::kFloat;
  slot.attribute_size = static_cast<std::uint8_t>(row.Attribute().size());
  slot.has_row = true;
  return slot;
}

/// Reads the elements below an identifier of the output link. Links can form circles, and an object is read once for
/// each path to it. `left` is decremented for each element; nothing is read when it is 0.
vocabulary::PerceptList ReadBelow(sml::Identifier& parent, std::size_t& left, int depth = 0) {
  vocabulary::PerceptList list;
  for (int i = 0; i < parent.GetNumberChildren(); ++i) {
    sml::WMElement* child = parent.GetChild(i);
    if (child == nullptr) continue;
    if (left == 0) break;
    --left;
    vocabulary::Percept& read = list.emplace_back();
    read.attribute = child->GetAttribute();
    if (sml::Identifier* object = child->ConvertToIdentifier()) {
      read.value = depth < kDeepestParameter ? ReadBelow(*object, left, depth + 1) : vocabulary::PerceptList{};
    } else if (sml::IntElement* integer = child->ConvertToIntElement()) {
      read.value = static_cast<std::int64_t>(integer->GetValue());
    } else if (sml::FloatElement* number = child->ConvertToFloatElement()) {
      read.value = number->GetValue();
    } else {
      read.value = std::string(child->GetValueAsString());
    }
  }
  return list;
}

void AddParameters(const vocabulary::PerceptList& list, std::uint32_t depth, std::vector<mind::Parameter>& parameters) {
  for (const vocabulary::Percept& percept : list) {
    if (parameters.size() >= mind::kMostParameters) return;
    mind::Parameter& parameter = parameters.emplace_back();
    parameter.depth = depth;
    parameter.attribute = percept.attribute;
    if (const auto* below = std::get_if<vocabulary::PerceptList>(&percept.value)) {
      parameter.is_object = true;
      AddParameters(*below, depth + 1, parameters);
    } else if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) {
      parameter.value = *integer;
    } else if (const auto* number = std::get_if<double>(&percept.value)) {
      parameter.value = *number;
    } else {
      parameter.value = std::string_view(*percept.Text());
    }
  }
}

}  // namespace

/// Our own kernel reports the output of rules separately from traces that a debugger has requested. For another kernel,
/// its entire output is used.
struct SoarMind::Observations {
  Observations(sml::Agent& agent, mind::RuleOutput& output) {
#ifdef SOARBOX_OWN_KERNEL
    of_output = ObserveOutput(agent, output);
    if (of_output != nullptr) return;
#endif
    agent.RegisterForPrintEvent(sml::smlEVENT_PRINT, &Observations::OnPrint, &output);
  }
  static void OnPrint(sml::smlPrintEventId, void* output, sml::Agent*, char const* message) {
    static_cast<mind::RuleOutput*>(output)->Write(message);
  }
#ifdef SOARBOX_OWN_KERNEL
  std::unique_ptr<Observation> of_output, of_mind;
#endif
};

void SoarMind::EndObservations::operator()(Observations* observations) const {
  delete observations;
}

SoarMind::SoarMind(sml::Agent& agent, const MindSettings& settings)
    : agent_(&agent),
      link_(std::make_unique<PerceptLink>(agent)),
      own_body_(*link_),
      messages_(*link_),
      surroundings_(*link_),
      rows_(*link_),
      graph_(std::make_unique<GraphMirror>(*link_)),
      blinks_(settings.blinks),
      observations_(new Observations(agent, *output_)) {
  agent.SetBlinkIfNoChange(settings.blinks);
  // ReadOutput finds new elements by their time tags. With change tracking, a kernel in another process would have to
  // report each decision.
  agent.SetOutputLinkChangeTracking(false);
  if (settings.has_distance) {
    const Batch batch(agent);
    distance_ = std::make_unique<PerceptSlots>(1, NewDistance());
    if (link_->Add(link_->InputLink(), distance_->front())) {
      link_->Include(*distance_);
    } else {
      distance_.reset();
    }
  }
  if (settings.imagines) {
    agent.ExecuteCommandLine("svs --enable");
    scene_ = std::make_unique<SceneSense>();
  }
  SetDetail(settings.detail, settings.origins);
}

void SoarMind::SetDetail(MindDetail detail, [[maybe_unused]] bool origins) {
  if (observations_ == nullptr || (detail == MindDetail::kNone && !is_logged_)) return;
  is_logged_ = detail != MindDetail::kNone;
  record_->Clear();
#ifdef SOARBOX_OWN_KERNEL
  observations_->of_mind.reset();
  if (is_logged_) observations_->of_mind = ObserveMind(*agent_, *record_, detail);
  if (is_logged_ && origins) NoteOrigins(*agent_);
#endif
  for (InputMirror* mirror : {&own_body_, &messages_, &surroundings_, &rows_})
    mirror->SetLog(is_logged_ ? &record_->events : nullptr);
  graph_->SetLog(is_logged_ ? &record_->events : nullptr);
}

void SoarMind::SetDistance(float distance_squared_m2) {
  if (distance_ == nullptr) return;
  PerceptSlot& slot = distance_->front();
  const auto value = static_cast<double>(distance_squared_m2);
  const bool is_same = value == slot.number;
  if (is_same && !blinks_) return;
  if (is_logged_ && !is_same) record_->events.Add(mind::PerceptChanged{{}, "distance", 0, value});
  slot.number = value;
  const Batch batch(*agent_);
  link_->Change(slot);
}

void SoarMind::ShowRows(const vocabulary::PerceptList& percepts) {
  const Batch batch(*agent_);
  rows_.Show(percepts);
}

void SoarMind::ShowGraph(const script::PerceptGraph& percepts) {
  const Batch batch(*agent_);
  graph_->Show(percepts);
}

void SoarMind::Perceive(const Actor& body, bool surroundings) {
  const Batch batch(*agent_);
  own_body_.Show([&](InputMirror& mirror) { SenseOwnBody(body, mirror); });
  HearMessages(body, heard_, messages_);
  if (surroundings) surroundings_.Show([&](InputMirror& mirror) { SenseSurroundings(body, mirror); });
  if (scene_ == nullptr) return;
  if (const std::string lines = scene_->Update(body, surroundings); !lines.empty()) agent_->SendSVSInput(lines);
}

void SoarMind::Decide(bool has_run) {
  if (has_run) return ReadOutput();
  agent_->Commit();
#ifdef SOARBOX_OWN_KERNEL
  const std::uint64_t before = MindFirings(*agent_);
  SetMindFiringLimit(*agent_, before + kMostFirings);
#endif
  answer_ = agent_->RunSelfTilOutput();
#ifdef SOARBOX_OWN_KERNEL
  const std::uint64_t after = MindFirings(*agent_);
  fired_ = after < before ? after : after - before;  // It is smaller if a rule has executed init-soar.
#endif
  ReadOutput();
}

std::vector<SoarMind::Standing>::iterator SoarMind::FindStanding(std::uint64_t tag) {
  return std::lower_bound(standing_.begin(), standing_.end(), tag,
                          [](const Standing& standing, std::uint64_t wanted) { return standing.tag < wanted; });
}

void SoarMind::ReadOutput() {
  commands_.clear();
  withdrawn_.clear();
  for (Standing& standing : standing_) standing.seen = false;
  std::size_t tick_left = kMostParametersPerTick;
  if (sml::Identifier* link = agent_->GetOutputLink()) {
    for (int i = 0; i < link->GetNumberChildren(); ++i) {
      sml::WMElement* child = link->GetChild(i);
      if (child == nullptr || child->GetTimeTag() <= 0) continue;
      const auto tag = static_cast<std::uint64_t>(child->GetTimeTag());
      auto at = FindStanding(tag);
      const bool is_new = !Stands(at, tag);
      if (is_new) at = standing_.insert(at, Standing{tag});
      at->seen = true;
      at->place = i;
      if (!is_new) continue;
      vocabulary::SaidCommand& said = commands_.emplace_back();
      said.tag = tag;
      said.name = child->GetAttribute();
      sml::Identifier* word = child->ConvertToIdentifier();
      said.is_object = word != nullptr;
      if (said.is_object) {
        const std::size_t given = std::min(kMostParameters, tick_left);
        std::size_t left = given;
        said.parameters = ReadBelow(*word, left);
        tick_left -= given - left;
        said.is_too_large = left == 0;
        if (said.is_too_large) said.parameters.clear();
      }
      if (is_logged_) NoteSaid(said);
    }
  }
  std::erase_if(standing_, [this](const Standing& standing) {
    if (!standing.seen) withdrawn_.push_back(standing.tag);
    return !standing.seen;
  });
}

void SoarMind::NoteSaid(const vocabulary::SaidCommand& said) {
  said_.timetag = said.tag;
  said_.name = said.name;
  said_.rule = record_->MakerOf(said.tag);
  said_.parameters.clear();
  AddParameters(said.parameters, 0, said_.parameters);
  record_->events.Add(said_);
}

/// The command's identifier; null if it is not an identifier or was removed, because a debugger may have run the agent
/// since it was read.
sml::Identifier* SoarMind::FindWord(const Standing& command) const {
  sml::Identifier* link = agent_->GetOutputLink();
  if (link == nullptr) return nullptr;
  const auto is_it = [&](sml::WMElement* child) {
    return child != nullptr && static_cast<std::uint64_t>(child->GetTimeTag()) == command.tag;
  };
  // Nearly always at the same index as before.
  sml::WMElement* found = link->GetChild(command.place);
  for (int i = 0; !is_it(found); ++i) {
    if (i == link->GetNumberChildren()) return nullptr;
    found = link->GetChild(i);
  }
  return found->ConvertToIdentifier();
}

void SoarMind::Complete(std::uint64_t tag) {
  const auto at = FindStanding(tag);
  if (!Stands(at, tag)) return;
  if (sml::Identifier* word = FindWord(*at)) word->AddStatusComplete();
}

void SoarMind::NoteOutcome(std::string_view command, const Outcome& outcome) {
  switch (outcome.status) {
    case Outcome::Status::kProgress:
      return;
    case Outcome::Status::kComplete:
      record_->events.Add(mind::CommandEnded{command, mind::CommandStatus::kComplete, {}});
      return;
    case Outcome::Status::kInterrupted:
      record_->events.Add(mind::CommandEnded{command, mind::CommandStatus::kInterrupted, {}});
      return;
    case Outcome::Status::kError:
      record_->events.Add(mind::CommandEnded{command, mind::CommandStatus::kError, outcome.reason});
      return;
  }
}

void SoarMind::Answer(const Outcome& outcome) {
  const auto at = FindStanding(outcome.tag);
  if (!Stands(at, outcome.tag)) return;
  sml::Identifier* found = FindWord(*at);
  if (found == nullptr) return;
  sml::Identifier& word = *found;
  if (is_logged_) NoteOutcome(word.GetAttribute(), outcome);
  switch (outcome.status) {
    case Outcome::Status::kProgress:
      if (at->progress == nullptr) {
        at->progress = word.CreateFloatWME("progress", static_cast<double>(outcome.progress));
      } else {
        agent_->Update(at->progress, static_cast<double>(outcome.progress));
      }
      break;
    case Outcome::Status::kComplete:
      word.AddStatusComplete();
      break;
    case Outcome::Status::kInterrupted:
      word.CreateStringWME("status", "interrupted");
      break;
    case Outcome::Status::kError:
      word.AddStatusError();
      word.CreateStringWME("reason", outcome.reason.c_str());
      if (!outcome.parameter.empty()) word.CreateStringWME("parameter", outcome.parameter.c_str());
      break;
  }
}

std::vector<mind::RuleOutput::Failure> SoarMind::TakeFailures() {
  return std::exchange(output_->failures, {});
}

std::vector<std::string> SoarMind::TakeWritten() {
  std::vector<std::string> lines;
  std::string& text = output_->text;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    std::string line = text.substr(begin, end == std::string::npos ? end : end - begin);
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(std::move(line));
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  text.clear();
  return lines;
}

bool SoarMind::Halted() const {
  return agent_->GetRunState() == sml::sml_RUNSTATE_HALTED;
}

std::string_view SoarMind::Breakdown() const {
  // The client API returns only text: this is the output of `run` (cli/run_text.cpp).
  constexpr std::string_view kBeforeCause = "The agent ran out of memory: ";
  const std::size_t begin = answer_.find(kBeforeCause);
  if (begin == std::string::npos) return {};
  const std::string_view cause = std::string_view(answer_).substr(begin + kBeforeCause.size());
  return cause.substr(0, cause.find_last_not_of(".\n") + 1);
}

#ifdef SOARBOX_OWN_KERNEL
std::size_t SoarMind::MemoryBytes() const {
  return MindMemoryBytes(*agent_);
}

std::size_t SoarMind::LearnedRules() const {
  return MindLearnedRules(*agent_);
}

std::string SoarMind::MostLearnedFrom() const {
  const LearnedSource most = MindLearnedFrom(*agent_);
  return std::to_string(most.count) + " of them from '" + most.rule + "'";
}

std::string SoarMind::BusiestRule() const {
  const BusyRule busiest = MindBusiestRule(*agent_);
  return "'" + busiest.rule + "', which has fired " + std::to_string(busiest.firings) + " times";
}

void SoarMind::AllowMatches(std::uint64_t most) {
  // Rounded to powers of two, so that the limit changes rarely.
  const auto rounded = static_cast<std::uint32_t>(std::bit_ceil(std::clamp<std::uint64_t>(most, 1, 1u << 30)));
  if (rounded == match_limit_) return;
  const std::uint32_t present = MindMatchLimit(*agent_);
  if (match_limit_ == 0 || present != std::min(match_limit_, own_match_limit_)) own_match_limit_ = present;
  match_limit_ = rounded;
  if (const std::uint32_t allowed = std::min(rounded, own_match_limit_); allowed != present)
    SetMindMatchLimit(*agent_, allowed);
}

void SoarMind::AllowMemory(std::size_t bytes) {
  // Rounded to a power of two, so that the limit changes rarely.
  constexpr std::size_t kLargest = std::numeric_limits<std::size_t>::max() / 2 + 1;
  const std::size_t rounded = std::bit_ceil(std::clamp<std::size_t>(bytes, 1, kLargest));
  if (rounded != std::exchange(memory_limit_, rounded)) SetMindMemoryLimit(*agent_, rounded);
}
#else
std::size_t SoarMind::MemoryBytes() const {
  return 0;
}
std::size_t SoarMind::LearnedRules() const {
  return 0;
}
std::string SoarMind::MostLearnedFrom() const {
  return {};
}
std::string SoarMind::BusiestRule() const {
  return {};
}
void SoarMind::AllowMatches(std::uint64_t) {}
void SoarMind::AllowMemory(std::size_t) {}
#endif

void SoarMind::Forget() {
  observations_.reset();
  link_->Close();
  standing_.clear();
  commands_.clear();
  withdrawn_.clear();
}

void SoarMind::Restart() {
  agent_->Commit();
  agent_->InitSoar();
}

}  // namespace soarbox::sim
