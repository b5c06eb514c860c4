// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;
struct lua_Debug;

namespace soarbox::script {

class LuaMachine;
class ScriptHost;

/// Observes the execution of a world's scripts: a debugger or a profiler. Machines call it from Lua hooks, on the
/// thread that runs the scripts. A machine without an observer, or whose observer wants no events, runs at full speed.
/// An observer never changes what a script does; limits of instructions are the same.
class ScriptObserver {
 public:
  struct Wants {
    bool lines = false;  ///< OnLine.
    bool calls = false;  ///< OnCall and OnReturn.
  };

  virtual ~ScriptObserver() = default;
  /// Another world begins to create its scripts. All machines so far are about to be destroyed.
  virtual void OnWorld() {}
  /// A machine of this world was created. It exists as long as the world, or until OnGone.
  virtual void OnMachine(LuaMachine&) {}
  /// The agent of this machine was removed, and the machine is about to be destroyed. No call into it is active.
  virtual void OnGone(LuaMachine&) {}
  /// What it wants of a machine. Asked when a call from outside begins, and when the machine loads a file.
  virtual Wants WantsOf(const LuaMachine& machine) = 0;
  /// A line is about to be executed: frame.currentline.
  virtual void OnLine(LuaMachine&, lua_State*, lua_Debug&) {}
  /// A function has been called.
  virtual void OnCall(LuaMachine&, lua_State*, lua_Debug&) {}
  /// A function of a script is about to return. Functions that end by a tail call or an error do not report it.
  virtual void OnReturn(LuaMachine&, lua_State*, lua_Debug&) {}
  /// An error that no script catches; its message is on top of the stack.
  virtual void OnError(LuaMachine&, lua_State*) {}
  /// A call from outside has ended.
  virtual void OnEnd(LuaMachine&) {}
};

/// While such an object exists, each host that is created on this thread reports to the observer, so that it also
/// observes the set-up of a world. The observer must outlive these hosts.
class ObserveNewHosts {
 public:
  explicit ObserveNewHosts(ScriptObserver* observer);
  ~ObserveNewHosts();
  ObserveNewHosts(const ObserveNewHosts&) = delete;
  ObserveNewHosts& operator=(const ObserveNewHosts&) = delete;

  /// The observer of this thread; null: none.
  static ScriptObserver* Current();

 private:
  ScriptObserver* before_;
};

/// Lets this observer, instead of the previous one, observe the scripts of a host from now on. Null: nobody observes
/// them. Do not call it while a script is called.
void ObserveScripts(ScriptHost& host, ScriptObserver* observer);

}  // namespace soarbox::script
