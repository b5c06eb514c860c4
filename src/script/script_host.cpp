// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_host.h"

#include <algorithm>
#include <lua.hpp>

#include "model/model.h"
#include "script/bind_api.h"
#include "script/check_names.h"
#include "script/collision_callbacks.h"
#include "script/keep_state.h"
#include "script/lua_library.h"
#include "script/lua_text.h"
#include "script/lua_values.h"
#include "script/script_observer.h"
#include "world/state_hash.h"

namespace soarbox::script {
namespace {

using world::EntityId;

/// Maximum depth of agents whose initialisation creates agents.
constexpr int kMaxCreationDepth = 16;

/// Makes a random stream of the world available to a machine.
class WorldRandom final : public RandomSource {
 public:
  WorldRandom(world::RandomStream& stream, std::uint64_t seed, std::uint64_t number)
      : stream_(stream), seed_(seed), number_(number) {}

  double Unit() override { return stream_.UnitDouble(); }
  void Reseed(std::int64_t number) override {
    world::StateHash mixed;
    mixed.Add(seed_);
    mixed.Add(number_);
    mixed.Add(static_cast<std::uint64_t>(number));
    stream_.Reseed(mixed.value());
  }

 private:
  world::RandomStream& stream_;
  std::uint64_t seed_, number_;
};

std::string StemOf(const AgentCreationRequest& request) {
  if (request.kind == "seeking") return "seeker";
  if (request.kind == "follower" || request.kind == "waypoint") return request.kind;
  if (request.kind == "soar") return "agent";
  std::string stem = request.script.substr(0, request.script.rfind(".lua"));
  return stem.empty() ? "agent" : stem;
}

void PushInput(lua_State* state, const InputEvent& event, const world::World& world) {
  lua_createtable(state, 0, 9);
  const auto set_number = [&](const char* name, double value) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
  };
  const auto set_text = [&](const char* name, const std::string& value) {
    lua_pushlstring(state, value.data(), value.size());
    lua_setfield(state, -2, name);
  };
  const bool is_key = event.source == InputEvent::Source::kKeyboard;
  const bool is_pad = event.source == InputEvent::Source::kGamepad;
  set_text("source", is_key ? "keyboard" : is_pad ? "gamepad" : "mouse");
  if (is_key) set_text("key", event.key);
  if (!event.button.empty()) set_text("button", event.button);
  if (is_key || !event.button.empty()) {
    lua_pushboolean(state, event.pressed);
    lua_setfield(state, -2, "pressed");
  }
  if (is_pad) {
    set_number("pad", event.pad);
    if (!event.axis.empty()) set_text("axis", event.axis);
    if (!event.axis.empty()) set_number("value", event.value);
  }
  if (is_key || is_pad) return;
  set_number("width", world.screen_width());
  set_number("height", world.screen_height());
  set_number("x", event.x);
  set_number("y", event.y);
  set_number("dx", event.dx);
  set_number("dy", event.dy);
  set_number("wheel", event.wheel);
}

/// What to write instead of the option looks beside a script.
std::string HintForLooks(const std::string& script, const std::variant<bool, double, std::string>& value) {
  const std::string* name = std::get_if<std::string>(&value);
  const bool is_model = name != nullptr && model::IsModelName(*name);
  const std::string place = ", and write in Agent_Initialize of " + script + ": ";
  if (is_model) return "leave it out" + place + "Core.CreateMesh(agent, \"" + *name + "\")";
  return "leave it out" + place +
         "local body = Core.CreateCapsule(agent, 1.6, 0.3), and Core.SetMaterial(body, \"Soarbox/Sheep\") or another "
         "material of docs/lua/names.md";
}

}  // namespace

namespace {
thread_local ScriptObserver* observer_of_new_hosts = nullptr;
}  // namespace

ObserveNewHosts::ObserveNewHosts(ScriptObserver* observer) : before_(observer_of_new_hosts) {
  observer_of_new_hosts = observer;
}

ObserveNewHosts::~ObserveNewHosts() {
  observer_of_new_hosts = before_;
}

ScriptObserver* ObserveNewHosts::Current() {
  return observer_of_new_hosts;
}

void SetGlobalUnlessThere(lua_State* state, const char* name, Handle handle) {
  lua_getglobal(state, name);
  const bool is_there = !lua_isnil(state, -1);
  lua_pop(state, 1);
  if (is_there) return;
  PushHandle(state, handle);
  lua_setglobal(state, name);
}

