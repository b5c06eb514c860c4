// SPDX-License-Identifier: BSD-2-Clause
#include "app/kernel_watch.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "app/kernel_address.h"
#include "diagnostics/problem.h"
#include "record/client_ticks.h"
#include "sim/client_world.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_ClientLog.h"
#endif

namespace soarbox::app {

namespace {

namespace fs = std::filesystem;

/// Interval at which the kernel is asked again after it had nothing new.
constexpr auto kNextLook = std::chrono::milliseconds(20);

Result<std::unique_ptr<sml::Kernel>> ConnectTo(const sim::SoarSettings& settings) {
  std::unique_ptr<sml::Kernel> kernel(
      sml::Kernel::CreateRemoteConnection(true, settings.remote_host.c_str(), settings.remote_port));
  if (!kernel->HadError()) return kernel;
  const char* const why = kernel->GetLastErrorDescription();
  return NewProblem("no Soar kernel answers at " + settings.remote_host + ":" + std::to_string(settings.remote_port) +
                        (why == nullptr ? "" : std::string(" (") + why + ")"),
                    "soarbox kernel --port " + std::to_string(settings.remote_port) + " starts one");
}

/// Updates the list of agents: other programs may have made some.
template <typename Kernel>
void FindNewAgents(Kernel& kernel) {
  if constexpr (requires { kernel.UpdateAgentList(); }) kernel.UpdateAgentList();
}

Result<std::string> CarryOut(sml::Kernel& kernel, const std::string& agent, const std::string& line) {
  const char* const text = kernel.ExecuteCommandLine(line.c_str(), agent.c_str());
  std::string answer = text == nullptr ? "" : text;
  if (kernel.GetLastCommandLineResult()) return answer;
  return NewProblem(answer.empty() ? "the kernel does not carry this out: " + line : std::move(answer));
}

/// For a kernel without a log. Asks the kernel at intervals whether its agents have decided. Each query that finds a
/// change is a tick. The run inspects the agents over its own connection.
class LookWatch final : public KernelWatch {
 public:
  LookWatch(std::unique_ptr<sml::Kernel> kernel, sim::SoarSettings address)
      : kernel_(std::move(kernel)), address_(std::move(address)) {}
  ~LookWatch() override { kernel_->Shutdown(); }

  void Prepare(sim::SoarSettings& settings) const override {
    settings.remote_host = address_.remote_host;
    settings.remote_port = address_.remote_port;
    settings.remote_limit_ms = kPatience_ms;
  }
  [[nodiscard]] std::string Remark() const override {
    return "this kernel keeps no log: panels show the present only. A kernel of soarbox kernel, or of a program that "
           "runs with SOARBOX_RECORD=FILE in its environment, keeps one";
  }
  Result<sim::Scenario> World(const sim::DataFolders& data) override {
    return sim::FindScenario(sim::kClientWorld, data);
  }

  const std::string* After(std::uint64_t tick) override {
    if (tick >= ticks_.size()) Look();
    return tick < ticks_.size() ? &ticks_[tick] : nullptr;
  }
  void Sync() override { next_look_ = {}; }
  [[nodiscard]] bool HasEnded() const override { return has_ended_; }
  std::string TakeNews() override { return std::exchange(news_, {}); }
  Result<std::string> Command(const std::string& agent, const std::string& line) override {
    return CarryOut(*kernel_, agent, line);
  }

 private:
  static constexpr int kPatience_ms = 10'000;

  void Look() {
    const auto now = std::chrono::steady_clock::now();
    if (has_ended_ || now < next_look_) return;
    next_look_ = now + kNextLook;
    FindNewAgents(*kernel_);
    if (kernel_->IsConnectionClosed()) {
      news_ = "the kernel has ended";
      has_ended_ = true;
      return;
    }
    std::string acts;
    std::map<std::string, int> decided;
    for (int i = 0; i < kernel_->GetNumberAgents(); ++i) {
      sml::Agent& agent = *kernel_->GetAgentByIndex(i);
      const std::string name = agent.GetAgentName();
      decided[name] = agent.GetDecisionCycleCounter();
      const auto known = decided_.find(name);
      if (known == decided_.end()) acts += sim::ClientLine({"attach", name}) + "\n";
      if (known == decided_.end() || known->second != decided[name]) acts += sim::ClientLine({"look", name}) + "\n";
    }
    for (const auto& [name, decisions] : decided_)
      if (!decided.contains(name)) acts += sim::ClientLine({"gone", name}) + "\n";
    decided_ = std::move(decided);
    if (!acts.empty()) ticks_.push_back(std::move(acts));
  }

  std::unique_ptr<sml::Kernel> kernel_;
  sim::SoarSettings address_;
  std::vector<std::string> ticks_;
  std::map<std::string, int> decided_;  ///< By agent: its number of decisions when it was asked last.
  std::chrono::steady_clock::time_point next_look_;
  std::string news_;
  bool has_ended_ = false;
};

#ifdef SOARBOX_OWN_KERNEL

class LogWatch final : public KernelWatch {
 public:
  LogWatch(std::unique_ptr<sml::Kernel> kernel, fs::path copies)
      : kernel_(std::move(kernel)),
        copies_(std::move(copies)),
        ticks_([this](const std::string& path, const std::string& content) { Keep(path, content); }) {}
  ~LogWatch() override {
    is_ending_ = true;
    if (reader_.joinable()) reader_.join();
    if (kernel_ != nullptr) kernel_->Shutdown();
    std::error_code ignored;
    fs::remove_all(copies_, ignored);
  }

