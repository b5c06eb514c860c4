// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sml/server/connection.h"
#include "sml/server/open_events.h"
#include "sml/wire/channel.h"
#include "sml/wire/message.h"

namespace soarbox::server {

class KernelHost;

/// A client connected by a socket. Sends events as documents and executes the client's calls.
///
/// Handlers of some events may change the agent (runs, output, creation and destruction of agents). For these the
/// kernel waits for the client's answer, as in Soar, but at most until the time-out. After a time-out the client counts
/// as slow: the kernel does not wait for it until it has answered the last such event. Text and trace never wait; they
/// are dropped if too much is unsent, and the next message that is sent reports how many were dropped.
///
/// A client that only watches does not delay a run that it did not start. Such a client, for example a debugger,
/// receives no output and creates no input. Of the events that come with every decision, it receives the next one after
/// it has answered the previous one. Each kind waits at most once, even if it has happened several times since. Between
/// two rounds of such events the client has time to redraw. The same applies to slow clients.
class RemoteConnection : public Connection {
 public:
  RemoteConnection(KernelHost& host, std::unique_ptr<wire::Channel> channel, std::chrono::milliseconds answer_timeout);
  ~RemoteConnection() override;

  /// Executes the calls that have arrived. Returns true if there were any.
  bool Serve();
  /// The client has disconnected, and everything that it sent has been served.
  bool gone() const { return gone_; }
  bool slow() const { return slow_; }
  bool silent() const { return channel_->silent(); }
  bool closed() const { return channel_->closed(); }
  void Close() { channel_->Close(); }

  bool embedded() const override { return false; }
  void OnSystemEvent(int event) override;
  void OnUpdateEvent(int event, int run_flags) override;
  void OnAgentEvent(HostedAgent& agent, int event) override;
  void OnRunEvent(HostedAgent& agent, int event, int phase) override;
  void OnProductionEvent(HostedAgent& agent, int event, std::string_view name) override;
  void OnPrint(HostedAgent& agent, const std::string& text) override;
  void OnEcho(HostedAgent& agent, const std::string& text, bool self) override;
  void OnXmlTrace(HostedAgent& agent, std::string_view pieces) override;
  void OnXmlInput(HostedAgent& agent, std::span<const InputWme> wmes) override;
  void OnOutput(HostedAgent& agent, std::span<const kernel::OutputChange> changes) override;
  void OnOutputInit(HostedAgent& agent) override;
  std::optional<std::string> OnFunction(HostedAgent* agent, int event, std::string_view name,
                                        std::string_view argument) override;

 private:
  enum class Wait { kNo, kForAnswer };

  /// An event that comes with every run, phase or decision.
  struct Notice {
    int event = 0;
    std::string agent;           ///< Empty for an event of the kernel.
    std::string_view parameter;  ///< The name of the parameter `value`; empty if there is none.
    int value = 0;
  };

  std::string NextId() { return std::to_string(next_id_++); }
  void Handle(const wire::Message& message);
  /// A response that needs no processing, such as one to a part of the trace; recognized without parsing.
  bool IsIdleAnswer(std::string_view document) const;
  /// Sends a call. With kForAnswer, serves the client until its response arrives, and returns it if it does.
  std::optional<wire::Message> Call(wire::Message& call, Wait wait, bool droppable = false);
  /// Sends a notice or stores it for later, as described at the class.
  void Announce(Notice notice);
  /// Sends the next waiting notice, unless the client has not answered the last one yet.
  void SendNotice();
  /// Starts the next round with all waiting notices, if it is time.
  bool BeginRound();
  /// The client has answered an event.
  void Answered(const std::string& id);
  static wire::Message NoticeCall(const Notice& notice);
  /// Reports the number of messages dropped since the last report; empty if none.
  std::string DroppedNote() const;
  /// Sends text or trace, combined with further parts if they follow soon. `note` converts the report on dropped
  /// messages to such a part.
  template <typename Note>
  void SendTrace(HostedAgent& agent, int event, std::string_view piece, std::string_view opening,
                 std::string_view closing, Note note);

  KernelHost& host_;
  std::unique_ptr<wire::Channel> channel_;
  std::chrono::milliseconds timeout_;
  std::uint64_t next_id_ = 0;
  std::string awaited_id_;  ///< The id of the last awaited call; the client counts as slow until it is answered.
  std::optional<wire::Message> answer_;  ///< To the awaited call.
  OpenEvents open_events_;
  std::vector<Notice> notices_;  ///< Waiting notices, ordered by their last occurrence.
  std::vector<Notice> round_;    ///< The notices of the current round that are still to be sent.
  std::chrono::steady_clock::time_point next_round_{};
  bool alarm_set_ = false;  ///< An alarm for the next round is set.
  std::string notice_id_;   ///< Id of the notice that was sent but not answered; empty if none.
  int serving_ = 0;         ///< Number of the client's calls that are being executed, nested in each other.
  bool slow_ = false;
  bool gone_ = false;
  unsigned long long told_dropped_ = 0;  ///< Number of dropped messages that were reported to the client.
  std::string head_, piece_;             ///< Buffers for parts of documents.
  std::set<std::string> told_output_;    ///< Agents whose output was sent to this client.
};

}  // namespace soarbox::server
