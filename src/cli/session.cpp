// SPDX-License-Identifier: BSD-2-Clause
#include "cli/session.h"

#include <fstream>

#include "cli/percepts.h"
#include "cli/rl_update_log.h"
#include "cli/setting_store.h"
#include "cli/stack_printer.h"
#include "cli/trace_printer.h"
#include "kernel/agent.h"

namespace soarbox::cli {

struct Session::LogFile {
  std::ofstream stream;
};

Session::Session(kernel::Agent& agent, std::string name)
    : agent_(agent),
      name_(std::move(name)),
      times_(agent),
      settings_(std::make_unique<SettingStore>()),
      trace_printer_(std::make_unique<TracePrinter>(*this)),
      rl_update_log_(std::make_unique<RlUpdateLog>(agent)) {
  UpdateTrace();
  // The agent has already announced its first state; objects are wrapped as if that line had been printed here.
  if (!agent.goals().empty()) {
    stream_.SetColumn(static_cast<int>(StateLine(agent, agent.Describe(agent.goals().top()), "0").size()));
  }
}

Session::~Session() = default;

void Session::UpdateTrace() {
  trace_printer_->Update();
}

bool Session::SetReinforcementLog(const std::string& path) {
  return rl_update_log_->SetPath(path);
}

bool Session::OpenLog(const std::string& path, bool append) {
  auto log = std::make_unique<LogFile>();
  log->stream.open(path, append ? std::ios::app : std::ios::trunc);
  if (!log->stream) return false;
  log_ = std::move(log);
  stream_.SetCopy([this](std::string_view text) {
    if (!stream_.captured()) Log(text);
  });
  return true;
}

void Session::CloseLog() {
  log_.reset();
  stream_.SetCopy(nullptr);
}

bool Session::log_open() const {
  return log_ != nullptr;
}

void Session::Log(std::string_view text) {
  if (!log_) return;
  log_->stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  log_->stream.flush();
}

}  // namespace soarbox::cli
