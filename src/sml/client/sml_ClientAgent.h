// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "Export.h"
#include "sml_ClientErrors.h"
#include "sml_ClientEvents.h"

/// The folder of the loaded library; empty if unknown.
EXPORT std::string get_soarlib_path();

namespace sml {

class ClientAnalyzedXML;
class ClientXML;
class FloatElement;
class Identifier;
class IntElement;
class Kernel;
class StringElement;
class WMElement;
class WorkingMemory;
struct AgentData;
struct KernelData;

/// One agent of a kernel: its input and output, its rules, its runs and its events. Created by Kernel::CreateAgent and
/// owned by the kernel. Every call on a destroyed agent fails with an error, until 64 others have been destroyed after
/// it. Then pointers to it are invalid.
///
/// Texts that runs and command lines return as char const* share one buffer per kernel: the next such call overwrites
/// it.
class EXPORT Agent : public ClientErrors {
 public:
  ~Agent() override;

  char const* GetAgentName() const;
  Kernel* GetKernel() const;
#ifndef SOARBOX_PUBLIC_API_ONLY
  /// A number that is unique among all agents that this process ever creates. Not part of the interface of Soar 9.6.3.
  unsigned long long GetLife() const;
#endif

  /// Sources a file of rules and commands. Returns false if it contains an error; GetLastErrorDescription() then lists
  /// all errors with file, line and column. Rules without errors are loaded in any case.
  bool LoadProductions(char const* pFilename, bool echoResults = true);
#ifndef SOARBOX_PUBLIC_API_ONLY
  /// The warnings of the last successful LoadProductions, with file, line and column: rules whose conditions multiply,
  /// numbers between two proposals that no rule accepts. Empty if the kernel is in another process. Not part of the
  /// interface of Soar 9.6.3.
  char const* GetLoadWarnings() const;
#endif

  /// The root of the input structure; the same object during the agent's life.
  Identifier* GetInputLink();
  Identifier* GetILink() {
    return GetInputLink();
  }
  /// The root of the output structure; NULL until the agent has created output. Enables change tracking, unless
  /// SetOutputLinkChangeTracking(false) was called.
  Identifier* GetOutputLink();

  /// Adds an element to the input. It enters working memory in the agent's next input phase. Returns NULL, with an
  /// error, if the parent is not an identifier of this agent.
  StringElement* CreateStringWME(Identifier* parent, char const* pAttribute, char const* pValue);
  IntElement* CreateIntWME(Identifier* parent, char const* pAttribute, long long value);
  FloatElement* CreateFloatWME(Identifier* parent, char const* pAttribute, double value);
  Identifier* CreateIdWME(Identifier* parent, char const* pAttribute);
  /// Adds a second element with the same identifier as its value.
  Identifier* CreateSharedIdWME(Identifier* parent, char const* pAttribute, Identifier* pSharedValue);

  /// Sets a new value (and a new time tag) of an input element. An equal value counts as a change unless
  /// SetBlinkIfNoChange(false) was called.
  void Update(StringElement* pWME, char const* pValue);
  void Update(IntElement* pWME, long long value);
  void Update(FloatElement* pWME, double value);
  void SetBlinkIfNoChange(bool state);
  bool IsBlinkIfNoChange();

  /// Removes an input element and everything below it. Returns false for the input link itself and for stale handles.
  bool DestroyWME(WMElement* pWME);

  /// Sends the buffered changes. Changes are buffered only while auto-commit is off (Kernel::SetAutoCommit).
  bool Commit();
  bool IsCommitRequired();

  /// Clears working memory and restarts the agent. The input structure is sent again; its objects stay valid.
  char const* InitSoar();
  void Refresh();

