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

/// A client at the other end of a socket: events become documents, its calls are carried out.
///
/// Events whose handlers may change the agent (runs, output, agents coming and going) wait for the client's answer, as
/// in Soar, but only until the time-out: then the client counts as slow and is not waited for until it has answered the
/// last of them. Text and trace never wait, and are dropped when they pile up; the next that gets through tells how
/// many.
///
/// A client that only watches (it takes no output and makes no input, as a debugger) does not hold up a run that it has
/// not started itself: of the events that come with every decision it is sent the next one when it has answered the one
/// before, and each kind waits once, however often it happened meanwhile. Between two rounds of them it gets time to
/// redraw what it shows. The same goes for a slow client.
class RemoteConnection : public Connection {
 public:
  RemoteConnection(KernelHost& host, std::unique_ptr<wire::Channel> channel, std::chrono::milliseconds answer_timeout);
  ~RemoteConnection() override;

  /// Carries out the calls that have come. True if there were any.
  bool Serve();
  /// The other side is gone and everything that it sent has been served.
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
    std::string agent;           ///< Empty: of the kernel.
    std::string_view parameter;  ///< What `value` is called; empty: there is none.
    int value = 0;
  };

  std::string NextId() { return std::to_string(next_id_++); }
  void Handle(const wire::Message& message);
  /// An answer that nobody waits for, as to each piece of trace; told without parsing it.
  bool IsIdleAnswer(std::string_view document) const;
  /// Sends a call; with kForAnswer, serves the client until its answer is there. The answer, if one came.
  std::optional<wire::Message> Call(wire::Message& call, Wait wait, bool droppable = false);
  /// Sends a notice, or keeps it for later; see above.
  void Announce(Notice notice);
  /// Sends the next of the notices that wait, unless the client has yet to answer the last one.
  void SendNotice();
  /// Takes the notices that wait for the next round, if it is time.
  bool BeginRound();
  /// The client has answered an event.
  void Answered(const std::string& id);
  static wire::Message NoticeCall(const Notice& notice);
  /// Says how many messages were dropped since that was last said; empty if none.
  std::string DroppedNote() const;
  /// Sends text or trace, together with more of the same if more comes soon. `note` turns the note about dropped
  /// messages into such a piece.
  template <typename Note>
  void SendTrace(HostedAgent& agent, int event, std::string_view piece, std::string_view opening,
                 std::string_view closing, Note note);

  KernelHost& host_;
  std::unique_ptr<wire::Channel> channel_;
  std::chrono::milliseconds timeout_;
  std::uint64_t next_id_ = 0;
  std::string awaited_id_;               ///< Of the last call that is waited for; slow until it is answered.
  std::optional<wire::Message> answer_;  ///< To the awaited call.
  OpenEvents open_events_;
  std::vector<Notice> notices_;  ///< That wait, in the order in which they happened last.
  std::vector<Notice> round_;    ///< Those of them that are being sent, one after another.
  std::chrono::steady_clock::time_point next_round_{};
  bool alarm_set_ = false;  ///< For the next round.
  std::string notice_id_;   ///< Of the notice that was sent and not answered; empty: none.
  int serving_ = 0;         ///< How many of the client's calls are being carried out, one in another.
  bool slow_ = false;
  bool gone_ = false;
  unsigned long long told_dropped_ = 0;  ///< How many of the dropped messages the client knows of.
  std::string head_, piece_;             ///< Room for parts of documents.
  std::set<std::string> told_output_;    ///< Agents whose output this client has been told of.
};

}  // namespace soarbox::server
