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

/// A client of a kernel, as reported by Kernel::GetConnectionInfo.
class EXPORT ConnectionInfo {
 public:
  ConnectionInfo(char const* pID, char const* pName, char const* pStatus, char const* pAgentStatus);
  char const* GetID() const { return id_.c_str(); }
  char const* GetName() const { return name_.c_str(); }
  /// Free text; usually created, not-ready, ready or closing.
  char const* GetConnectionStatus() const { return status_.c_str(); }
  char const* GetAgentStatus() const { return agent_status_.c_str(); }

 private:
  std::string id_, name_, status_, agent_status_;
};

/// A Soar kernel, in this process or in another one, and the agents in it.
///
/// The factory functions always return an object, which the caller deletes; check HadError(). Several kernels can exist
/// in one process, even with agents of the same names. Several threads may use a kernel: its calls are serialized,
/// except that stop requests never wait.
class EXPORT Kernel : public ClientErrors {
 public:
  static constexpr int kDefaultSMLPort = 12121;
  static constexpr int kSuppressListener = 0;  ///< No port: no remote clients.
  static constexpr int kUseAnyPort = -1;  ///< Any free port, or none if there are no sockets; see GetListenerPort().

  /// Creates a kernel that works only during calls from this process: remote clients are served during runs and by
  /// CheckForIncomingCommands(). If the port is in use, an error names it, and the kernel works without a listener.
  /// With `optimized`, runs return the text "DirectRun completed".
  static Kernel* CreateKernelInCurrentThread(bool optimized = false, int portToListenOn = kDefaultSMLPort);
  /// Creates a kernel that serves remote clients at any time, on its own thread.
  static Kernel* CreateKernelInNewThread(int portToListenOn = kDefaultSMLPort);
  /// Connects to a kernel in another process. Without an address, connects to this machine. With ignoreOutput, agents
  /// do not report their output to this client.
  static Kernel* CreateRemoteConnection(bool sharedFileSystem = true, char const* pIPaddress = 0,
                                        int port = kDefaultSMLPort, bool ignoreOutput = false);
  /// Calls Shutdown() if necessary, and destroys the agents' objects.
  ~Kernel() override;

  /// The port that the kernel listens on; 0 if it does not listen.
  int GetListenerPort();
  static int GetDefaultPort() { return kDefaultSMLPort; }

  /// On (the default): each change of the input is sent immediately. Off: changes wait for Agent::Commit().
  void SetAutoCommit(bool state);
  bool IsAutoCommitEnabled();
  bool IsConnectionClosed();
  bool IsRemoteConnection();
  /// Returns true for a kernel in this process that was created with `optimized`.
  bool IsDirectConnection();

#ifndef SOARBOX_PUBLIC_API_ONLY
  /// Executes `calls` without calls of other threads to this kernel and its agents in between. Inside, returned texts
  /// can be copied and objects read safely. Not part of the interface of Soar 9.6.3.
  void Together(std::function<void()> const& calls);

  /// Maximum time in milliseconds in which a remote kernel must answer. If it is exceeded, the connection counts as
  /// closed (IsConnectionClosed), and calls fail immediately. Command lines that are not runs may take five times as
  /// long. 0, the default: calls fail after a minute; runs and command lines have no limit. Not part of the interface
  /// of Soar 9.6.3.
  void SetAnswerLimit(int milliseconds);

  /// For a kernel in this process: calls the listener for each command line of a remote client, before it is executed.
  /// Not part of the interface of Soar 9.6.3.
  void OverhearCommands(std::function<void(char const* pAgentName, char const* pCommandLine)> listener);
  /// Restricts the commands in files that LoadProductions loads from now on, and the commands that rules execute: they
  /// may read only below these folders, and may not write files or start programs. For a remote kernel, this applies to
  /// agents created through this object, and only if it is a kernel of Soarbox. With `rules_only`, for a kernel in this
  /// process, only rules and the loading of further files are executed; other commands are skipped. Not part of the
  /// interface of Soar 9.6.3.
  void FenceFiles(std::vector<std::string> folders, bool rules_only = false);
  /// Like ExecuteCommandLine, for a line from a recording: it may read only below the folders of FenceFiles, and may
  /// not write files or start programs. Not part of the interface of Soar 9.6.3.
  char const* ExecuteRecordedCommandLine(char const* pCommandLine, char const* pAgentName);
  /// While on, requests of remote clients to a kernel in this process wait until CheckForIncomingCommands, even during
  /// runs. Not part of the interface of Soar 9.6.3.
  void HoldIncomingCommands(bool state);
#endif

  /// Ends the kernel and its agents; disconnects from a remote kernel. Afterwards the object can only be deleted.
  void Shutdown();