  /// Calls the handler for each new element with this attribute (case-sensitive) directly on the output link. Returns
  /// an id for RemoveOutputHandler. Enables change tracking.
  int AddOutputHandler(char const* pAttributeName, OutputEventHandler handler, void* pUserData, bool addToBack = true);
  bool RemoveOutputHandler(int callbackID);
  /// Calls the handler once in each output phase that changed the output, before the output handlers; only while change
  /// tracking is on.
  int RegisterForOutputNotification(OutputNotificationHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForOutputNotification(int callbackID);

  /// Registers a handler and returns its id (above 0). Registering the same handler, data and event again returns the
  /// same id.
  int RegisterForRunEvent(smlRunEventId id, RunEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForRunEvent(int callbackID);
  int RegisterForProductionEvent(smlProductionEventId id, ProductionEventHandler handler, void* pUserData,
                                 bool addToBack = true);
  bool UnregisterForProductionEvent(int callbackID);
  int RegisterForPrintEvent(smlPrintEventId id, PrintEventHandler handler, void* pUserData, bool ignoreOwnEchos = true,
                            bool addToBack = true);
  bool UnregisterForPrintEvent(int callbackID);
  int RegisterForXMLEvent(smlXMLEventId id, XMLEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForXMLEvent(int callbackID);

  /// Enables or disables the list of output changes; without it, output is faster.
  void SetOutputLinkChangeTracking(bool setting);
  int GetNumberOutputLinkChanges();
  /// Returns NULL if there is no such change.
  WMElement* GetOutputLinkChange(int index);
  /// Returns true if the change is an addition.
  bool IsOutputLinkChangeAdd(int index);
  void ClearOutputLinkChanges();

  /// The number of commands: identifiers that were added directly to the output link since the agent's last apply
  /// phase.
  int GetNumberCommands();
  bool Commands();
  /// Returns NULL if there is no such command.
  Identifier* GetCommand(int index);

  /// Runs only this agent. Returns the output of the `run` command.
  char const* RunSelf(int numberSteps, smlRunStepSize stepSize = sml_DECIDE);
  char const* RunSelfForever();
  char const* RunSelfTilOutput();
  /// Returns true if the agent took part in the last run.
  bool WasAgentOnRunList();
  smlRunResult GetResultOfLastRun();
  /// Asks this agent to stop at the next safe point. Callable from any thread.
  char const* StopSelf();

  smlPhase GetCurrentPhase();
  int GetDecisionCycleCounter();
  smlRunState GetRunState();

  char const* ExecuteCommandLine(char const* pCommandLine, bool echoResults = false, bool noFilter = false);
  bool ExecuteCommandLineXML(char const* pCommandLine, ClientAnalyzedXML* pResponse);
  /// Returns true if the last command line, run or load of this kernel succeeded.
  bool GetLastCommandLineResult();
  bool IsProductionLoaded(char const* pProductionName);

  /// The spatial visual system. SendSVSInput sends lines of the scene graph edit language to the top state's scene; it
  /// fails with an error while the system is off (command svs --enable). GetSVSOutput returns the lines refused since
  /// the last call, with reasons. SVSQuery returns the answers to queries, one per line.
  void SendSVSInput(std::string const& txt);
  std::string GetSVSOutput();
  std::string SVSQuery(std::string const& q);

  /// Replaces the local view of the input or output by the current state in the kernel.
  bool SynchronizeInputLink();
  bool SynchronizeOutputLink();

  /// Starts the Java debugger (SoarJavaDebugger.jar in jarpath, the working directory, $SOAR_HOME or the library's
  /// folder). Returns false, with an error that describes the cause, if it cannot be started.
  bool SpawnDebugger(int port = -1, char const* jarpath = 0);
  bool KillDebugger(bool ignoreNonExistent = false);

  /// Returns the kernel's name of an identifier that this client named ("P1" for "p7"); the argument itself if there is
  /// none yet.
  char const* ConvertIdentifier(char const* pClientIdentifier);

 private:
  friend class Kernel;
  friend class WorkingMemory;
  friend struct AgentData;
  friend struct KernelData;
  Agent(Kernel* kernel, char const* name);

  std::unique_ptr<AgentData> data_;
};

}  // namespace sml
