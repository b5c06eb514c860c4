// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the readers of files that the command language writes: recordings of input, and images of
// rules (after the first line, which is added so that the reader continues). The contents are executed.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cli/load_image.h"
#include "cli/percepts.h"
#include "growth_limit.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace soarbox;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  GrowthLimit limit;
  kernel::Agent agent("fuzz");
  limit.Guard(agent);
  if (bytes.starts_with("soarbox")) {
    auto file = cli::ReadPercepts(bytes, "file");
    if (!file) return 0;
    cli::PerceptPlayer player(agent, *std::move(file), [](const std::string&) {});
    agent.Run(kernel::RunUnit::kDecision, 5);
    return 0;
  }
  const auto rules = cli::ReadRuleImage(std::string(cli::kImageStart).append(bytes), "file", agent);
  if (!rules) return 0;
  for (const cli::Word& rule : *rules) cli::AddImageRule(agent, rule, "file");
  agent.Run(kernel::RunUnit::kDecision, 3);
  return 0;
}