/// Runs a text that a user typed. The values of an expression become the answer.
std::optional<ScriptError> RunTyped(LuaMachine& machine, std::string_view text, std::string* answer) {
  return machine.Protected([&](lua_State* state) {
    SetGlobalUnlessThere(state, "sandbox", {ValueKind::kSandbox, 0});
    if (machine.owner() != 0) SetGlobalUnlessThere(state, "agent", {ValueKind::kAgent, machine.owner()});
    // The text is an argument of a call, so that its own line is known if it fails.
    const std::string expression = "return (function(...) return ... end)(" + std::string(text) + "\n)";
    if (answer == nullptr || luaL_loadbufferx(state, expression.data(), expression.size(), "@console", "t") != 0) {
      RunChunk(state, text, "console");
      return;
    }
    const int function = lua_gettop(state);
    lua_call(state, 0, LUA_MULTRET);
    const int last = lua_gettop(state);
    for (int i = function; i <= last; ++i) {
      PushText(state, i);
      *answer += std::string(i == function ? "" : "\t") + lua_tostring(state, -1);
      lua_pop(state, 1);
    }
  });
}

/// An agent's script: its machine lives until the agent is removed, and its callbacks with it.
struct ScriptHost::AgentScript {
  EntityId id;
  AgentCreationRequest request;
  std::unique_ptr<RandomSource> random;
  std::unique_ptr<LuaMachine> machine;
  bool runs = false;                           ///< Its chunk has run, and the agent has not been stopped.
  std::map<std::uint64_t, int> commands = {};  ///< Running commands by tag, with the references of their parameters.
  std::size_t files_looked_at = 0;             ///< Number of its files that `ticks` covers.
  bool ticks = false;                          ///< One of them contains the name Agent_Tick.
  bool senses = true;                          ///< May have a function Agent_Sense.
};

ScriptHost::ScriptHost(world::World& world, ScriptHostSettings settings, MindFactory* minds, ScriptListener& listener)
    : world_(world),
      observer_(ObserveNewHosts::Current()),
      settings_(std::move(settings)),
      minds_(minds),
      path_(settings_.script_folders),
      budget_(settings_.world_limits),
      reporter_(listener, budget_),
      context_{world, reporter_, *this, budget_} {
  if (observer_ != nullptr) observer_->OnWorld();
}

ScriptHost::~ScriptHost() = default;

std::unique_ptr<LuaMachine> ScriptHost::MakeMachine(std::string_view script, EntityId owner, MachineLimits limits,
                                                    RandomSource& random) {
  return std::make_unique<LuaMachine>(MachineSetup{std::string(script), Number(owner), limits, &path_, &random,
                                                   &reporter_, &budget_, &context_, observer_});
}

void ObserveScripts(ScriptHost& host, ScriptObserver* observer) {
  // The previous observer must not keep machines that it no longer hears of.
  if (host.observer_ != nullptr) host.observer_->OnWorld();
  host.observer_ = observer;
  if (observer != nullptr) observer->OnWorld();
  const auto observe = [&](LuaMachine& machine) { machine.Observe(observer); };
  if (host.sandbox_) observe(*host.sandbox_);
  for (const auto& script : host.agents_)
    if (script->machine) observe(*script->machine);
}

bool ScriptHost::LoadSandbox(std::string_view script) {
  sandbox_random_ = std::make_unique<WorldRandom>(world_.random(), world_.settings().seed, 0);
  sandbox_ = MakeMachine(script, EntityId::kSandbox, settings_.sandbox_limits, *sandbox_random_);
  auto error = sandbox_->Protected([this](lua_State* state) {
    BindApi(state, ApiSide::kSandbox);
    lua_pushinteger(state, settings_.turn_ticks);
    lua_setglobal(state, "Sandbox_TurnTicks");
  });
  if (!error) error = sandbox_->RunFile(script);
  if (error) reporter_.FailedForGood(EntityId::kSandbox, *error);
  if (!error) WarnOfSlips(script);
  return !error || End();
}

bool ScriptHost::Initialize() {
  if (!sandbox_) return false;
  const auto error = sandbox_->CallGlobal("Sandbox_Initialize", [](lua_State* state) {
    PushSandbox(state);
    return 1;
  });
  return NoteResult(EntityId::kSandbox, "Sandbox_Initialize", error);
}

