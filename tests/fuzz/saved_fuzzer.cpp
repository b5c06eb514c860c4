// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the reader of recordings of input, which the command language writes. The contents are
// executed.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cli/percepts.h"
#include "growth_limit.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace soarbox;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  GrowthLimit limit;
  kernel::Agent agent("fuzz");
  limit.Guard(agent);
  auto file = cli::ReadPercepts(bytes, "file");
  if (!file) return 0;
  cli::PerceptPlayer player(agent, *std::move(file), [](const std::string&) {});
  agent.Run(kernel::RunUnit::kDecision, 5);
  return 0;
}
