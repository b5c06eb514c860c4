// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;
struct lua_Debug;

namespace soarbox::script {

class LuaMachine;

/// Follows the execution of the scripts of a world: a debugger or a profiler. Machines call it from the hooks of Lua,
/// on the thread that runs the scripts. A machine without an observer, or with one that wants nothing, runs at full
/// speed. An observer never changes what a script does; limits of instructions count as without it.
class ScriptObserver {
 public:
  struct Wants {
    bool lines = false;  ///< OnLine.
    bool calls = false;  ///< OnCall and OnReturn.
  };

  virtual ~ScriptObserver() = default;
  /// The scripts of another world begin: machines that it knows of are about to go.
  virtual void OnWorld() {}
  /// A machine of this world has been made; it lives as long as the world, or until OnGone.
  virtual void OnMachine(LuaMachine&) {}
  /// The agent of this machine was removed: the machine is about to go. No call into it is under way.
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

/// While one lives, each host that is made on this thread reports to the observer, so that it also sees the set-up of a
/// world. The observer must outlive these hosts.
class ObserveNewHosts {
 public:
  explicit ObserveNewHosts(ScriptObserver* observer);
  ~ObserveNewHosts();
  ObserveNewHosts(const ObserveNewHosts&) = delete;
  ObserveNewHosts& operator=(const ObserveNewHosts&) = delete;

  /// Null: there is none.
  static ScriptObserver* Current();

 private:
  ScriptObserver* before_;
};

}  // namespace soarbox::script
