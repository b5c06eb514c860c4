// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "script/agent_lists.h"
#include "script/script_error.h"
#include "script/script_memory.h"
#include "script/world_budget.h"

struct lua_State;
struct lua_Debug;

namespace soarbox::script {

class ScriptHost;
class ScriptObserver;
class ScriptPath;
struct ScriptContext;

/// Limits of a machine.
struct MachineLimits {
  std::size_t memory_bytes = std::size_t{64} << 20;
  /// Virtual-machine instructions per call from outside (one Agent_Update, one chunk, ...). A script that exceeds them
  /// is stopped with an error. Instructions are counted, not timed, so that a run ends in the same way on a slow
  /// computer.
  std::uint64_t instructions = 50'000'000;
};

/// The random numbers of math.random in one machine.
class RandomSource {
 public:
  virtual ~RandomSource() = default;
  /// [0, 1)
  virtual double Unit() = 0;
  /// Restarts the stream at a position that the number and the run's seed determine.
  virtual void Reseed(std::int64_t number) = 0;
};

/// Receives the output of print.
class PrintSink {
 public:
  virtual ~PrintSink() = default;
  /// `script` is the main script of the machine that prints.
  virtual void OnPrint(std::string_view script, std::string_view text) = 0;
};

/// The settings of a machine. All objects that it points to must outlive the machine.
struct MachineSetup {
  std::string script;       ///< Its main script's file name, for messages.
  std::uint32_t owner = 0;  ///< Number of the agent that it belongs to; 0: the sandbox.
  MachineLimits limits;
  ScriptPath* path = nullptr;  ///< For chunks and require.
  RandomSource* random = nullptr;
  PrintSink* print = nullptr;
  WorldBudget* world = nullptr;        ///< What all machines may use together; null: no limit.
  ScriptContext* context = nullptr;    ///< The context of the sandbox's API; null for machines without the API.
  ScriptObserver* observer = nullptr;  ///< Observes what the machine executes; null: none.
};

/// One Lua machine: LuaJIT with the language of Lua 5.1 and limits on memory and instructions. It has a stable
/// iteration order and seeded random numbers. The parts of the standard library that reach outside are missing: io,
/// most of os, debug, ffi, bytecode.
///
/// The just-in-time compiler is off. Compiled loops do not count instructions, so an endless loop could not be stopped.
/// Which code is compiled depends on more than the script. The interpreter alone is deterministic.
///
/// Garbage collection is deterministic as well, because the machine decides when it runs. It runs completely, at the
/// first instruction after the memory has doubled since the last collection; near the limit, earlier (see
/// SetCollectionPoint). Lua's own collector works in small steps, in the order of a hash that differs from process to
/// process. With it, the memory of a script at a given moment would differ too, and it would reach a limit at another
/// moment.
///
/// All Lua code runs in protected calls, which return errors as values. Use it on one thread at a time.
class LuaMachine {
 public:
  explicit LuaMachine(MachineSetup setup);
  ~LuaMachine();
  LuaMachine(const LuaMachine&) = delete;
  LuaMachine& operator=(const LuaMachine&) = delete;

  /// Prefetches the memory that a call uses first: that of this object, then that of its Lua state. Other machines of a
  /// crowd are called between these two and the call, so the call does not wait for memory.
  void FetchSelf() const;
  void FetchState() const;

  /// Returns the machine of a Lua state.
  static LuaMachine& Of(lua_State* state);

  /// Loads and runs a script file of the search path.
  std::optional<ScriptError> RunFile(std::string_view name);
  /// Runs a text as the chunk `name`.
  std::optional<ScriptError> RunText(std::string_view text, std::string_view name);

  /// Runs body(lua_State*) protected and with a fresh instruction budget (a nested run shares the outer one's). Returns
  /// the error, if there was one. If the scripts of the world were ended (WorldBudget::end), runs nothing and returns
  /// no error.
  template <class Body>
  std::optional<ScriptError> Protected(Body&& body) {
    using Plain = std::remove_reference_t<Body>;
    return RunProtected([](lua_State* state, void* data) { (*static_cast<Plain*>(data))(state); },
                        const_cast<void*>(static_cast<const void*>(&body)));
  }

  /// Calls the global function `name` (a literal) with arguments. `push(lua_State*)` pushes the arguments and returns
  /// their number. Does nothing if there is no such function; `called`, if given, says whether it exists.
  template <class Push>
  std::optional<ScriptError> CallGlobal(const char* name, Push&& push, bool* called = nullptr) {
    return Protected([&](lua_State* state) {
      const bool found = Of(state).PushGlobalFunction(state, name);
      if (called) *called = found;
      if (found) Call(state, push(state));
    });
  }

  /// The same with results: `read(lua_State*)` finds `results` values on top of the stack. It is not called if there is
  /// no such function.
  template <class Push, class Read>
  std::optional<ScriptError> AskGlobal(const char* name, int results, Push&& push, Read&& read) {
    return Protected([&](lua_State* state) {
      if (!Of(state).PushGlobalFunction(state, name)) return;
      Call(state, push(state), results);
      read(state);
    });
  }

  /// Calls a function that Keep() has kept.
  template <class Push>
  std::optional<ScriptError> CallKept(int reference, Push&& push) {
    return Protected([&](lua_State* state) {
      PushKept(state, reference);
      Call(state, push(state));
    });
  }
  /// Keeps the value at `index` alive; only inside a protected call.
  int Keep(int index);
  void Release(int reference);
  static void PushKept(lua_State* state, int reference);

