// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_machine.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <lua.hpp>
#include <utility>

#include "script/lua_library.h"
#include "script/script_observer.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

constexpr std::uint64_t kCountInterval = 1000;
/// Bytes cleared or copied in the time of one instruction.
constexpr std::size_t kBytesPerInstruction = 64;
/// Minimum cost of a call.
constexpr std::uint64_t kCallPrice = 100;
/// Minimum growth of a machine before its garbage is collected.
constexpr std::size_t kLeastGrowth_bytes = std::size_t{32} << 10;
/// Bytes that a collection visits in the time of one instruction.
constexpr std::size_t kCollectedBytesPerInstruction = 4;
/// Size of a line of the processor's cache.
constexpr std::size_t kLine_bytes = 64;

std::atomic<bool> interrupted{false};

int MaskOf(ScriptObserver::Wants wants) {
  return (wants.lines ? LUA_MASKLINE : 0) | (wants.calls ? LUA_MASKCALL | LUA_MASKRET : 0);
}

}  // namespace

LuaMachine::LuaMachine(MachineSetup setup)
    : setup_(std::move(setup)), memory_(setup_.limits.memory_bytes, setup_.world) {
  assert(setup_.path && setup_.random && setup_.print);
  state_ = lua_newstate(Allocate, this);
  if (!state_) return;
  luaJIT_setmode(state_, 0, LUAJIT_MODE_ENGINE | LUAJIT_MODE_OFF);
  // Everything below may run out of memory, so it runs protected. Nothing can run without these two functions.
  const int status = lua_cpcall(
      state_,
      [](lua_State* state) {
        LuaMachine& machine = Of(state);
        lua_pushcfunction(state, RunBody);
        machine.run_body_ = machine.Keep(-1);
        lua_pushcfunction(state, OnError);
        machine.on_error_ = machine.Keep(-1);
        InstallLibrary(state);
        return 0;
      },
      nullptr);
  if (status != 0) {
    lua_close(state_);
    state_ = nullptr;
    return;
  }
  lua_gc(state_, LUA_GCSTOP, 0);
  SetCollectionPoint();
  if (setup_.observer != nullptr) setup_.observer->OnMachine(*this);
}

LuaMachine::~LuaMachine() {
  if (state_) lua_close(state_);
}

void LuaMachine::FetchSelf() const {
  // Everything except the free lists of large blocks, which are seldom used.
  const auto* begin = reinterpret_cast<const std::byte*>(this);
  const auto* end = begin + sizeof *this;
  for (const auto* line = begin; line < begin + 6 * kLine_bytes; line += kLine_bytes) __builtin_prefetch(line);
  for (const auto* line = reinterpret_cast<const std::byte*>(&state_); line < end; line += kLine_bytes)
    __builtin_prefetch(line);
}

void LuaMachine::FetchState() const {
  // The state, followed by the data that all coroutines of a machine share.
  const auto* begin = reinterpret_cast<const std::byte*>(state_);
  for (std::size_t line = 0; line < 14; ++line) __builtin_prefetch(begin + line * kLine_bytes);
  if (!names_.empty()) __builtin_prefetch(names_.data());
}

void* LuaMachine::Allocate(void* machine, void* block, std::size_t old_size, std::size_t new_size) {
  LuaMachine& self = *static_cast<LuaMachine*>(machine);
  if (new_size > old_size) self.Charge((new_size - old_size) / kBytesPerInstruction);
  void* const allocated = self.memory_.Reallocate(block, old_size, new_size);
  const bool is_due = self.memory_.used_bytes() >= self.collect_at_bytes_ || self.memory_.TakeNearRefusal();
  if (self.collect_at_bytes_ != 0 && is_due && !self.collection_due_) {
    self.collection_due_ = true;
    self.SetHook(self.state_, 1);
  }
  return allocated;
}

void LuaMachine::CollectGarbage() {
  memory_.BeginCollection();
  lua_gc(state_, LUA_GCCOLLECT, 0);
  memory_.EndCollection();
  // A collection restarts Lua's own collector.
  lua_gc(state_, LUA_GCSTOP, 0);
  // The pending collection is done: instructions are counted as before.
  if (collection_due_) SetHook(state_, instructions_left_ > 0 ? kCountInterval : 1);
  SetCollectionPoint();
}

void LuaMachine::SetCollectionPoint() {
  // Near the limit the next collection comes sooner, so that a script does not fail because of garbage. Growth pays for
  // visiting as many bytes; the rest of a collection is charged.
  const std::size_t used = memory_.used_bytes();
  const std::size_t room = memory_.limit_bytes() - std::min(used, memory_.limit_bytes());
  const std::size_t growth = std::max(std::min(used, room / 2), kLeastGrowth_bytes);
  collect_at_bytes_ = used + growth;
  collection_price_ = (used - std::min(used, growth)) / kCollectedBytesPerInstruction;
  collection_due_ = false;
}

