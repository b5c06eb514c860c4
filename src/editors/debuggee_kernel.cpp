// SPDX-License-Identifier: BSD-2-Clause
// Minds in a kernel without a world, in this process or another one.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "debugger/breakpoints.h"
#include "debugger/why.h"
#include "diagnostics/problem.h"
#include "editors/debuggee.h"
#include "language/visual_soar.h"
#include "sml_Client.h"

namespace soarbox::editors {
namespace {

Diagnostic NoKernel(std::string message, std::string hint = {}) {
  return NewProblem(std::move(message), std::move(hint));
}

class KernelDebuggee final : public Debuggee {
 public:
  explicit KernelDebuggee(std::unique_ptr<sml::Kernel> kernel) : kernel_(std::move(kernel)) {}

  std::vector<std::string> Agents() const override {
    std::vector<std::string> agents;
    for (int i = 0; i < kernel_->GetNumberAgents(); ++i)
      agents.emplace_back(kernel_->GetAgentByIndex(i)->GetAgentName());
    return agents;
  }

  std::unique_ptr<explain::Inspector> Inspect(const std::string& agent) override {
    sml::Agent* const found = kernel_->GetAgent(agent.c_str());
    return found == nullptr ? nullptr : explain::MakeInspector(*found);
  }

  StopReasons Advance(Step step, const std::string& agent) override {
    sml::Agent* const mind = kernel_->GetAgent(agent.c_str());
    if (mind == nullptr) return {{"there is no agent " + agent}};
    std::map<std::string, std::uint64_t> fired;
    for (const std::string& rule : stop_rules_) fired[rule] = FiringsOf(*mind, rule);
    const std::string text = mind->ExecuteCommandLine(step == Step::kPhase ? "run --phase 1" : "run --decision 1");
    if (!text.empty()) news_.push_back(text);
    StopReasons why;
    for (const auto& [rule, before] : fired)
      if (FiringsOf(*mind, rule) > before)
        why.push_back({agent + ": rule " + rule + " fired", StopReason::Kind::kMind, agent, rule});
    const std::unique_ptr<explain::Inspector> looks = explain::MakeInspector(*mind);
    halted_ = looks->Mind().halted;
    CheckWishes(agent, *looks, why);
    return why;
  }

  Result<void> GoBack() override {
    return NoKernel("a kernel without a world does not go back", "launch a scenario or a recording");
  }

  Result<void> Restart() override {
    for (const std::string& agent : Agents()) kernel_->GetAgent(agent.c_str())->ExecuteCommandLine("init-soar");
    selected_.clear();
    seen_.clear();
    halted_ = false;
    return {};
  }

  Result<std::string> Command(const std::string& agent, const std::string& line) override {
    sml::Agent* const mind = kernel_->GetAgent(agent.c_str());
    if (mind == nullptr) return NoKernel("there is no agent " + agent);
    const std::string text = mind->ExecuteCommandLine(line.c_str());
    if (!mind->GetLastCommandLineResult()) return NoKernel(text.empty() ? "the command fails" : text);
    return text;
  }

  Result<explain::WhyNode> Why(const std::string& agent, const std::string& topic) override {
    const std::unique_ptr<explain::Inspector> mind = Inspect(agent);
    if (mind == nullptr) return NoKernel("there is no agent " + agent);
    std::string wanted = topic;
    const std::vector<explain::StateFact> stack = mind->Stack();
    for (auto state = stack.rbegin(); state != stack.rend() && wanted.empty(); ++state) wanted = state->operator_id;
    if (const auto why = debugger::WhyOperator(*mind, wanted)) return *why;
    if (const auto why = debugger::WhyCommand(*mind, wanted)) return *why;
    if (wanted.empty()) return NoKernel("no operator is selected");
    return NoKernel("no operator and no command is called " + wanted, "matches RULE shows how far a rule matches");
  }

  void SetStops(const std::vector<std::string>& rules, const std::vector<StopWish>& wishes) override {
    stop_rules_ = rules;
    wishes_ = wishes;
    for (const StopWish& wish : wishes)
      if (wish.kind == "fire") stop_rules_.push_back(wish.what);
  }

  bool HasEnded() const override { return halted_; }
  bool CanGoBack() const override { return false; }
  std::string When() const override {
    const std::vector<std::string> agents = Agents();
    if (agents.empty()) return "no agents";
    const explain::MindFacts facts = explain::MakeInspector(*kernel_->GetAgent(agents.front().c_str()))->Mind();
    return "decision " + std::to_string(facts.decisions) + (facts.phase.empty() ? "" : ", before " + facts.phase);
  }
  std::vector<std::string> TakeNews() override { return std::exchange(news_, {}); }