std::vector<EntityId> ScriptHost::BeginTick() {
  budget_.BeginTick();
  CountOthers();
  std::vector<EntityId> removed = world_.BeginTick([this](EntityId agent) {
    if (const AgentScript* script = Find(agent)) CleanUpAgent(*script);
  });
  for (const EntityId id : removed) {
    context_.listeners.Remove(Number(id));
    context_.collisions.Remove(Number(id));
    EndScript(id);
  }
  return removed;
}

void ScriptHost::CleanUpAgent(const AgentScript& script) {
  if (!script.runs) return;
  const auto error = script.machine->CallGlobal("Agent_Cleanup", [&](lua_State* state) {
    PushAgent(state, script.id);
    return 1;
  });
  NoteResult(script.id, "Agent_Cleanup", error);
}

void ScriptHost::EndScript(EntityId agent) {
  AgentScript* script = Find(agent);
  if (!script) return;
  LuaMachine& machine = *script->machine;
  context_.listeners.RemoveMachine(machine);
  context_.collisions.RemoveMachine(machine);
  if (machine.observer() != nullptr) machine.observer()->OnGone(machine);
  by_id_[Number(agent)] = nullptr;
  std::erase_if(agents_, [&](const auto& other) { return other.get() == script; });
}

void ScriptHost::HandleInput(const InputEvent& event) {
  if (sandbox_) {
    const auto error = sandbox_->CallGlobal("Sandbox_HandleEvent", [&](lua_State* state) {
      PushSandbox(state);
      PushInput(state, event, world_);
      return 2;
    });
    NoteResult(EntityId::kSandbox, "Sandbox_HandleEvent", error);
  }
  const std::size_t count = agents_.size();
  for (std::size_t i = 0; i < count; ++i) {
    AgentScript& script = *agents_[i];
    if (!script.runs) continue;
    const auto error = script.machine->CallGlobal("Agent_HandleEvent", [&](lua_State* state) {
      PushAgent(state, script.id);
      PushInput(state, event, world_);
      return 2;
    });
    NoteResult(script.id, "Agent_HandleEvent", error);
  }
}

bool ScriptHost::PressButton(std::string_view name) {
  const world::UiId panel = world_.ui().FindButton(name);
  if (panel == world::UiId::kNone) return false;
  if (!world_.ui().Find(panel)->view.visible) return true;
  const auto push = [](lua_State* state, Handle button) {
    PushSandbox(state);
    PushHandle(state, button);
    return 2;
  };
  context_.buttons.Call(
      Number(panel), [](const LuaMachine&) { return true; }, NoteResultsOf("the function of a button"), push);
  return true;
}

void ScriptHost::AddOrder(EntityId agent, const std::string& order) {
  ScriptEvent event{"Order", {}};
  event.fields["agent"] = Handle{ValueKind::kAgent, Number(agent)};
  event.fields["order"] = order;
  context_.events.Add(std::move(event));
}

void ScriptHost::DeliverEvents() {
  context_.events.Deliver(
      context_.listeners, [this](const LuaMachine& machine) { return MayRun(machine); },
      NoteResultsOf("the event callback"));
}

bool ScriptHost::UpdateAgent(EntityId agent, std::optional<std::string_view> command, const Table& parameters) {
  AgentScript* script = Find(agent);
  if (!script || !script->runs) return false;
  const auto error = script->machine->CallGlobal("Agent_Update", [&](lua_State* state) {
    PushAgent(state, agent);
    lua_pushinteger(state, world_.step_millis());
    if (!command) return 2;
    lua_pushlstring(state, command->data(), command->size());
    // The thesis' three kinds have no parameters, and their scripts do not expect any.
    if (parameters.empty() && script->request.kind != "soar") return 3;
    PushTable(state, parameters);
    return 4;
  });
  return NoteResult(agent, "Agent_Update", error);
}

