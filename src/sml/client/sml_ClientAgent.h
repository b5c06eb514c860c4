// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "Export.h"
#include "sml_ClientErrors.h"
#include "sml_ClientEvents.h"

/// The folder of the loaded library; empty if it is not known.
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

/// One agent of a kernel: its input and output, its rules, its runs and its events. Made by Kernel::CreateAgent, owned
/// by the kernel. A destroyed agent answers every call with an error.
///
/// Texts that are returned as char const* by runs and command lines share one buffer per kernel: the next such call
/// overwrites it.
class EXPORT Agent : public ClientErrors {
 public:
  ~Agent() override;

  char const* GetAgentName() const;
  Kernel* GetKernel() const;
#ifndef SOARBOX_PUBLIC_API_ONLY
  /// A number that no other agent of this process has or had. Not part of the interface of Soar 9.6.3.
  unsigned long long GetLife() const;
#endif

  /// Sources a file of rules and commands. False if there was an error in it; GetLastErrorDescription() lists every one
  /// with file, line and column, and rules without errors are loaded all the same.
  bool LoadProductions(char const* pFilename, bool echoResults = true);
#ifndef SOARBOX_PUBLIC_API_ONLY
  /// What the last LoadProductions warns of if it succeeded, with file, line and column: rules whose conditions
  /// multiply, numbers that fall between two proposals. Empty if the kernel is in another process. Not part of the
  /// interface of Soar 9.6.3.
  char const* GetLoadWarnings() const;
#endif

  /// The root of the input structure; one object for the agent's life.
  Identifier* GetInputLink();
  Identifier* GetILink() {
    return GetInputLink();
  }
  /// The root of the output structure; NULL until the agent has put something there. Turns change tracking on, unless
  /// SetOutputLinkChangeTracking(false) was called.
  Identifier* GetOutputLink();

  /// Add an element to the input. It enters working memory in the agent's next input phase.
  /// NULL, with an error, if the parent is not an identifier of this agent.
  StringElement* CreateStringWME(Identifier* parent, char const* pAttribute, char const* pValue);
  IntElement* CreateIntWME(Identifier* parent, char const* pAttribute, long long value);
  FloatElement* CreateFloatWME(Identifier* parent, char const* pAttribute, double value);
  Identifier* CreateIdWME(Identifier* parent, char const* pAttribute);
  /// A second element with the same identifier as its value.
  Identifier* CreateSharedIdWME(Identifier* parent, char const* pAttribute, Identifier* pSharedValue);

  /// Gives an input element a new value (and a new time tag). An equal value counts as a change unless
  /// SetBlinkIfNoChange(false) was called.
  void Update(StringElement* pWME, char const* pValue);
  void Update(IntElement* pWME, long long value);
  void Update(FloatElement* pWME, double value);
  void SetBlinkIfNoChange(bool state);
  bool IsBlinkIfNoChange();

  /// Removes an input element and everything below it. False for the input link itself and for stale handles.
  bool DestroyWME(WMElement* pWME);

  /// Sends the changes that wait; there are some only while auto-commit is off (Kernel::SetAutoCommit).
  bool Commit();
  bool IsCommitRequired();

  /// Clears working memory and starts anew. The input structure is sent again; its objects stay valid.
  char const* InitSoar();
  void Refresh();

  /// Calls the handler for each element with this attribute (case matters) that appears directly on the output link.
  /// Returns an id for RemoveOutputHandler. Turns change tracking on.
  int AddOutputHandler(char const* pAttributeName, OutputEventHandler handler, void* pUserData, bool addToBack = true);
  bool RemoveOutputHandler(int callbackID);
  /// Calls the handler once per output phase that changed the output, before the output handlers.
  int RegisterForOutputNotification(OutputNotificationHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForOutputNotification(int callbackID);

  /// Register a handler and return its id (above 0). The same handler, data and event again give the same id.
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

  /// The list of output changes: on, or off for speed.
  void SetOutputLinkChangeTracking(bool setting);
  int GetNumberOutputLinkChanges();
  /// NULL if there is no such change.
  WMElement* GetOutputLinkChange(int index);
  /// True if the change is an addition.
  bool IsOutputLinkChangeAdd(int index);
  void ClearOutputLinkChanges();

  /// Commands: identifiers that appeared directly on the output link since the agent's last apply phase.
  int GetNumberCommands();
  bool Commands();
  /// NULL if there is no such command.
  Identifier* GetCommand(int index);

  /// Run this agent alone. Returns the text of the command line's `run`.
  char const* RunSelf(int numberSteps, smlRunStepSize stepSize = sml_DECIDE);
  char const* RunSelfForever();
  char const* RunSelfTilOutput();
  /// True if the agent took part in the last run.
  bool WasAgentOnRunList();
  smlRunResult GetResultOfLastRun();
  /// Asks this agent to stop at the next safe point. May be called from any thread.
  char const* StopSelf();

  smlPhase GetCurrentPhase();
  int GetDecisionCycleCounter();
  smlRunState GetRunState();

  char const* ExecuteCommandLine(char const* pCommandLine, bool echoResults = false, bool noFilter = false);
  bool ExecuteCommandLineXML(char const* pCommandLine, ClientAnalyzedXML* pResponse);
  /// True if the last command line, run or load of this kernel succeeded.
  bool GetLastCommandLineResult();
  bool IsProductionLoaded(char const* pProductionName);

  /// The spatial visual system is not part of this kernel: input is refused with an error, queries are empty.
  void SendSVSInput(std::string const& txt);
  std::string GetSVSOutput();
  std::string SVSQuery(std::string const& q);

  /// Replace the local view of the input or output by what the kernel has now.
  bool SynchronizeInputLink();
  bool SynchronizeOutputLink();

  /// Starts the Java debugger (SoarJavaDebugger.jar from jarpath, the working folder, $SOAR_HOME or the library's
  /// folder). False, with an error that says what is missing, if it cannot be started.
  bool SpawnDebugger(int port = -1, char const* jarpath = 0);
  bool KillDebugger(bool ignoreNonExistent = false);

  /// The kernel's name of an identifier that this client named ("p7" gives "P1"); its argument if there is none yet.
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