  /// Reads the existing log; then a thread continues to read. Returns false if the kernel keeps no log.
  bool Begin() {
    while (true) {
      const std::optional<ClientLogPart> part = ReadClientLog(*kernel_, read_);
      if (read_ == 0 && (!part || part->has_ended)) return false;
      if (!part || part->text.empty()) break;
      read_ += part->text.size();
      unread_ += part->text;
    }
    reader_ = std::thread([this] { Read(); });
    return true;
  }
  std::unique_ptr<sml::Kernel> TakeKernel() { return std::move(kernel_); }

  Result<sim::Scenario> World(const sim::DataFolders& data) override {
    Result<sim::Scenario> scenario = sim::FindScenario(sim::kClientWorld, data, {copies_});
    if (scenario) scenario->stand_ins.emplace_back(copies_, "/");
    return scenario;
  }

  const std::string* After(std::uint64_t tick) override {
    if (tick >= ticks_.complete()) TakeLines();
    return tick < ticks_.complete() ? &ticks_.At(tick) : nullptr;
  }

  void Sync() override {
    std::unique_lock lock(mutex_);
    // Waits for two reads without news, because a read that is in progress may have begun before the command.
    const std::uint64_t wanted = idle_looks_ + 2;
    constexpr auto kLongest = std::chrono::seconds(1);
    looked_.wait_for(lock, kLongest, [&] { return is_over_ || idle_looks_ >= wanted; });
  }

  [[nodiscard]] bool HasEnded() const override { return has_ended_; }
  std::string TakeNews() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
  }

  Result<std::string> Command(const std::string& agent, const std::string& line) override {
    return CarryOut(*kernel_, agent, line);
  }

 private:
  /// Reads the log until the kernel ends. Runs on a separate thread, because a busy kernel answers late.
  void Read() {
    while (!is_ending_) {
      const std::optional<ClientLogPart> part = ReadClientLog(*kernel_, read_);
      if (!part && kernel_->IsConnectionClosed()) return End("the kernel has ended");
      if (part && part->has_ended) return End("the log of this kernel has ended");
      if (!part || part->text.empty()) {
        SetIdle();
        std::this_thread::sleep_for(kNextLook);
        continue;
      }
      read_ += part->text.size();
      const std::lock_guard lock(mutex_);
      unread_ += part->text;
      is_idle_ = false;
    }
  }
  void SetIdle() {
    const std::lock_guard lock(mutex_);
    is_idle_ = true;
    ++idle_looks_;
    looked_.notify_all();
  }
  void End(const std::string& why) {
    const std::lock_guard lock(mutex_);
    news_ = why + ": you can still look at what its agents did";
    is_idle_ = true;
    is_over_ = true;
    looked_.notify_all();
  }

  void TakeLines() {
    std::string text;
    bool is_last = false, is_all = false;
    {
      const std::lock_guard lock(mutex_);
      text = std::exchange(unread_, {});
      is_last = is_over_;
      is_all = is_idle_;
    }
    rest_ += text;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = rest_.find('\n', begin)) != std::string::npos; begin = end + 1)
      ticks_.Add(std::string_view(rest_).substr(begin, end - begin));
    rest_.erase(0, begin);
    // The end of a tick is known when the next one begins. If the log has nothing more, the tick is complete now.
    if (is_all) ticks_.Flush();
    if (is_last && text.empty()) has_ended_ = true;
  }

  /// Stores a copy of a client's file. The run loads the copy, because the client's file may change.
  void Keep(const std::string& path, const std::string& content) {
    const fs::path name = fs::path(path).lexically_normal().relative_path();
    if (name.empty() || *name.begin() == "..") return;
    std::error_code error;
    fs::create_directories((copies_ / name).parent_path(), error);
    std::ofstream(copies_ / name, std::ios::binary) << content;
  }

  std::unique_ptr<sml::Kernel> kernel_;
  fs::path copies_;
  record::ClientTicks ticks_;
  std::string rest_;  ///< The beginning of a line whose end has not been read yet.
  bool has_ended_ = false;
  std::thread reader_;
  std::atomic<bool> is_ending_{false};
  std::uint64_t read_ = 0;  ///< Bytes of the log that were read. Used only by reader_ once that runs.
  std::mutex mutex_;        ///< Guards the members after it.
  std::string unread_, news_;
  std::uint64_t idle_looks_ = 0;  ///< Number of reads that found nothing new.
  std::condition_variable looked_;
  bool is_over_ = false;
  bool is_idle_ = true;  ///< The last read found nothing new.
};

#endif

}  // namespace

Result<std::unique_ptr<KernelWatch>> KernelWatch::Connect(const std::string& address) {
  sim::SoarSettings settings;
  if (const Result<void> read = ReadKernelAddress(address, settings); !read) return read.error();
  Result<std::unique_ptr<sml::Kernel>> connected = ConnectTo(settings);
  if (!connected) return connected.error();
  std::unique_ptr<sml::Kernel> kernel = std::move(*connected);
#ifdef SOARBOX_OWN_KERNEL
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "soarbox-watch-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    return NewProblem("no folder can be made for copies of the agents' files: " + std::string(std::strerror(errno)));
  auto watch = std::make_unique<LogWatch>(std::move(kernel), folder);
  if (watch->Begin()) return std::unique_ptr<KernelWatch>(std::move(watch));
  kernel = watch->TakeKernel();
#endif
  return std::unique_ptr<KernelWatch>(std::make_unique<LookWatch>(std::move(kernel), settings));
}

}  // namespace soarbox::app
