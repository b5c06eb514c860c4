// SPDX-License-Identifier: BSD-2-Clause
// An agent whose rules use up all memory is halted permanently, with the reason; everything else continues.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <string>

#include "sml_Client.h"
#include "sml_test_files.h"

namespace {

using namespace sml;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

/// Limits this process to this number of additional bytes, while it exists.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) {
    getrlimit(RLIMIT_AS, &before_);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = before_;
    limit.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};
constexpr std::size_t kRoom = 150u << 20;

/// 400 values, and a rule that matches all combinations of four of them.
std::string ValueRule(int count = 400) {
  std::string rule = "sp {values (state <s> ^superstate nil) --> (<s> ^value";
  for (int value = 0; value < count; ++value) rule += " " + std::to_string(value);
  return rule + ")}\n";
}
constexpr const char* kExplodingRule =
    "sp {explode (state <s> ^value <a> ^value <b> ^value <c> ^value <d>) --> (<s> ^all yes)}\n";

/// In this process, and with a kernel on a socket.
class Memory : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (kSanitized) GTEST_SKIP() << "sanitizers need all addresses";
    server_.reset(Kernel::CreateKernelInNewThread(GetParam() ? Kernel::kUseAnyPort : Kernel::kSuppressListener));
    if (GetParam()) client_.reset(Kernel::CreateRemoteConnection(true, "127.0.0.1", server_->GetListenerPort()));
    ASSERT_FALSE(kernel().HadError()) << kernel().GetLastErrorDescription();
    greedy_ = kernel().CreateAgent("greedy");
    modest_ = kernel().CreateAgent("modest");
    const RuleFile rules("sml_memory_modest", kCounterRules);
    ASSERT_TRUE(modest_->LoadProductions(rules.path().c_str()));
    greedy_->RegisterForPrintEvent(
        smlEVENT_PRINT,
        [](smlPrintEventId, void* data, Agent*, char const* text) { *static_cast<std::string*>(data) += text; },
        &printed_);
  }

  Kernel& kernel() { return client_ ? *client_ : *server_; }
  static bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  void CheckEverythingElseGoesOn() {
    EXPECT_EQ(greedy_->GetRunState(), sml_RUNSTATE_HALTED);
    // Its memory can be read, but not changed.
    EXPECT_TRUE(Has(greedy_->ExecuteCommandLine("print s1"), "^superstate nil"));
    for (const char* line :
         {"matches", "matches values", "matches explode", "stats", "production memory-usage", "preferences s1 value",
          "print --stack", "excise explode", "wm remove 1", "wm add s1 ^x y"}) {
      greedy_->ExecuteCommandLine(line);
    }
    EXPECT_TRUE(Has(greedy_->InitSoar(), "halted for good"));
    EXPECT_FALSE(Has(greedy_->ExecuteCommandLine("sp {late (state <s> ^superstate nil) --> (<s> ^x y)}"), "*"));
    greedy_->GetInputLink()->CreateIntWME("n", 1);
    EXPECT_TRUE(Has(greedy_->RunSelf(1), "The agent ran out of memory: "));

    const int before = modest_->GetDecisionCycleCounter();
    modest_->RunSelf(5);
    EXPECT_EQ(modest_->GetDecisionCycleCounter(), before + 5);
    kernel().RunAllAgents(5);
    EXPECT_EQ(modest_->GetDecisionCycleCounter(), before + 10);

    // A new agent replaces it.
    EXPECT_TRUE(kernel().DestroyAgent(greedy_));
    greedy_ = kernel().CreateAgent("greedy");
    ASSERT_NE(greedy_, nullptr);
    EXPECT_FALSE(Has(greedy_->RunSelf(3), "memory"));
    EXPECT_TRUE(greedy_->GetLastCommandLineResult());
  }

  std::unique_ptr<Kernel> server_, client_;
  Agent* greedy_ = nullptr;
  Agent* modest_ = nullptr;
  std::string printed_;
};

