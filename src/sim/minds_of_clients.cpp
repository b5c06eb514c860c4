// SPDX-License-Identifier: BSD-2-Clause
// Minds that an external program controlled (for example, a robot in Python), replayed from the log of what it did to
// them. Their bodies stand in a row and do nothing, because their world is not known.
#include <algorithm>

#include "sim/client_percepts.h"
#include "sim/client_scene.h"
#include "sim/client_world.h"
#include "sim/minds.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_ClientLog.h"
#endif

namespace soarbox::sim {

#ifdef SOARBOX_OWN_KERNEL

namespace {

constexpr float kBetweenBodies_m = 2;
/// Their client loads their rules.
constexpr const char* kNoRules = "no_rules.soar";

std::string NameOfInputLink(sml::Agent& agent) {
  sml::Identifier* const link = agent.GetInputLink();
  return link == nullptr ? std::string() : link->GetValueAsString();
}

/// The command on the output link with this identifier; null if there is none.
sml::Identifier* CommandOf(sml::Agent& agent, std::string_view id) {
  sml::Identifier* const link = agent.GetOutputLink();
  for (int i = 0; link != nullptr && i < link->GetNumberChildren(); ++i) {
    sml::WMElement* const child = link->GetChild(i);
    sml::Identifier* const command = child == nullptr ? nullptr : child->ConvertToIdentifier();
    if (command != nullptr && command->GetValueAsString() == id) return command;
  }
  return nullptr;
}

mind::CommandStatus StatusNamed(std::string_view status) {
  if (status == "error" || status == "failed") return mind::CommandStatus::kError;
  return status == "interrupted" ? mind::CommandStatus::kInterrupted : mind::CommandStatus::kComplete;
}

bool Initializes(std::string_view line) {
  return line.starts_with("init-soar") || line.starts_with("soar init");
}

}  // namespace

std::vector<std::string> PartsOfClientLine(std::string_view line) {
  return PartsOfClientAct(line);
}

std::string ClientLine(std::initializer_list<std::string_view> parts) {
  std::string line;
  for (const std::string_view part : parts) line += (line.empty() ? "" : "\t") + EscapedForClientAct(part);
  return line;
}

void Minds::PlayClientActs() {
  if (client_acts.empty() && by_client_.empty()) return;
  const std::string acts = std::exchange(client_acts, {});
  for (std::size_t begin = 0; begin < acts.size();) {
    const std::size_t end = std::min(acts.find('\n', begin), acts.size());
    PlayClientAct(PartsOfClientAct(std::string_view(acts).substr(begin, end - begin)));
    begin = end + 1;
  }
  for (Mind& mind : minds_)
    if (mind.by_client && !mind.gone) mind.scene->Show(world_);
  for (Mind& mind : minds_) {
    if (!mind.by_client || !mind.decided || mind.gone) continue;
    const world::Agent& body = *world_.FindAgent(mind.agent);
    TellWritten(mind, body);
    TellFailures(mind, body);
    if (!TellBreakdown(mind, body) && mind.soar.Halted()) TellHalt(mind, body);
    mind.decided = false;
  }
}

void Minds::PlayClientAct(const std::vector<std::string>& parts) {
  const std::string& kind = parts.front();
  if (parts.size() < 2) return;
  if (kind == "agent") return MakeClientMind(parts[1]);
  if (kind == "attach") return AttachMind(parts[1]);
  const auto found = by_client_.find(parts[1]);
  if (found == by_client_.end()) {
    RunEvent event;
    event.kind = EventKind::kDiagnostic;
    event.diagnostic.message = "the recorded client has no agent '" + parts[1] + "'";
    return report_(std::move(event));
  }
  if (kind == "gone") return EndClientMind(parts[1]);
  Mind& mind = minds_[found->second];
  if (kind == "look") {
    // Its own program has already run the agent.
    if (mind.lost) return;
    mind.decided = true;
    mind.soar.agent().SynchronizeOutputLink();
    return ReportClientCommands(mind);
  }
  const std::string input_link = NameOfInputLink(mind.soar.agent());
  mind.scene->Note(parts, input_link);
  mind::EventLog* const log = mind.soar.is_logged() ? &mind.soar.record().events : nullptr;
  std::vector<std::string> act = parts;
  if (kind == "line" && act.size() > 2) {
    if (Initializes(act[2])) {
      mind.percepts->Clear();
      mind.scene->Clear();
    }
    act[2] = WithCopies(mind, act[2]);
  } else if (!mind.percepts->Note(act, input_link, log) && kind == "add" && act.size() > 7 && act[5] == "status") {
    if (sml::Identifier* const command = CommandOf(mind.soar.agent(), act[4])) {
      mind.last_answer = std::string(command->GetAttribute()) + " " + act[7];
      if (log != nullptr) log->Add(mind::CommandEnded{command->GetAttribute(), StatusNamed(act[7]), {}});
    }
  }
  script_rows_.insert(mind.percepts->attributes().begin(), mind.percepts->attributes().end());
  const std::string problem = soarbox::PlayClientAct(mind.soar.agent(), act);
  if (kind == "go") {
    mind.decided = true;
    NoteDecisions(mind);
    ReportClientCommands(mind);
  }
  if (problem.empty()) return;
  RunEvent event;
  event.kind = EventKind::kDiagnostic;
  event.agent = world_.FindAgent(mind.agent)->name();
  for (Diagnostic& diagnostic : ParseDiagnostics(problem, {})) {
    if (kind != "line") diagnostic.severity = Severity::kWarning;
    diagnostic.file = scenario_.Original(diagnostic.file).string();
    event.diagnostic = std::move(diagnostic);
    report_(event);
  }
}

void Minds::ReportClientCommands(Mind& mind) {
  mind.soar.Decide(true);
  world::Agent& body = *world_.FindAgent(mind.agent);
  for (const vocabulary::SaidCommand& command : mind.soar.commands()) {
    body.SetLastCommand(command.name);
    mind.last_command = command.name;
    mind.last_said = command;
    mind.last_said_s = world_.time_s();
    mind.last_answer.clear();
    RunEvent event;
    event.kind = EventKind::kCommand;
    event.agent = body.name();
    event.text = command.name;
    event.parameters = vocabulary::Describe(command.parameters);
    event.position = body.Position();
    report_(std::move(event));
  }
}

void Minds::MakeClientMind(const std::string& name) {
  // A client can create an agent with the name of one that it has destroyed.
  std::string own = name;
  for (int n = 2; FindNamed(own) != nullptr; ++n) own = name + "-" + std::to_string(n);
  world::AgentDef def;
  def.name = own;
  def.kind = "soar";
  const world::EntityId id = world_.CreateAgent(def);
  Result<SoarHost::Loaded> loaded = id == world::kNoEntity
                                        ? Result<SoarHost::Loaded>(Diagnostic{})
                                        : host_.CreateAgent(own, scenario_.definition.parent_path() / kNoRules);
  if (!loaded) {
    RunEvent event;
    event.kind = EventKind::kDiagnostic;
    event.diagnostic = loaded.error();
    if (id == world::kNoEntity) event.diagnostic.message = "the world cannot hold another agent";
    return report_(std::move(event));
  }
  AddClientMind(name, *world_.FindAgent(id), *loaded->agent, loaded->thread);
  soarbox::PlayClientAct(*loaded->agent, {"agent", name, {}});
}

void Minds::AddClientMind(const std::string& name, world::Agent& body, sml::Agent& agent, std::size_t thread) {
  body.RemovePhysics();
  body.SetPosition({kBetweenBodies_m * static_cast<float>(by_client_.size()), body.Height() / 2, 0});
  MindSettings settings;
  settings.has_distance = settings.blinks = false;
  settings.detail = detail_;
  settings.origins = records_origins_;
  const world::EntityId id = body.id();
  Mind mind{id, settings, false, true, true, true, {}, SoarMind(agent, settings), thread};
  mind.percepts = std::make_shared<ClientPercepts>();
  mind.scene = std::make_shared<ClientScene>();
  minds_.push_back(std::move(mind));
  by_client_[name] = minds_.size() - 1;
  if (place_by_id_.size() <= Number(id)) place_by_id_.resize(Number(id) + std::size_t{1});
  place_by_id_[Number(id)] = static_cast<std::uint32_t>(minds_.size());
}

void Minds::AttachMind(const std::string& name) {
  if (by_client_.contains(name)) return;
  // Without a file of rules, CreateAgent finds an existing agent of the kernel.
  const Result<SoarHost::Loaded> found = host_.CreateAgent(name, {});
  if (!found) return;
  world::AgentDef def;
  def.name = name;
  def.kind = "soar";
  const world::EntityId id = world_.CreateAgent(def);
  if (id != world::kNoEntity) AddClientMind(name, *world_.FindAgent(id), *found->agent, 0);
}

void Minds::EndClientMind(const std::string& name) {
  Mind& mind = minds_[by_client_[name]];
  Tell(EventKind::kLog, *world_.FindAgent(mind.agent), "its client destroyed it");
  mind.soar.Forget();
  mind.gone = mind.lost = true;
  mind.gone_because = "its client destroyed it";
  host_.DestroyAgent(world_.FindAgent(mind.agent)->name());
  by_client_.erase(name);
}

std::string Minds::WithCopies(Mind& mind, const std::string& line) const {
  if (!line.starts_with("source ") && !line.starts_with("load ")) return line;
  const std::size_t begin = line.find('/');
  if (begin == std::string::npos) return line;
  const char before = line[begin - 1];
  const std::size_t end = std::min(line.find(before == '{' ? '}' : before, begin), line.size());
  const std::string file = line.substr(begin, end - begin);
  for (const auto& [copy, original] : scenario_.stand_ins) {
    const std::string from = original == "/" ? "/" : original.string() + "/";
    if (!file.starts_with(from)) continue;
    const std::filesystem::path found = copy / file.substr(from.size());
    if (mind.rules.empty()) mind.rules = found;
    return line.substr(0, begin) + found.string() + line.substr(end);
  }
  return line;
}

#else

std::vector<std::string> PartsOfClientLine(std::string_view line) {
  return {std::string(line)};
}

std::string ClientLine(std::initializer_list<std::string_view>) {
  return {};
}

void Minds::PlayClientActs() {
  if (client_acts.empty()) return;
  client_acts.clear();
  RunEvent event;
  event.kind = EventKind::kDiagnostic;
  event.diagnostic.message = "only Soarbox's own kernel plays what a client recorded";
  report_(std::move(event));
}

#endif

}  // namespace soarbox::sim
