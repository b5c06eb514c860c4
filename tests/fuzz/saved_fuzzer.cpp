// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the readers of files that the command language writes: recordings of input, and images of
// rules (with a corrected header, so that the reader continues). The contents are executed.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cli/percepts.h"
#include "cli/rule_image.h"
#include "growth_limit.h"

namespace {

using namespace soarbox;

std::string WithHeader(std::string_view payload) {
  std::string image(cli::rule_image::kMagic);
  const auto fixed = [&](std::uint64_t number, int size) {
    for (int i = 0; i < size; ++i) image += static_cast<char>(number >> (8 * i));
  };
  fixed(cli::rule_image::kVersion, 4);
  fixed(payload.size(), 8);
  fixed(cli::rule_image::Checksum(payload), 8);
  return image + std::string(payload);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
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
  auto rules = cli::ReadRuleImage(WithHeader(bytes), "file", agent.mutable_symbols());
  if (!rules) return 0;
  for (kernel::ProductionPtr& rule : *rules) agent.AddProduction(std::move(rule));
  agent.Run(kernel::RunUnit::kDecision, 3);
  return 0;
}