LuaMachine& LuaMachine::Of(lua_State* state) {
  void* machine = nullptr;
  lua_getallocf(state, &machine);
  return *static_cast<LuaMachine*>(machine);
}

std::optional<ScriptError> LuaMachine::RunFile(std::string_view name) {
  const Result<const ScriptSource*> source = path().Load(name);
  if (!source.ok()) return ScriptError{source.error(), {}};
  NoteFile(name);
  return Protected([&](lua_State* state) { RunSource(state, *source.value(), name); });
}

void LuaMachine::NoteFile(std::string_view name) {
  if (std::find(files_.begin(), files_.end(), name) != files_.end()) return;
  files_.emplace_back(name);
  if (setup_.observer != nullptr) UpdateHooks();
}

std::optional<ScriptError> LuaMachine::RunText(std::string_view text, std::string_view name) {
  return Protected([&](lua_State* state) { RunChunk(state, text, name); });
}

std::optional<ScriptError> LuaMachine::RunProtected(RawBody body, void* data) {
  if (!state_) {
    Diagnostic error;
    error.file = script();
    error.message =
        "not enough memory to start a Lua machine: the limit is " + std::to_string(memory_.limit_bytes() >> 10) + " KB";
    return ScriptError{std::move(error), {}};
  }
  if (setup_.world && setup_.world->end()) return std::nullopt;
  const RawBody outer_body = std::exchange(body_, body);
  void* const outer_data = std::exchange(body_data_, data);
  if (depth_++ == 0) {
    ArmBudget();
    loading_.clear();
  }
  const int top = lua_gettop(state_);
  lua_rawgeti(state_, LUA_REGISTRYINDEX, on_error_);
  lua_rawgeti(state_, LUA_REGISTRYINDEX, run_body_);
  const int status = lua_pcall(state_, 0, 0, top + 1);
  std::optional<ScriptError> error;
  if (status != 0) error = TakeError(status);
  lua_settop(state_, top);
  if (--depth_ == 0) {
    if (setup_.world) setup_.world->UseInstructions(armed_ - instructions_left_ + kCallPrice);
    if (setup_.observer != nullptr) setup_.observer->OnEnd(*this);
  }
  body_ = outer_body;
  body_data_ = outer_data;
  return error;
}

ScriptError LuaMachine::TakeError(int status) {
  std::optional<ScriptError> error;
  error_.swap(error);
  if (status == LUA_ERRMEM) {
    error = ScriptError{};
    error->diagnostic.file = path().PathOf(script());
    error->diagnostic.message =
        memory_.world_refused()
            ? "the script needs more than its share of this world's memory, an eighth of what is left: of " +
                  std::to_string(setup_.world->limits().memory_bytes >> 20) + " MB, scripts have taken " +
                  std::to_string(setup_.world->used_bytes() >> 20) + " MB, and minds and bodies " +
                  std::to_string(setup_.world->other_bytes() >> 20) + " MB; --memory gives it more"
            : "the script needs more than its limit of " + std::to_string(memory_.limit_bytes() >> 10) +
                  " KB of memory";
    // The data of the failed call are garbage now; without a collection the next call would fail at once.
    CollectGarbage();
    memory_.ReleaseFreeChunks();
  } else if (!error) {
    const char* message = lua_tostring(state_, -1);
    error = DescribeMessage(message ? message : "unknown error", script(), path());
  }
  return std::move(*error);
}

void LuaMachine::ArmBudget() {
  armed_ = setup_.limits.instructions;
  if (setup_.world) armed_ = std::min(armed_, setup_.world->InstructionsForCall());
  world_bound_ = armed_ < setup_.limits.instructions;
  instructions_left_ = armed_;
  nested_calls_ = 0;
  ignored_.second = 0;
  if (setup_.observer != nullptr) observed_events_ = MaskOf(setup_.observer->WantsOf(*this));
  SetHook(state_, collection_due_ ? 1 : kCountInterval);
}

void LuaMachine::SetHook(lua_State* state, int count) const {
  lua_sethook(state, OnHook, LUA_MASKCOUNT | observed_events_, count);
}

void LuaMachine::Observe(ScriptObserver* observer) {
  setup_.observer = observer;
  if (observer != nullptr) observer->OnMachine(*this);
  UpdateHooks();
}

void LuaMachine::UpdateHooks() {
  const int wanted = setup_.observer == nullptr ? 0 : MaskOf(setup_.observer->WantsOf(*this));
  if (wanted == observed_events_) return;
  observed_events_ = wanted;
  // Nothing runs between two calls: the next call sets the hook.
  if (depth_ > 0) SetHookAgain();
}

void LuaMachine::SetHookAgain() {
  // The count restarts. The count since the last hook is not known, and a script must not gain by this.
  Charge(kCountInterval);
  SetHook(state_, instructions_left_ > 0 && !collection_due_ ? kCountInterval : 1);
}

