// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mind/decision_facts.h"
#include "mind/origin.h"
#include "sml/client/sml_Events.h"
#include "sml/server/connection.h"
#include "sml/wire/element.h"

/// The connection between the client API and a kernel: direct calls for a kernel in this process, a socket for any
/// other.
namespace sml {

class Agent;
struct AgentData;
struct KernelData;

/// One element of a message about output.
struct OutputWme {
  bool add = true;
  long long tag = 0;
  long long id = 0;  ///< The identifier that the element belongs to, as IdentifierKey().
  std::string_view attribute;
  soarbox::server::InputWme::Type type = soarbox::server::InputWme::Type::kString;
  std::string_view text;
  long long integer = 0;
  double real = 0.0;
  long long value_id = 0;        ///< For identifiers.
  std::uint32_t value_hint = 0;  ///< The kernel's handle of the value, if it is in this process.
};

/// A kernel's identifier ("F12") as a number for maps; 0 for other texts.
using soarbox::server::IdentifierKey;
long long IdentifierKey(std::string_view name);
/// Sets `out` to the name of an identifier.
void AssignIdentifierName(std::string& out, long long key);

/// The parameters of a run in the client API.
struct RunSpec {
  bool self = true;
  bool forever = false;
  int count = 1;
  smlRunStepSize step = sml_DECIDE;
  bool interleave_given = false;
  smlRunStepSize interleave = sml_PHASE;
};

/// The command line that starts a run: "run --self -d 3".
std::string RunLine(const RunSpec& spec);

/// The result of a command line.
struct LineAnswer {
  bool ok = true;
  bool failed_to_ask = false;  ///< The kernel did not answer at all; `text` explains why.
  std::string text;
  std::string details;  ///< All errors with file, line and column; if there are none, all warnings.
  std::shared_ptr<const soarbox::wire::Element> document;  ///< For structured results: the <sml> of the response.
};

struct LineRequest {
  std::string_view line;
  bool echo = false;
  bool no_filter = false;
  bool structured = false;
  bool fenced = false;    ///< It loads a file to which the fence applies, if there is one.
  bool recorded = false;  ///< It comes from a recording: a fence always applies. Remote kernels refuse it.
};

/// A link's own handle for an element of the input.
using InputHandle = std::uint32_t;
constexpr InputHandle kNoInputHandle = 0xFFFFFFFFu;

/// The data on a mind that only Soarbox's kernel provides, in addition to Soar's client API (soarbox_Inspection.h).
class MindLink {
 public:
  virtual ~MindLink() = default;
  /// The current decision on a state's operators; none if the kernel does not provide it.
  virtual std::optional<soarbox::mind::Decision> Decision(std::string_view state) = 0;
  /// Makes the kernel record origins. Returns false if it cannot.
  virtual bool NoteOrigins() = 0;
  /// The origin of the element with a time tag, or of a command if `command` is not empty.
  virtual soarbox::mind::OriginFacts Origin(std::uint64_t timetag, std::string_view command) = 0;
};

/// The connection to one agent.
class AgentLink {
 public:
  virtual ~AgentLink() = default;

  virtual std::string InputLinkName() = 0;

  /// Changes of the input; a sequence of them ends with FlushInput. The handle of a new element is used in later calls.
  /// Links that identify elements by their tags return no handle.
  virtual InputHandle AddInput(const soarbox::server::InputWme& wme) = 0;
  virtual InputHandle UpdateInput(InputHandle element, long long old_tag, const soarbox::server::InputWme& wme) = 0;
  virtual void RemoveInput(InputHandle element, long long tag) = 0;
  virtual void FlushInput() = 0;

  /// Number of completed apply phases of the agent; counted only while they are watched.
  virtual unsigned long long ApplyCount() = 0;
  virtual void WatchApplyPhases(bool on) = 0;

  virtual std::string KernelName(std::string_view client_name) = 0;
  virtual bool IsProductionLoaded(std::string_view name) = 0;
  virtual int Phase() = 0;
  virtual int DecisionCount() = 0;
  virtual int RunState() = 0;
  virtual bool OnRunList() = 0;
  virtual int LastRunResult() = 0;
  virtual void StopSelf() = 0;