CommandAnswer ScriptHost::AskForCommand(AgentScript& script, std::string_view command, const Table* parameters,
                                        int& kept) {
  CommandAnswer answer;
  const bool has_table =
      parameters == nullptr ? kept != LUA_NOREF : !parameters->empty() || script.request.kind == "soar";
  const auto error = script.machine->AskGlobal(
      "Agent_Update", kCommandResults,
      [&](lua_State* state) {
        const int function = lua_gettop(state);
        PushAgent(state, script.id);
        lua_pushinteger(state, world_.step_millis());
        lua_pushlstring(state, command.data(), command.size());
        // The thesis' three kinds have no parameters, and their scripts do not expect any.
        if (!has_table) return 3;
        if (parameters != nullptr) {
          PushTable(state, *parameters);
        } else {
          LuaMachine::PushKept(state, kept);
        }
        // A copy below the function, which is still on the stack after the call.
        lua_pushvalue(state, -1);
        lua_insert(state, function);
        return 4;
      },
      [&](lua_State* state) {
        answer = ReadCommandAnswer(state);
        if (answer.state != CommandAnswer::State::kRunning || !has_table || kept != LUA_NOREF) return;
        lua_pop(state, kCommandResults);
        kept = script.machine->Keep(-1);
      });
  if (!NoteResult(script.id, "Agent_Update", error)) {
    answer.state = CommandAnswer::State::kError;
    answer.reason = "script-failed";
  }
  if (!answer.unknown.empty()) {
    Diagnostic warning;
    warning.severity = Severity::kWarning;
    warning.file = path_.PathOf(script.request.script);
    warning.message = "Agent_Update returns \"" + answer.unknown + "\" for the command " + std::string(command);
    warning.hint = "it may return \"running\", \"error\" or \"complete\"; anything else counts as complete";
    reporter_.Warn(warning);
  }
  return answer;
}

CommandAnswer ScriptHost::CommandAgent(EntityId agent, std::uint64_t tag, std::string_view command,
                                       const Table& parameters) {
  AgentScript* script = Find(agent);
  if (!script || !script->runs) return {.state = CommandAnswer::State::kError, .reason = "script-failed"};
  int kept = LUA_NOREF;
  CommandAnswer answer = AskForCommand(*script, command, &parameters, kept);
  if (answer.state == CommandAnswer::State::kRunning) script->commands[tag] = kept;
  return answer;
}

CommandAnswer ScriptHost::ContinueCommand(EntityId agent, std::uint64_t tag, std::string_view command) {
  AgentScript* script = Find(agent);
  const auto known = script ? script->commands.find(tag) : decltype(script->commands.end()){};
  if (!script || !script->runs || known == script->commands.end())
    return {.state = CommandAnswer::State::kError, .reason = "script-failed"};
  CommandAnswer answer = AskForCommand(*script, command, nullptr, known->second);
  if (answer.state == CommandAnswer::State::kRunning) return answer;
  script->machine->Release(known->second);
  script->commands.erase(known);
  return answer;
}

void ScriptHost::WithdrawCommand(EntityId agent, std::uint64_t tag, std::string_view command) {
  AgentScript* script = Find(agent);
  if (!script) return;
  const auto known = script->commands.find(tag);
  if (known == script->commands.end()) return;
  const int kept = known->second;
  script->commands.erase(known);
  if (script->runs) {
    const auto error = script->machine->CallGlobal("Agent_Withdraw", [&](lua_State* state) {
      PushAgent(state, agent);
      lua_pushlstring(state, command.data(), command.size());
      if (kept == LUA_NOREF) return 2;
      LuaMachine::PushKept(state, kept);
      return 3;
    });
    NoteResult(agent, "Agent_Withdraw", error);
  }
  script->machine->Release(kept);
}

void ScriptHost::TickAgent(EntityId agent) {
  AgentScript* script = Find(agent);
  if (!script || !script->runs) return;
  // Most scripts have no such function, so the call is avoided.
  const std::vector<std::string>& files = script->machine->files();
  if (files.size() != script->files_looked_at) {
    script->files_looked_at = files.size();
    script->ticks = std::ranges::any_of(files, [&](const std::string& file) { return path_.HasTick(file); });
  }
  if (!script->ticks) return;
  const auto error = script->machine->CallGlobal("Agent_Tick", [&](lua_State* state) {
    PushAgent(state, agent);
    lua_pushinteger(state, world_.step_millis());
    return 2;
  });
  NoteResult(agent, "Agent_Tick", error);
}

void ScriptHost::Foresee(std::span<const EntityId> order, std::size_t next) const {
  const auto script_at = [&](std::size_t place) { return place < order.size() ? Find(order[place]) : nullptr; };
  if (const AgentScript* script = script_at(next + 3)) __builtin_prefetch(&script->machine);
  if (const AgentScript* script = script_at(next + 2); script && script->machine) script->machine->FetchSelf();
  if (const AgentScript* script = script_at(next + 1); script && script->machine) script->machine->FetchState();
}