  /// Charges the budget of the current call for work done on a script's behalf.
  void Charge(std::uint64_t instructions) {
    instructions_left_ -= instructions < instructions_left_ ? instructions : instructions_left_;
  }
  /// The same, but ends the call at once if nothing is left. For work that takes long by itself.
  void ChargeOrRaise(lua_State* state, std::uint64_t instructions) {
    Charge(instructions);
    if (instructions_left_ == 0) RaiseOutOfBudget(state);
  }
  std::uint64_t instructions_left() const { return instructions_left_; }
  /// Raises the Lua error that ends a call without budget.
  void RaiseOutOfBudget(lua_State* state);

  /// Frees everything that is not referenced.
  void CollectGarbage();

  /// While such an object exists, built-in functions may be called from a Lua hook, where instructions are not counted.
  /// The budget of the current call is not changed; these functions use at most `instructions` of their own.
  /// Wrong arguments of API functions are not reported, because they are the user's, not the script's.
  class OwnBudget {
   public:
    OwnBudget(LuaMachine& machine, std::uint64_t instructions);
    ~OwnBudget();
    OwnBudget(const OwnBudget&) = delete;
    OwnBudget& operator=(const OwnBudget&) = delete;

   private:
    LuaMachine& machine_;
    std::uint64_t left_, armed_;
    bool was_paused_;
  };

  /// Makes all current and later calls in all machines end with an error as soon as possible, because the process is
  /// about to end. May be called from a signal handler.
  static void InterruptAll();
  static bool Interrupted();

  /// Marks a module as being loaded by require; false if it already is.
  bool BeginLoading(const std::string& module) { return loading_.insert(module).second; }
  void EndLoading(const std::string& module) { loading_.erase(module); }

  /// Notes that this machine runs a file of the search path.
  void NoteFile(std::string_view name);
  /// The files that it has run, in the order of their first run: the main script and those loaded with require.
  const std::vector<std::string>& files() const { return files_; }

  const std::string& script() const { return setup_.script; }
  std::uint32_t owner() const { return setup_.owner; }
  ScriptContext* context() const { return setup_.context; }
  ScriptPath& path() const { return *setup_.path; }
  RandomSource& random() const { return *setup_.random; }
  PrintSink& print() const { return *setup_.print; }
  WorldBudget* world() const { return setup_.world; }

  /// References to values of the sandbox's API (lua_values.cpp): looking up a number is faster than looking up a name.
  struct ValueReferences {
    std::array<int, 7> metatables{};  ///< By ValueKind.
    int agent_handles = 0;
    int own_handle = 0;  ///< Of the machine's own agent; 0: not created yet.
  };
  ValueReferences values;
  AgentLists agent_lists;
  ScriptMemory& memory() { return memory_; }
  const ScriptMemory& memory() const { return memory_; }

 private:
  friend class NestedCall;
  friend class ScriptDebugger;
  friend class ScriptHost;
  friend void ObserveScripts(ScriptHost& host, ScriptObserver* observer);
  friend void WarnAtCallerOnce(lua_State* state, std::string message, std::string_view subject);
  friend void WarnIgnored(lua_State* state, const char* why);
  using RawBody = void (*)(lua_State*, void*);

  std::optional<ScriptError> RunProtected(RawBody body, void* data);
  ScriptError TakeError(int status);
  void ArmBudget();
  void SetCollectionPoint();
  static void* Allocate(void* machine, void* block, std::size_t old_size, std::size_t new_size);
  bool PushGlobalFunction(lua_State* state, const char* name);
  static void Call(lua_State* state, int argument_count, int result_count = 0);
  static int RunBody(lua_State* state);
  static int OnError(lua_State* state);
  void SetHook(lua_State* state, int count) const;
  ScriptObserver* observer() const { return setup_.observer; }
  /// Lets this observer observe it from now on; null: none.
  void Observe(ScriptObserver* observer);
  /// Asks the observer again which events it wants.
  void UpdateHooks();
  void SetHookAgain();
  static void OnHook(lua_State* state, lua_Debug* frame);
  void OnCount(lua_State* state);

  MachineSetup setup_;
  ScriptMemory memory_;
  lua_State* state_ = nullptr;
  int run_body_ = 0;  // References to functions, so that a call needs no memory before it is protected.
  int on_error_ = 0;
  std::vector<std::pair<const char*, int>>
      names_;                // Names of functions called from outside, with references to their strings.
  int nested_calls_ = 0;     // See NestedCall.
  int depth_ = 0;            // Of nested protected calls.
  int observed_events_ = 0;  // LUA_MASKLINE and others that the observer wants.
  /// File and line of an ignored API call that returned nil: it may be the cause of a later error. 0: there was none in
  /// the current call.
  std::pair<std::string, int> ignored_;
  std::set<std::string> loading_;
  std::vector<std::string> files_;
  std::uint64_t instructions_left_ = 0;
  std::uint64_t armed_ = 0;             // The budget at the start of the current call.
  std::size_t collect_at_bytes_ = 0;    // Used memory at which the next collection is due; 0: not set yet.
  std::uint64_t collection_price_ = 0;  // In instructions.
  bool collection_due_ = false;         // It runs at the next instruction.
  bool is_paused_ = false;              // A debugger evaluates an expression (OwnBudget).
  bool world_bound_ = false;            // The world's budget allowed less than its own limit.
  RawBody body_ = nullptr;
  void* body_data_ = nullptr;
  std::optional<ScriptError> error_;  // From the message handler.
};

}  // namespace soarbox::script
