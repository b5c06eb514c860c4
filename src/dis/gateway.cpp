// SPDX-License-Identifier: BSD-2-Clause
#include "dis/gateway.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "dis/state_sender.h"
#include "dis/udp_socket.h"
#include "sim/foreign_bodies.h"
#include "sim/simulation.h"

namespace soarbox::dis {
namespace {

using Clock = std::chrono::steady_clock;

/// Maximum number of datagrams per tick. Others wait for the next tick, and the system drops those for which it has no
/// space, so that a flood does not delay the world.
constexpr int kMostPerTick = 5000;

double SecondsBetween(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::vector<std::pair<std::string, std::uint64_t>> Traffic::Dropped() const {
  std::vector<std::pair<std::string, std::uint64_t>> dropped;
  for (std::size_t i = 0; i < refused.size(); ++i)
    if (refused[i] > 0) dropped.emplace_back(Name(static_cast<Refusal>(i)), refused[i]);
  if (foreign_exercise > 0) dropped.emplace_back("of other exercises", foreign_exercise);
  if (too_many > 0) dropped.emplace_back("of too many entities", too_many);
  return dropped;
}

struct Gateway::Impl {
  Impl(const Settings& given, std::unique_ptr<UdpSocket> opened)
      : settings(given), socket(std::move(opened)), view(settings), sender(settings) {}

  void SendAll(std::vector<Pdu> pdus);
  /// Reads the received PDUs, and executes orders of the exercise's manager.
  void Read();
  void Obey(const Management& order);
  void Measure();

  const Settings settings;
  std::unique_ptr<UdpSocket> socket;
  ExerciseView view;
  StateSender sender;
  Traffic traffic;
  Traffic measured;  ///< A second ago.
  Clock::time_point started = Clock::now(), measured_at = started;
  bool frozen = false;
};

void Gateway::Impl::SendAll(std::vector<Pdu> pdus) {
  if (settings.listens_only) return;
  for (Pdu& pdu : pdus) {
    pdu.version = settings.version;
    pdu.exercise = settings.exercise;
    pdu.timestamp = RelativeTimestamp(SecondsBetween(started, Clock::now()));
    ++(socket->Send(Encode(pdu)) ? traffic.sent : traffic.unsent);
  }
}

void Gateway::Impl::Obey(const Management& order) {
  const bool is_ours = (order.to.site == settings.site || order.to.site == kAllSites) &&
                       (order.to.application == settings.application || order.to.application == kAllSites);
  if (!settings.takes_orders || !is_ours) return;
  Management answer;
  answer.from = {settings.site, settings.application, 0};
  answer.to = order.from;
  answer.request = order.request;
  if (order.type == PduType::kStopFreeze) {
    frozen = true;
    answer.flag = 4;
  } else if (order.type == PduType::kStartResume) {
    frozen = false;
    answer.flag = 3;
  } else if (order.type == PduType::kCreateEntity || order.type == PduType::kRemoveEntity) {
    // Only the scenario determines which entities are in the world.
    answer.flag = order.type == PduType::kCreateEntity ? 1 : 2;
    answer.is_able = false;
  } else {
    return;
  }
  SendAll({Pdu{.body = answer}});
}

void Gateway::Impl::Read() {
  const double now_s = SecondsBetween(started, Clock::now());
  for (int i = 0; i < kMostPerTick; ++i) {
    std::span<const std::byte> datagram = socket->Receive();
    if (datagram.empty()) break;
    // A datagram may contain several PDUs.
    do {
      const std::size_t length = LengthOf(datagram);
      std::variant<Pdu, Refusal> read = Decode(datagram);
      if (const Refusal* refusal = std::get_if<Refusal>(&read)) {
        ++traffic.refused[static_cast<std::size_t>(*refusal)];
      } else if (const Pdu& pdu = std::get<Pdu>(read); pdu.exercise != settings.exercise) {
        ++traffic.foreign_exercise;
      } else if (const auto* order = std::get_if<Management>(&pdu.body)) {
        ++traffic.received;
        Obey(*order);
      } else {
        switch (view.Take(pdu.body, now_s)) {
          case ExerciseView::Taken::kYes:
            ++traffic.received;
            break;
          case ExerciseView::Taken::kTooMany:
            ++traffic.too_many;
            break;
          case ExerciseView::Taken::kOurs:
            break;
        }
      }
      if (length == 0) break;
      datagram = datagram.subspan(length);
    } while (!datagram.empty());
  }
  view.ForgetSilent(now_s);
  traffic.entities = view.entities();
  Measure();
}

void Gateway::Impl::Measure() {
  const Clock::time_point now = Clock::now();
  const double passed_s = SecondsBetween(measured_at, now);
  if (passed_s < 1) return;
  traffic.received_per_s = static_cast<double>(traffic.received - measured.received) / passed_s;
  traffic.sent_per_s = static_cast<double>(traffic.sent - measured.sent) / passed_s;
  measured = traffic;
  measured_at = now;
}

Gateway::Gateway(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Gateway::~Gateway() {
  impl_->SendAll(impl_->sender.Leave());
}

Result<std::unique_ptr<Gateway>> Gateway::Open(const Settings& settings) {
  Result<std::unique_ptr<UdpSocket>> socket = UdpSocket::Open(settings.address, settings.port, settings.interface);
  if (!socket) return socket.error();
  return std::unique_ptr<Gateway>(new Gateway(std::make_unique<Impl>(settings, std::move(*socket))));
}

void Gateway::Receive(sim::Simulation& simulation) {
  impl_->Read();
  for (sim::InputValue& input : impl_->view.TakeInputs(impl_->sender)) simulation.Submit(std::move(input));
}

void Gateway::Send(const sim::Simulation& simulation) {
  impl_->SendAll(impl_->sender.AfterTick(simulation, SecondsBetween(impl_->started, Clock::now())));
}

void Gateway::Idle(sim::Simulation& simulation) {
  impl_->Read();
  impl_->SendAll(impl_->sender.WhileStill(simulation, SecondsBetween(impl_->started, Clock::now())));
}

bool Gateway::IsFrozen() const {
  return impl_->frozen;
}
const Settings& Gateway::settings() const {
  return impl_->settings;
}
const Traffic& Gateway::traffic() const {
  return impl_->traffic;
}

bool Gateway::IsOfThisMachine() const {
  return impl_->socket->IsOfThisMachine();
}
std::vector<ForeignEntity> Gateway::Entities(std::size_t most) const {
  return impl_->view.List(SecondsBetween(impl_->started, Clock::now()), most);
}

std::string Gateway::Describe() const {
  const Settings& s = impl_->settings;
  const Traffic& t = impl_->traffic;
  std::string text = "DIS exercise " + std::to_string(s.exercise) + " at " + s.address + ":" + std::to_string(s.port) +
                     (impl_->socket->IsOfThisMachine() ? " (this machine only)" : "") + " as " +
                     std::to_string(s.site) + ":" + std::to_string(s.application) + ": " + std::to_string(t.sent) +
                     " PDUs sent, " + std::to_string(t.received) + " received, " + std::to_string(t.entities) +
                     " foreign entities";
  std::string why;
  for (const auto& [reason, count] : t.Dropped())
    why += (why.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
  if (!why.empty()) text += "; dropped: " + why;
  if (t.unsent > 0) text += "; " + std::to_string(t.unsent) + " could not be sent";
  return text;
}

}  // namespace soarbox::dis