TEST_P(Memory, ThatEndsInARunNamesTheRule) {
  const RuleFile rules("sml_memory_greedy", ValueRule() + kExplodingRule);
  std::string answer;
  {
    const MemoryLimit limit(kRoom);
    ASSERT_TRUE(greedy_->LoadProductions(rules.path().c_str())) << greedy_->GetLastErrorDescription();
    answer = greedy_->RunSelf(3);
    EXPECT_FALSE(greedy_->GetLastCommandLineResult());
    EXPECT_TRUE(Has(answer, "The agent ran out of memory: rule explode had ")) << answer;
    EXPECT_TRUE(Has(printed_, "agent greedy ran out of memory and is halted for good: rule explode had ")) << printed_;
    CheckEverythingElseGoesOn();
  }
}

TEST_P(Memory, ThatEndsWhileARuleIsLoadedNamesTheRule) {
  greedy_->ExecuteCommandLine(ValueRule().c_str());
  greedy_->RunSelf(1);
  const RuleFile rules("sml_memory_greedy", kExplodingRule);
  {
    const MemoryLimit limit(kRoom);
    EXPECT_FALSE(greedy_->LoadProductions(rules.path().c_str()));
    const std::string why = greedy_->GetLastErrorDescription();
    EXPECT_TRUE(Has(why, rules.path() + ":1")) << why;
    EXPECT_TRUE(Has(why, "there is no memory for the matches of explode")) << why;
    CheckEverythingElseGoesOn();
  }
}

TEST_P(Memory, ThatEndsWithAnElementAddedByHandIsTold) {
  greedy_->ExecuteCommandLine(ValueRule().c_str());
  greedy_->ExecuteCommandLine(
      "sp {explode (state <s> ^go yes ^value <a> ^value <b> ^value <c> ^value <d>) --> (<s> ^all yes)}");
  greedy_->RunSelf(1);
  {
    const MemoryLimit limit(kRoom);
    const std::string answer = greedy_->ExecuteCommandLine("wm add s1 ^go yes");
    EXPECT_TRUE(Has(answer, "there is no memory for the matches of the element")) << answer;
    EXPECT_TRUE(Has(printed_, "agent greedy ran out of memory and is halted for good: rule explode had ")) << printed_;
    CheckEverythingElseGoesOn();
  }
}

TEST_P(Memory, ThatARuleTakesByLoadingAnotherEndsTheRunWhereItStands) {
  // The conditions of the other rule do not begin at a state, so they match in all combinations.
  greedy_->ExecuteCommandLine("soar max-partial-matches 3000");
  greedy_->ExecuteCommandLine(
      "sp {values (state <s> ^superstate nil -^after) --> (<s> ^value 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18)}");
  greedy_->ExecuteCommandLine(
      "sp {go (state <s> ^value 18) --> (cmd sp |{all (<s> ^value <a>) (<t> ^value <b>) (<u> ^value <c>) --> "
      "(<s> ^all yes)}|) (<s> ^after yes)}");
  const std::string answer = greedy_->RunSelf(3);
  EXPECT_TRUE(Has(answer, "2 rules fired")) << answer;
  EXPECT_TRUE(Has(answer, "there is no room for the matches of rule all")) << answer;
  const std::string state = greedy_->ExecuteCommandLine("print s1");
  EXPECT_TRUE(Has(state, "^value 18")) << state;
  EXPECT_FALSE(Has(state, "^after")) << state << "nothing goes on without matches";
  CheckEverythingElseGoesOn();
}

TEST_P(Memory, ThatIsShortForOneCommandFailsThatCommandOnly) {
  // Half a million partial matches.
  greedy_->ExecuteCommandLine(ValueRule(1000).c_str());
  greedy_->ExecuteCommandLine(
      "sp {pairs (state <s> ^value <a> ^value {<b> > <a>} ^superstate <x>) (<x> ^never <y>) --> (<s> ^all yes)}");
  greedy_->RunSelf(1);
  {
    const MemoryLimit limit(1u << 20);
    EXPECT_TRUE(Has(greedy_->ExecuteCommandLine("matches --wmes pairs"), "There is no memory for this command."));
    EXPECT_FALSE(greedy_->GetLastCommandLineResult());
  }
  EXPECT_TRUE(Has(greedy_->ExecuteCommandLine("matches pairs"), "499500"));
  EXPECT_FALSE(Has(greedy_->RunSelf(3), "memory"));
  EXPECT_TRUE(greedy_->GetLastCommandLineResult());
}

INSTANTIATE_TEST_SUITE_P(Kernels, Memory, testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "Remote" : "InProcess"); });

}  // namespace