 private:
  static std::uint64_t FiringsOf(sml::Agent& mind, const std::string& rule) {
    const std::string text = mind.ExecuteCommandLine(("production firing-counts " + rule).c_str());
    const std::size_t digit = text.find_first_of("0123456789");
    if (text.find(rule) == std::string::npos || digit == std::string::npos) return 0;
    return std::strtoull(text.c_str() + digit, nullptr, 10);
  }

  void CheckWishes(const std::string& agent, explain::Inspector& mind, StopReasons& why) {
    const auto add = [&](const std::string& what) {
      why.push_back({agent + ": " + what, StopReason::Kind::kMind, agent});
    };
    const std::vector<explain::StateFact> stack = mind.Stack();
    std::vector<std::string> selected;
    for (const explain::StateFact& state : stack) selected.push_back(state.id + state.operator_id);
    const std::vector<std::string> before = std::exchange(selected_[agent], selected);
    for (const StopWish& wish : wishes_) {
      for (std::size_t i = 0; i < stack.size(); ++i) {
        const bool is_new = std::ranges::find(before, selected[i]) == before.end();
        if (wish.kind == "operator" && is_new && stack[i].operator_name == wish.what)
          add("operator " + wish.what + " was selected");
        const bool is_new_state =
            std::ranges::none_of(before, [&](const std::string& one) { return one.starts_with(stack[i].id); });
        if (wish.kind == "impasse" && is_new_state && stack[i].impasse != "none" &&
            (stack[i].attribute + " " + stack[i].impasse).find(wish.what) != std::string::npos)
          add("impasse " + stack[i].attribute + " " + stack[i].impasse);
      }
      if (wish.kind != "element") continue;
      constexpr std::size_t kMost = 200;
      const std::size_t sign = wish.what.find('^');
      const std::string attribute = wish.what.substr(sign == std::string::npos ? 0 : sign + 1);
      std::uint64_t& newest = seen_[agent + wish.what];
      std::uint64_t last = newest;
      for (const explain::ElementFact& element : mind.Search(attribute.substr(0, attribute.find(' ')), kMost)) {
        if (!debugger::IsLike(element, wish.what) || element.timetag <= newest) continue;
        if (element.timetag > last) last = element.timetag;
        add("element " + element.id + " ^" + element.attribute + " " + element.value);
      }
      newest = last;
    }
  }

  std::unique_ptr<sml::Kernel> kernel_;
  std::vector<std::string> stop_rules_;
  std::vector<StopWish> wishes_;
  std::map<std::string, std::vector<std::string>> selected_;
  std::map<std::string, std::uint64_t> seen_;
  std::vector<std::string> news_;
  bool halted_ = false;
};

}  // namespace

std::optional<StopWish> ReadStopWish(const std::string& text) {
  const std::size_t blank = std::min(text.find(' '), text.size());
  const std::size_t what = std::min(text.find_first_not_of(' ', blank), text.size());
  StopWish wish{text.substr(0, blank), text.substr(what)};
  if (wish.kind == "operator") return wish.what.empty() ? std::nullopt : std::optional<StopWish>(wish);
  if (!debugger::BreakKindNamed(wish.kind)) return std::nullopt;
  return wish;
}

Result<std::unique_ptr<Debuggee>> LaunchKernel(const LaunchRequest& request) {
  std::filesystem::path rules = request.program;
  if (language::IsVisualSoarProject(rules)) rules = language::RootOfProject(rules);
  std::error_code error;
  if (!std::filesystem::is_regular_file(rules, error))
    return NoKernel("there is no file of rules " + request.program, "name a file that ends in .soar");
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInNewThread(sml::Kernel::kUseAnyPort));
  if (kernel == nullptr || kernel->HadError()) return NoKernel("the kernel does not start");
  sml::Agent* const agent = kernel->CreateAgent(rules.stem().string().c_str());
  if (agent == nullptr) return NoKernel("the kernel refuses an agent of this name");
  agent->ExecuteCommandLine("watch 0");
  agent->LoadProductions(std::filesystem::absolute(rules, error).string().c_str());
  return std::unique_ptr<Debuggee>(std::make_unique<KernelDebuggee>(std::move(kernel)));
}

Result<std::unique_ptr<Debuggee>> AttachKernel(int port) {
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateRemoteConnection(true, nullptr, port));
  if (kernel == nullptr || kernel->HadError())
    return NoKernel("no kernel answers at port " + std::to_string(port) + " of this machine",
                    "soarbox kernel --port " + std::to_string(port) + " FILE starts one");
  return std::unique_ptr<Debuggee>(std::make_unique<KernelDebuggee>(std::move(kernel)));
}

}  // namespace soarbox::editors
