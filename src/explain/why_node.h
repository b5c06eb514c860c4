// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::explain {

/// What a step of an answer to *why* is about.
enum class WhyKind : std::uint8_t {
  kReason,
  kAgent,
  kCommand,
  kOperator,
  kPreference,
  kRule,
  kElement,
  kPercept,
  kLearned,
  kCondition,
  kRecall,
  kTopic,
  kImagined,
};

/// One step of an answer to *why*, with what it rests on. You can look at what `link` names, and ask about it in turn.
struct WhyNode {
  std::string text;
  WhyKind kind = WhyKind::kReason;
  std::string link;  ///< The agent's, operator's or rule's name, or an element's time tag; may be empty.
  std::vector<WhyNode> below;
  std::optional<double> time_s = std::nullopt;  ///< The moment that it is about, if that is another one than now.
};

/// As lines, each step two blanks deeper.
std::vector<std::string> Lines(const WhyNode& node, std::size_t indent = 0);
/// The same for an agent's account: what is below its first line is not indented. Empty without an account.
std::vector<std::string> AccountLines(const std::optional<WhyNode>& account);

}  // namespace soarbox::explain