std::optional<Table> ScriptHost::SenseAgent(EntityId agent) {
  AgentScript* script = Find(agent);
  if (!script || !script->runs || !script->senses) return std::nullopt;
  std::optional<Table> sensed;
  const auto error = script->machine->Protected([&](lua_State* state) {
    lua_getglobal(state, "Agent_Sense");
    script->senses = lua_isfunction(state, -1);
    if (!script->senses) return;
    PushAgent(state, agent);
    lua_call(state, 1, 1);
    if (lua_istable(state, -1)) sensed = CopyTable(state, lua_gettop(state));
  });
  NoteResult(agent, "Agent_Sense", error);
  return sensed;
}

std::optional<PerceptGraph> ScriptHost::SenseBySandbox(EntityId agent) {
  if (!sandbox_) return std::nullopt;
  std::optional<PerceptGraph> sensed;
  const auto error = sandbox_->Protected([&](lua_State* state) {
    lua_getglobal(state, "Sandbox_Sense");
    if (!lua_isfunction(state, -1)) return;
    PushSandbox(state);
    PushAgent(state, agent);
    lua_call(state, 2, 1);
    if (lua_istable(state, -1)) sensed = CopyGraph(state, lua_gettop(state));
  });
  NoteResult(EntityId::kSandbox, "Sandbox_Sense", error);
  return error ? std::nullopt : std::move(sensed);
}

GameAnswer ScriptHost::CommandBySandbox(EntityId agent, std::string_view command, const Table& parameters) {
  constexpr const char* kFailed = "script-failed";
  if (!sandbox_) return {.reason = kFailed};
  GameAnswer answer;
  const auto error = sandbox_->Protected([&](lua_State* state) {
    lua_getglobal(state, "Sandbox_Command");
    if (!lua_isfunction(state, -1)) {
      answer.reason = "unknown-command";
      return;
    }
    PushSandbox(state);
    PushAgent(state, agent);
    lua_pushlstring(state, command.data(), command.size());
    PushTable(state, parameters);
    lua_call(state, 4, 2);
    answer = ReadGameAnswer(state);
  });
  NoteResult(EntityId::kSandbox, "Sandbox_Command", error);
  if (error) return {.reason = kFailed};
  return answer;
}

void ScriptHost::HandleCollisions() {
  DeliverCollisions(
      context_.collisions, world_.Collisions(), [this](EntityId id) { return world_.FindAgent(id) != nullptr; },
      [this](const LuaMachine& machine) { return MayRun(machine); }, NoteResultsOf("the collision callback"));
  FileSensorEvents();
}

void ScriptHost::FileSensorEvents() {
  if (context_.listeners.size() == 0) return;
  for (const world::SensorChange& change : world_.SensorChanges()) {
    if (context_.events.waiting() >= settings_.world_limits.waiting_events) return;
    ScriptEvent event{change.entered ? "SensorEntered" : "SensorLeft", {}};
    const bool is_agent = world_.FindAgent(change.other) != nullptr;
    event.fields["sensor"] = Handle{ValueKind::kObject, Number(change.sensor)};
    event.fields[is_agent ? "agent" : "object"] =
        Handle{is_agent ? ValueKind::kAgent : ValueKind::kObject, Number(change.other)};
    context_.events.Add(std::move(event));
  }
}

void ScriptHost::UpdateSandbox() {
  CallSandbox("Sandbox_Update", true);
}

void ScriptHost::Cleanup() {
  for (const auto& script : agents_) CleanUpAgent(*script);
  CallSandbox("Sandbox_Cleanup", false);
}

void ScriptHost::CallSandbox(const char* function, bool with_time) {
  if (!sandbox_) return;
  const auto error = sandbox_->CallGlobal(function, [&](lua_State* state) {
    PushSandbox(state);
    if (!with_time) return 1;
    lua_pushinteger(state, world_.step_millis());
    return 2;
  });
  NoteResult(EntityId::kSandbox, function, error);
}

void ScriptHost::CountOthers() {
  const std::size_t bodies = world_.AgentIds().size() * kAgentBodyBytes + world_.ObjectIds().size() * kObjectBodyBytes;
  budget_.SetOthers(bodies + (minds_ == nullptr ? 0 : minds_->MemoryBytes()));
}

