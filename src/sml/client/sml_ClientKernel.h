// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "Export.h"
#include "sml_ClientErrors.h"
#include "sml_ClientEvents.h"

namespace sml {

class Agent;
class ClientAnalyzedXML;
class Connection;
struct AgentData;
struct KernelData;

/// A client of a kernel, as Kernel::GetConnectionInfo shows it.
class EXPORT ConnectionInfo {
 public:
  ConnectionInfo(char const* pID, char const* pName, char const* pStatus, char const* pAgentStatus);
  char const* GetID() const { return id_.c_str(); }
  char const* GetName() const { return name_.c_str(); }
  /// Free text; usual are created, not-ready, ready, closing.
  char const* GetConnectionStatus() const { return status_.c_str(); }
  char const* GetAgentStatus() const { return agent_status_.c_str(); }

 private:
  std::string id_, name_, status_, agent_status_;
};

/// A Soar kernel, in this process or in another one, and the agents in it.
///
/// The factories always return an object: ask HadError(). The caller deletes it. Several kernels can live in one
/// process, also with agents of the same names. A kernel may be used from several threads; its calls take turns, and
/// stop requests never wait.
class EXPORT Kernel : public ClientErrors {
 public:
  static constexpr int kDefaultSMLPort = 12121;
  static constexpr int kSuppressListener = 0;  ///< No port: no remote clients.
  static constexpr int kUseAnyPort = -1;       ///< Any free port, none without sockets; ask GetListenerPort().

  /// A kernel that works only inside calls from this process: remote clients are served during runs and by
  /// CheckForIncomingCommands(). A port that is taken is an error that names it; the kernel works without a listener.
  /// With optimized, the runs return the text "DirectRun completed".
  static Kernel* CreateKernelInCurrentThread(bool optimized = false, int portToListenOn = kDefaultSMLPort);
  /// A kernel that serves remote clients by itself at any time.
  static Kernel* CreateKernelInNewThread(int portToListenOn = kDefaultSMLPort);
  /// The client of a kernel in another process. Without an address: this machine.
  /// With ignoreOutput, agents do not report their output here.
  static Kernel* CreateRemoteConnection(bool sharedFileSystem = true, char const* pIPaddress = 0,
                                        int port = kDefaultSMLPort, bool ignoreOutput = false);
  /// Shuts down, if that was not done, and destroys the agents' objects.
  ~Kernel() override;

  /// The port that is really listened on; 0 if none.
  int GetListenerPort();
  static int GetDefaultPort() { return kDefaultSMLPort; }

  /// On (the default): every change of input is sent at once. Off: changes wait for Agent::Commit().
  void SetAutoCommit(bool state);
  bool IsAutoCommitEnabled();
  bool IsConnectionClosed();
  bool IsRemoteConnection();
  /// True for a kernel in this process that was made with optimized.
  bool IsDirectConnection();

#ifndef SOARBOX_PUBLIC_API_ONLY
  /// Makes calls of this kernel and its agents with none of another thread between them: texts that they return can be
  /// copied there, and objects looked at. Not part of the interface of Soar 9.6.3.
  void Together(std::function<void()> const& calls);

  /// How long a remote kernel may be silent while it is asked something: a run, say. After that the connection counts
  /// as closed (IsConnectionClosed) and calls fail at once. Command lines that are no runs may take five times as long.
  /// 0, the default: calls fail after a minute, and runs and command lines may take as long as they like. Not part of
  /// the interface of Soar 9.6.3.
  void SetAnswerLimit(int milliseconds);

  /// Calls the listener for each command line that a remote client asks a kernel in this process for, before it is
  /// carried out. Not part of the interface of Soar 9.6.3.
  void OverhearCommands(std::function<void(char const* pAgentName, char const* pCommandLine)> listener);
  /// From now on the commands in files that LoadProductions loads, and those that rules carry out, may read below these
  /// folders only, and write and start nothing. In another process this holds for agents that this object makes, and
  /// only if the kernel is one of Soarbox. `rules_only`, for a kernel in this process: nothing is carried out but rules
  /// and the loading of further files; other commands are passed over. Not part of the interface of Soar 9.6.3.
  void FenceFiles(std::vector<std::string> folders, bool rules_only = false);
  /// Like ExecuteCommandLine, for a line that comes from a recording: it may read below the folders of FenceFiles only,
  /// and write and start nothing. Not part of the interface of Soar 9.6.3.
  char const* ExecuteRecordedCommandLine(char const* pCommandLine, char const* pAgentName);
  /// While on, what remote clients ask a kernel in this process for waits until CheckForIncomingCommands, during runs
  /// too. Not part of the interface of Soar 9.6.3.
  void HoldIncomingCommands(bool state);
#endif

  /// Ends the kernel and its agents (a remote one: leaves it). Afterwards only delete is of use.
  void Shutdown();