LuaMachine::OwnBudget::OwnBudget(LuaMachine& machine, std::uint64_t instructions)
    : machine_(machine),
      left_(machine.instructions_left_),
      armed_(machine.armed_),
      was_paused_(std::exchange(machine.is_paused_, true)) {
  machine.instructions_left_ = machine.armed_ = instructions;
}

LuaMachine::OwnBudget::~OwnBudget() {
  const bool ran_out = machine_.instructions_left_ == 0;
  machine_.instructions_left_ = left_;
  machine_.armed_ = armed_;
  machine_.is_paused_ = was_paused_;
  if (ran_out) machine_.SetHookAgain();
}

void LuaMachine::OnHook(lua_State* state, lua_Debug* frame) {
  LuaMachine& machine = Of(state);
  if (frame->event == LUA_HOOKCOUNT) return machine.OnCount(state);
  if (machine.setup_.observer == nullptr) return;
  if (frame->event == LUA_HOOKLINE) {
    machine.setup_.observer->OnLine(machine, state, *frame);
  } else if (frame->event == LUA_HOOKCALL) {
    machine.setup_.observer->OnCall(machine, state, *frame);
  } else {
    machine.setup_.observer->OnReturn(machine, state, *frame);
  }
}

void LuaMachine::OnCount(lua_State* state) {
  if (collection_due_) {
    // The count since the last hook is not known; charge half an interval, the expected value.
    Charge(kCountInterval / 2 + collection_price_);
    CollectGarbage();
  }
  if (instructions_left_ > kCountInterval && !interrupted.load(std::memory_order_relaxed)) {
    instructions_left_ -= kCountInterval;
    return;
  }
  RaiseOutOfBudget(state);
}

void LuaMachine::RaiseOutOfBudget(lua_State* state) {
  instructions_left_ = 0;
  // From here on every instruction fails, so that a script cannot catch the error with pcall and continue.
  lua_sethook(state, OnHook, LUA_MASKCOUNT, 1);
  if (interrupted.load(std::memory_order_relaxed)) {
    lua_pushliteral(state, "the run is being ended");
    lua_error(state);
  }
  if (setup_.world && setup_.world->end()) {
    lua_pushliteral(state, "the scripts are ended");
    lua_error(state);
  }
  if (world_bound_) {
    lua_pushfstring(
        state,
        "the script was stopped after %d instructions: one call may use a tenth of what all scripts of this world "
        "have left in this step",
        static_cast<int>(armed_));
    lua_error(state);
  }
  lua_pushfstring(state, "the script ran for more than %d thousand instructions in one call: is there an endless loop?",
                  static_cast<int>(setup_.limits.instructions / 1000));
  lua_error(state);
}

void LuaMachine::InterruptAll() {
  interrupted.store(true, std::memory_order_relaxed);
}

bool LuaMachine::Interrupted() {
  return interrupted.load(std::memory_order_relaxed);
}

int LuaMachine::RunBody(lua_State* state) {
  LuaMachine& machine = Of(state);
  luaL_checkstack(state, 40, "too many nested calls");
  machine.body_(state, machine.body_data_);
  return 0;
}

int LuaMachine::OnError(lua_State* state) {
  LuaMachine& machine = Of(state);
  machine.error_ = DescribeError(state, machine.path());
  Diagnostic& told = machine.error_->diagnostic;
  if (machine.ignored_.second > 0 && told.message.find("nil value") != std::string::npos)
    told.hint = "a call in " + machine.ignored_.first + ":" + std::to_string(machine.ignored_.second) +
                " was ignored, so it returned nil; see the warning about it";
  if (machine.setup_.observer != nullptr) machine.setup_.observer->OnError(machine, state);
  return 1;
}

bool LuaMachine::PushGlobalFunction(lua_State* state, const char* name) {
  // A few names are used repeatedly: their strings are kept, so that they need not be interned each time.
  auto known = std::find_if(names_.begin(), names_.end(), [&](const auto& entry) { return entry.first == name; });
  if (known == names_.end()) {
    lua_pushstring(state, name);
    const int text = luaL_ref(state, LUA_REGISTRYINDEX);
    known = names_.insert(names_.end(), {name, text});
  }
  lua_rawgeti(state, LUA_REGISTRYINDEX, known->second);
  lua_gettable(state, LUA_GLOBALSINDEX);
  if (lua_isfunction(state, -1)) return true;
  lua_pop(state, 1);
  return false;
}

void LuaMachine::PushKept(lua_State* state, int reference) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
}

void LuaMachine::Call(lua_State* state, int argument_count, int result_count) {
  lua_call(state, argument_count, result_count);
}

int LuaMachine::Keep(int index) {
  lua_pushvalue(state_, index);
  return luaL_ref(state_, LUA_REGISTRYINDEX);
}

void LuaMachine::Release(int reference) {
  if (state_) luaL_unref(state_, LUA_REGISTRYINDEX, reference);
}

}  // namespace soarbox::script
