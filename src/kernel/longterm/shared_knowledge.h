// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string_view>

#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {

/// The one Knowledge for all agents of the process that know exactly the same: `own` if it is the first of its kind,
/// otherwise the earlier one. From then on nobody may change it; it lives as long as an agent uses it. Any thread.
std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own);

/// Identifies a text of `smem --add` when the next agent reads it into an empty memory.
struct TextKey {
  std::uint64_t first = 0, second = 0, size = 0;
  Lti next_number = 0;  ///< Where the numbers of new objects began.
  auto operator<=>(const TextKey&) const = default;
};
TextKey KeyOfText(std::string_view text, Lti next_number);
/// The shared knowledge made from this text in an empty memory, if an agent still uses it, otherwise null. Any thread.
std::shared_ptr<Knowledge> KnowledgeOfText(const TextKey& key);
void NoteKnowledgeOfText(const TextKey& key, const std::shared_ptr<Knowledge>& shared);

}  // namespace soarbox::kernel