Result<EntityId> ScriptHost::MakeAgent(const AgentCreationRequest& request) {
  Diagnostic refusal;
  const bool has_script = !request.script.empty();
  if (has_script) {
    if (const auto source = path_.Load(request.script); !source.ok()) return source.error();
  }
  if (agents_.size() >= settings_.max_agents) {
    refusal.message = "there are " + std::to_string(agents_.size()) + " agents: no more can be made";
    return refusal;
  }
  CountOthers();
  if (budget_.memory_left() == 0) {
    refusal.message = "this world has no memory left for another agent: of " +
                      std::to_string(budget_.limits().memory_bytes >> 20) + " MB, scripts have taken " +
                      std::to_string(budget_.used_bytes() >> 20) + " MB, and minds and bodies " +
                      std::to_string(budget_.other_bytes() >> 20) + " MB";
    refusal.hint = "--memory gives it more";
    return refusal;
  }
  if (creation_depth_ >= kMaxCreationDepth) {
    refusal.message = "agents make agents without end: \"" + request.script + "\" is not made";
    return refusal;
  }
  if (request.HasMind() && !minds_) {
    refusal.message = "agents with Soar rules cannot be made here";
    return refusal;
  }

  world::AgentDef def;
  def.name = NameFor(request);
  def.kind = !request.HasMind() ? "lua" : request.kind == "soar" ? "soar" : "soar " + request.kind;
  def.script = request.script;
  const EntityId id = world_.CreateAgent(def);
  if (id == world::kNoEntity) {
    refusal.message = "the world cannot hold another agent";
    return refusal;
  }
  if (!has_script) {
    // A script does not control its body; the minds create the body.
    if (const Result<void> made = minds_->MakeMind(id, request); !made.ok()) {
      world_.FindAgent(id)->SetFailed(true);
      reporter_.FailedForGood(id, ScriptError{PlacedAt(request, made.error()), {}});
    }
    return id;
  }
  agents_.push_back(std::make_unique<AgentScript>());
  AgentScript& script = *agents_.back();
  script.id = id;
  if (by_id_.size() <= Number(id)) by_id_.resize(Number(id) + std::size_t{1});
  by_id_[Number(id)] = &script;
  script.request = request;
  script.random = std::make_unique<WorldRandom>(world_.FindAgent(id)->random(), world_.settings().seed, Number(id));
  script.machine = MakeMachine(request.script, id, settings_.agent_limits, *script.random);
  ++creation_depth_;
  InitializeAgent(script);
  --creation_depth_;
  return id;
}

/// The order of lua_api.md 16.2: chunk, target, Agent_Initialize, mind.
void ScriptHost::InitializeAgent(AgentScript& script) {
  auto error = script.machine->Protected([](lua_State* state) { BindApi(state, ApiSide::kAgent); });
  if (!error) error = script.machine->RunFile(script.request.script);
  if (error) {
    StopAgent(script, *error);
    return;
  }
  WarnOfSlips(script.request.script);
  script.runs = true;
  if (script.request.HasMind()) world_.FindAgent(script.id)->SetTarget({0, 0, 10});
  error = script.machine->CallGlobal("Agent_Initialize", [&](lua_State* state) {
    PushAgent(state, script.id);
    return 1;
  });
  NoteResult(script.id, "Agent_Initialize", error);
  if (!script.request.HasMind()) return;
  WarnOfBodyOptions(script.request);
  AgentCreationRequest request = script.request;
  request.options.erase("looks");  // The warning says what to write instead. A model from a file would be an error.
  if (const Result<void> made = minds_->MakeMind(script.id, request); !made.ok())
    StopAgent(script, ScriptError{PlacedAt(script.request, made.error()), {}});
}

Diagnostic ScriptHost::PlacedAt(const AgentCreationRequest& request, Diagnostic problem) const {
  if (problem.line > 0 || !problem.file.empty() || request.made_in.empty()) return problem;
  problem.file = path_.PathOf(request.made_in);
  problem.line = request.made_in_line;
  problem.excerpt = path_.LineOf(request.made_in, request.made_in_line);
  return problem;
}

void ScriptHost::WarnOfBodyOptions(const AgentCreationRequest& request) {
  for (const auto& [option, value] : request.options) {
    const bool is_of_body = option == "body" || option == "looks" || option == "material" || option == "armed" ||
                            option.starts_with("weapon.");
    if (!is_of_body) continue;
    Diagnostic warning;
    warning.severity = Severity::kWarning;
    warning.message = option + " has no effect here: " + request.script + " moves and shows the agent";
    warning.hint =
        "leave it out and let the script do it, or leave the script out: then the body knows the commands of "
        "docs/commands.md";
    if (option == "looks") warning.hint = HintForLooks(request.script, value);
    reporter_.Warn(PlacedAt(request, warning));
  }
}