  /// Sends lines to the top state's scene. Returns false if the spatial visual system is off.
  virtual bool SendScene(std::string_view lines) = 0;
  /// Returns the lines refused since the last call, with reasons.
  virtual std::string TakeRefusedScene() = 0;
  virtual std::string QueryScene(std::string_view queries) = 0;

  virtual void Register(int event) = 0;
  virtual void Unregister(int event) = 0;

  virtual MindLink& mind() = 0;

  /// Visits everything that is now on the input link or below the output link, parents first.
  virtual void ListInput(const std::function<void(const OutputWme&)>& visit) = 0;
  virtual void ListOutput(const std::function<void(const OutputWme&)>& visit) = 0;
};

/// A kernel in another process that may keep a log of its clients' acts (sml/server/client_log.h).
class LogLink {
 public:
  virtual ~LogLink() = default;
  /// Returns the reply for the log from this byte on (sml/wire/message.h). Returns none if the kernel keeps no log or
  /// does not answer.
  virtual std::optional<std::string> ReadLog(std::uint64_t from) = 0;
};

/// The connection to a kernel.
class KernelLink {
 public:
  virtual ~KernelLink() = default;

  /// Every call of the API locks it.
  virtual std::recursive_mutex& mutex() = 0;
  virtual bool remote() const = 0;
  virtual bool closed() const = 0;
  /// The reason that a remote kernel gave when it refused this client; empty if it did not.
  virtual std::string Refusal() { return {}; }
  /// Ends a local kernel; disconnects from a remote one.
  virtual void Shutdown() = 0;
  /// Maximum time in which a remote kernel must answer; 0: the default.
  virtual void SetAnswerLimit(int milliseconds) { static_cast<void>(milliseconds); }

  /// `listener` receives each command line of a remote client before it is executed. Remote kernels report nothing.
  virtual void OverhearCommands(std::function<void(char const*, char const*)> listener) { static_cast<void>(listener); }
  /// While on, remote clients wait until CheckForIncoming.
  virtual void HoldIncoming(bool on) { static_cast<void>(on); }

  virtual void FenceFiles(std::vector<std::string> folders, bool rules_only) {
    static_cast<void>(folders), static_cast<void>(rules_only);
  }

  virtual int ListenerPort() = 0;
  virtual long long InitialTimeTag() = 0;
  virtual std::string Version() = 0;

  /// Returns null and sets `error` if the agent cannot be created.
  virtual std::unique_ptr<AgentLink> CreateAgent(Agent& agent, const std::string& name, std::string& error) = 0;
  /// Reports the new agent to all clients, once its Agent object exists.
  virtual void AnnounceAgent(const std::string& name) = 0;
  /// The connection to an agent that another client created.
  virtual std::unique_ptr<AgentLink> FindAgent(Agent& agent, const std::string& name) = 0;
  virtual bool DestroyAgent(const std::string& name, std::string& error) = 0;
  virtual std::vector<std::string> AgentNames() = 0;

  virtual LineAnswer Execute(const char* agent, AgentLink* link, const LineRequest& request) = 0;
  virtual LineAnswer Run(const char* agent, AgentLink* link, const RunSpec& spec, bool want_text) = 0;
  virtual void StopAll() = 0;
  virtual bool IsRunning() = 0;

  virtual void Register(int event) = 0;
  virtual void Unregister(int event) = 0;
  virtual void RegisterFunction(int event, const std::string& name) = 0;
  virtual void UnregisterFunction(int event, const std::string& name) = 0;
  virtual std::optional<std::string> SendClientMessage(Agent* agent, const std::string& client,
                                                       const std::string& message) = 0;
  virtual bool FireSystem(int event) = 0;
  virtual bool SuppressSystemStop(bool on) = 0;
  virtual bool SetInterruptCheckRate(int rate) = 0;
  virtual std::vector<soarbox::server::ConnectionInfo> Connections() = 0;
  virtual bool SetConnectionInfo(const std::string& name, const std::string& status,
                                 const std::string& agent_status) = 0;
  virtual std::string LoadLibrary(const std::string& command) = 0;

  /// Serves the requests that have arrived. Returns true if there were any.
  virtual bool CheckForIncoming() = 0;
  virtual bool StartEventThread() = 0;
  virtual bool StopEventThread() = 0;
  virtual void SetTrace(bool on) = 0;
};

}  // namespace sml