  /// Prints every message of a remote connection on the standard output.
  void SetTraceCommunications(bool state);
  bool IsTracingCommunications();

  /// NULL, with an error, if there is an agent of that name. Sources settings.soar from the working folder, $SOAR_HOME
  /// or the library's folder, if there is one.
  Agent* CreateAgent(char const* pAgentName);
  /// Brings the local list of agents up to date with the kernel's.
  void UpdateAgentList();
  int GetNumberAgents();
  /// In the order of their names; NULL if there is no such agent.
  Agent* GetAgentByIndex(int index);
  Agent* GetAgent(char const* pAgentName);
  bool IsAgentValid(Agent* pAgent);
  bool DestroyAgent(Agent* pAgent);

  /// Off: command lines are not shown to filters.
  void EnableFiltering(bool state);

  /// Executes a line and returns its text, valid until the next call. pAgentName may be NULL for commands that need no
  /// agent.
  char const* ExecuteCommandLine(char const* pCommandLine, char const* pAgentName, bool echoResults = false,
                                 bool noFilter = false);
  bool ExecuteCommandLineXML(char const* pCommandLine, char const* pAgentName, ClientAnalyzedXML* pResponse);
  bool GetLastCommandLineResult();

  /// Run all agents together, in steps of the interleave size.
  char const* RunAllAgents(int numberSteps, smlRunStepSize stepSize = sml_DECIDE,
                           smlRunStepSize interleaveStepSize = sml_PHASE);
  char const* RunAllAgentsForever(smlRunStepSize interleaveStepSize = sml_PHASE);
  char const* RunAllTilOutput(smlRunStepSize interleaveStepSize = sml_PHASE);
  /// Asks all agents to stop at the next safe point. May be called from any thread.
  char const* StopAllAgents();
  bool IsSoarRunning();

  /// Fetches the list of connections that the next three functions read.
  bool GetAllConnectionInfo();
  bool HasConnectionInfoChanged();
  int GetNumberConnections();
  ConnectionInfo const* GetConnectionInfo(int index);
  /// By the connection's name, from the list; NULL if it is not there.
  char const* GetConnectionStatus(char const* pConnectionName);
  char const* GetAgentStatus(char const* pConnectionName);
  bool SetConnectionInfo(char const* pName, char const* pConnectionStatus, char const* pAgentStatus);

  /// Let a client bracket several runs as one run of the system.
  bool FireStartSystemEvent();
  bool FireStopSystemEvent();
  bool SuppressSystemStop(bool state);

  /// Serves what remote clients have asked for. True if there was anything.
  bool CheckForIncomingCommands();
  bool CheckForIncomingEvents();
  /// The thread that delivers events of a remote kernel between calls; started by itself.
  bool StartEventThread();
  bool StopEventThread();

  /// Elaborations between two smlEVENT_INTERRUPT_CHECK events: 10 unless set.
  bool SetInterruptCheckRate(int newRate);

  int RegisterForSystemEvent(smlSystemEventId id, SystemEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForSystemEvent(int callbackID);
  int RegisterForUpdateEvent(smlUpdateEventId id, UpdateEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForUpdateEvent(int callbackID);
  int RegisterForStringEvent(smlStringEventId id, StringEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForStringEvent(int callbackID);
  int RegisterForAgentEvent(smlAgentEventId id, AgentEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForAgentEvent(int callbackID);

  /// Makes a function that rules of all agents can call: (exec name arguments...). Its text becomes the value.
  int AddRhsFunction(char const* pRhsFunctionName, RhsEventHandler handler, void* pUserData, bool addToBack = true);
  int AddRhsFunction(char const* pRhsFunctionName, RhsEventHandlerCpp handler, bool addToBack = true);
  bool RemoveRhsFunction(int callbackID);

  /// Receives what others send with SendClientMessage to this name.
  int RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandler handler, void* pUserData,
                                    bool addToBack = true);
  int RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandlerCpp handler, bool addToBack = true);
  bool UnregisterForClientMessageEvent(int callbackID);
  /// The answer of the first client of that name; "**NOBODY RESPONDED**" if there is none.
  std::string SendClientMessage(Agent* pAgent, char const* pClientName, char const* pMessage);

  std::string GetSoarKernelVersion();

  void CommitAll();
  bool IsCommitRequired();

  /// Loads a shared library that exports sml_InitLibrary: "name arguments...". Returns the empty text, or what failed.
  std::string LoadExternalLibrary(char const* pLibraryCommand);

  Connection* GetConnection() const;

 private:
  friend class Agent;
  friend class WorkingMemory;
  friend struct AgentData;
  friend struct KernelData;
  Kernel();

  std::unique_ptr<KernelData> data_;
};

}  // namespace sml