  /// Prints every message of a remote connection to the standard output.
  void SetTraceCommunications(bool state);
  bool IsTracingCommunications();

  /// Creates an agent. Returns NULL, with an error, if the name is in use. Sources settings.soar in the kernel's
  /// working directory or, if it is not there, in $SOAR_HOME.
  Agent* CreateAgent(char const* pAgentName);
  /// Updates the local list of agents from the kernel.
  void UpdateAgentList();
  int GetNumberAgents();
  /// The agents sorted by name; NULL if there is no such agent.
  Agent* GetAgentByIndex(int index);
  Agent* GetAgent(char const* pAgentName);
  bool IsAgentValid(Agent* pAgent);
  bool DestroyAgent(Agent* pAgent);

  /// While off, command lines are not passed to filters.
  void EnableFiltering(bool state);

  /// Executes a line and returns its output, which is valid until the next call. pAgentName may be NULL for commands
  /// that need no agent.
  char const* ExecuteCommandLine(char const* pCommandLine, char const* pAgentName, bool echoResults = false,
                                 bool noFilter = false);
  bool ExecuteCommandLineXML(char const* pCommandLine, char const* pAgentName, ClientAnalyzedXML* pResponse);
  bool GetLastCommandLineResult();

  /// Runs all agents together, in steps of the interleave size.
  char const* RunAllAgents(int numberSteps, smlRunStepSize stepSize = sml_DECIDE,
                           smlRunStepSize interleaveStepSize = sml_PHASE);
  char const* RunAllAgentsForever(smlRunStepSize interleaveStepSize = sml_PHASE);
  char const* RunAllTilOutput(smlRunStepSize interleaveStepSize = sml_PHASE);
  /// Asks all agents to stop at the next safe point. Callable from any thread.
  char const* StopAllAgents();
  bool IsSoarRunning();

  /// Updates the list of connections for the next three functions.
  bool GetAllConnectionInfo();
  bool HasConnectionInfoChanged();
  int GetNumberConnections();
  ConnectionInfo const* GetConnectionInfo(int index);
  /// The status of the listed connection with this name; NULL if there is none.
  char const* GetConnectionStatus(char const* pConnectionName);
  char const* GetAgentStatus(char const* pConnectionName);
  bool SetConnectionInfo(char const* pName, char const* pConnectionStatus, char const* pAgentStatus);

  /// Allow a client to combine several runs into one run of the system.
  bool FireStartSystemEvent();
  bool FireStopSystemEvent();
  bool SuppressSystemStop(bool state);

  /// Serves pending requests of remote clients. Returns true if there were any.
  bool CheckForIncomingCommands();
  bool CheckForIncomingEvents();
  /// The thread that delivers events of a remote kernel between calls; started automatically.
  bool StartEventThread();
  bool StopEventThread();

  /// Number of steps of a run (of the interleave size) between two smlEVENT_INTERRUPT_CHECK events; the default is 10.
  bool SetInterruptCheckRate(int newRate);

  int RegisterForSystemEvent(smlSystemEventId id, SystemEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForSystemEvent(int callbackID);
  int RegisterForUpdateEvent(smlUpdateEventId id, UpdateEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForUpdateEvent(int callbackID);
  int RegisterForStringEvent(smlStringEventId id, StringEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForStringEvent(int callbackID);
  int RegisterForAgentEvent(smlAgentEventId id, AgentEventHandler handler, void* pUserData, bool addToBack = true);
  bool UnregisterForAgentEvent(int callbackID);

  /// Registers a function that rules of all agents can call: (exec name arguments...). The returned text becomes the
  /// value.
  int AddRhsFunction(char const* pRhsFunctionName, RhsEventHandler handler, void* pUserData, bool addToBack = true);
  int AddRhsFunction(char const* pRhsFunctionName, RhsEventHandlerCpp handler, bool addToBack = true);
  bool RemoveRhsFunction(int callbackID);

  /// Receives messages that others send to this name with SendClientMessage.
  int RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandler handler, void* pUserData,
                                    bool addToBack = true);
  int RegisterForClientMessageEvent(char const* pClientName, ClientMessageHandlerCpp handler, bool addToBack = true);
  bool UnregisterForClientMessageEvent(int callbackID);
  /// Returns the answer of the first client of this name; "**NOBODY RESPONDED**" if there is none.
  std::string SendClientMessage(Agent* pAgent, char const* pClientName, char const* pMessage);

  std::string GetSoarKernelVersion();

  void CommitAll();
  bool IsCommitRequired();

  /// Loads a shared library that exports sml_InitLibrary; the command is "name arguments...". Returns an empty text, or
  /// an error message.
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
