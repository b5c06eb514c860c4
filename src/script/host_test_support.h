// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "script/script_host.h"

namespace soarbox::script {

/// Records what scripts print and their failures.
class Recorder final : public ScriptListener {
 public:
  void OnPrint(std::string_view, std::string_view text) override { prints.emplace_back(text); }
  void OnScriptFailed(world::EntityId agent, const ScriptError& error) override { errors.emplace_back(agent, error); }
  void OnScriptTrouble(const ScriptTrouble& trouble) override {
    troubles.push_back(trouble);
    if (trouble.kind != ScriptTrouble::Kind::kError) return;
    for (const world::EntityId agent : trouble.agents) errors.emplace_back(agent, trouble.error);
  }
  void OnErrorCount(const ErrorCount& count) override { counts.push_back(count); }
  void OnScriptWarning(const Diagnostic& warning) override { warnings.push_back(warning); }

  std::vector<std::string> prints;
  std::vector<std::pair<world::EntityId, ScriptError>> errors;
  std::vector<Diagnostic> warnings;
  std::vector<ScriptTrouble> troubles;
  std::vector<ErrorCount> counts;
};

/// A test double for the simulation: minds that give a fixed command.
class FixedMinds final : public MindFactory {
 public:
  Result<void> MakeMind(world::EntityId agent, const AgentCreationRequest& request) override {
    if (request.rules == "missing.soar") {
      Diagnostic error;
      error.message = "no such file: \"missing.soar\"";
      return error;
    }
    made.emplace_back(agent, request);
    return {};
  }
  std::vector<std::pair<world::EntityId, AgentCreationRequest>> made;
};

/// A sound of two samples.
inline std::string ShortWav() {
  static constexpr char kBytes[] =
      "RIFF\x26\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x40\x1f\0\0\x40\x1f\0\0\1\0\x08\0data\2\0\0\0\x80\x80";
  return {kBytes, sizeof kBytes - 1};
}

/// A world with scripts in a separate folder, which is searched before the folder of our library.
class HostTest : public testing::Test {
 protected:
  HostTest() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("soarbox_host_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    settings_.script_folders = {folder_, std::filesystem::path(SOARBOX_SOURCE_DIR) / "media" / "scripts"};
    settings_.sandbox_limits.instructions = 5'000'000;
    settings_.agent_limits.instructions = 1'000'000;
  }
  ~HostTest() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, std::string_view text) { std::ofstream(folder_ / name) << text; }

  /// Creates a new world; runs the sandbox's main script and Sandbox_Initialize.
  void Start(std::string_view main = "Sandbox.lua", std::uint64_t seed = 1) {
    host_.reset();
    recorder_ = {};
    minds_ = {};
    world::WorldSettings world_settings;
    world_settings.seed = seed;
    world_ = std::make_unique<world::World>(world_settings);
    host_ = std::make_unique<ScriptHost>(*world_, settings_, &minds_, recorder_);
    loaded_ = host_->LoadSandbox(main);
    if (loaded_) host_->Initialize();
    host_->TellTroubles();
  }
  void StartWith(std::string_view text, std::uint64_t seed = 1) {
    Write("Sandbox.lua", text);
    Start("Sandbox.lua", seed);
  }

  /// Executes one tick in the order of the simulation.
  void Tick() {
    host_->BeginTick();
    host_->DeliverEvents();
    const auto ids = world_->AgentIds();
    for (const world::EntityId id : std::vector(ids.begin(), ids.end())) {
      if (host_->IsLuaAgent(id)) {
        host_->UpdateAgent(id);
      } else {
        host_->UpdateAgent(id, CommandFor(id));
      }
      world_->SyncAgent(id);
    }
    world_->Step();
    host_->HandleCollisions();
    host_->UpdateSandbox();
    host_->TellTroubles();
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) Tick();
  }
  std::string CommandFor(world::EntityId id) const {
    const auto it = commands_.find(host_->RequestOf(id)->kind);
    return it == commands_.end() ? "none" : it->second;
  }

  /// Runs a text in the sandbox's (or an agent's) machine and returns what it printed, lines joined by "|"; "error:
  /// ..." if it failed.
  std::string Run(std::string_view text, world::EntityId who = world::EntityId::kSandbox) {
    recorder_.prints.clear();
    const auto error = host_->RunText(who, text);
    if (error) return "error: " + error->diagnostic.message;
    return Printed();
  }
  std::string Printed() const {
    std::string joined;
    for (const std::string& line : recorder_.prints) joined += (joined.empty() ? "" : "|") + line;
    return joined;
  }
  std::string Errors() const {
    std::string text;
    for (const auto& [agent, error] : recorder_.errors) text += Format(error);
    return text;
  }

  std::filesystem::path folder_;
  ScriptHostSettings settings_;
  Recorder recorder_;
  FixedMinds minds_;
  std::map<std::string, std::string> commands_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<ScriptHost> host_;
  bool loaded_ = false;
};

}  // namespace soarbox::script