void ScriptHost::WarnOfSlips(std::string_view script) {
  if (!looked_over_.emplace(script).second) return;
  const Result<const ScriptSource*> source = path_.Load(script);
  if (!source.ok()) return;
  for (const Diagnostic& slip : CheckCallbackNames(source.value()->content, source.value()->path)) reporter_.Warn(slip);
}

std::string ScriptHost::NameFor(const AgentCreationRequest& request) {
  if (const auto it = request.options.find("name"); it != request.options.end()) {
    if (const auto* name = std::get_if<std::string>(&it->second); name && !name->empty()) {
      const int count = ++names_[*name];
      return count == 1 ? *name : *name + "-" + std::to_string(count);
    }
  }
  const std::string stem = StemOf(request);
  return stem + "-" + std::to_string(++names_[stem + "-"]);
}

ScriptHost::AgentScript* ScriptHost::Find(EntityId agent) {
  return const_cast<AgentScript*>(static_cast<const ScriptHost*>(this)->Find(agent));
}

const ScriptHost::AgentScript* ScriptHost::Find(EntityId agent) const {
  return Number(agent) < by_id_.size() ? by_id_[Number(agent)] : nullptr;
}

bool ScriptHost::MayRun(const LuaMachine& machine) const {
  const AgentScript* script = Find(EntityId{machine.owner()});
  return !script || script->runs;
}

Callbacks::OnResult ScriptHost::NoteResultsOf(const char* callback) {
  return [this, callback](LuaMachine& machine, const std::optional<ScriptError>& error) {
    NoteResult(EntityId{machine.owner()}, callback, error);
  };
}

bool ScriptHost::NoteResult(EntityId agent, const char* callback, const std::optional<ScriptError>& error) {
  if (error) {
    reporter_.Failed(agent, callback, *error);
  } else {
    reporter_.Succeeded(agent, callback);
  }
  return !error;
}

void ScriptHost::StopAgent(AgentScript& script, const ScriptError& error) {
  script.runs = false;
  world_.FindAgent(script.id)->SetFailed(true);
  reporter_.FailedForGood(script.id, error);
}

bool ScriptHost::IsLuaAgent(EntityId agent) const {
  const AgentScript* script = Find(agent);
  return script && !script->request.HasMind();
}

const AgentCreationRequest* ScriptHost::RequestOf(EntityId agent) const {
  const AgentScript* script = Find(agent);
  return script ? &script->request : nullptr;
}

std::span<const std::string> ScriptHost::FilesOf(EntityId agent_or_sandbox) const {
  if (agent_or_sandbox == EntityId::kSandbox) return sandbox_ ? sandbox_->files() : std::span<const std::string>();
  const AgentScript* script = Find(agent_or_sandbox);
  return script ? script->machine->files() : std::span<const std::string>();
}

std::optional<ScriptError> ScriptHost::RunText(EntityId agent_or_sandbox, std::string_view text, std::string* answer) {
  AgentScript* script = Find(agent_or_sandbox);
  LuaMachine* machine = script                                   ? script->machine.get()
                        : agent_or_sandbox == EntityId::kSandbox ? sandbox_.get()
                                                                 : nullptr;
  if (machine) {
    const std::optional<Reload> reload = ReadReload(text);
    if (!reload) return RunTyped(*machine, text, answer);
    const std::string& file = reload->file.empty() ? machine->script() : reload->file;
    path_.Replace(file, WithoutReload(text));
    for (const auto& other : agents_) other->files_looked_at = 0;
    if (script) script->senses = true;
    const std::vector<std::string>& kept = reload->names;
    if (auto error = machine->Protected([&](lua_State* state) { CollectKept(state, kept, file); })) return error;
    std::optional<ScriptError> failed = machine->RunText(text, file);
    std::optional<ScriptError> unkept = machine->Protected([&](lua_State* state) { RestoreKept(state, kept, file); });
    return failed ? failed : unkept;
  }
  Diagnostic error;
  error.message = "no such agent: " + std::to_string(Number(agent_or_sandbox));
  return ScriptError{error, {}};
}

}  // namespace soarbox::script
