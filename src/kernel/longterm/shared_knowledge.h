// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string_view>

#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {

/// Returns the shared Knowledge for all agents of the process with equal knowledge: `own` if it is the first, otherwise
/// the earlier one. It must not be changed from then on. It lives as long as an agent uses it. Callable from any
/// thread.
std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own);

/// Identifies a text of `smem --add`, so that other agents that read it into an empty memory can share the result.
struct TextKey {
  std::uint64_t first = 0, second = 0, size = 0;
  Lti next_number = 0;  ///< The first number for new objects.
  auto operator<=>(const TextKey&) const = default;
};
TextKey KeyOfText(std::string_view text, Lti next_number);
/// The shared knowledge created from this text in an empty memory, if an agent still uses it; otherwise null. Callable
/// from any thread.
std::shared_ptr<Knowledge> KnowledgeOfText(const TextKey& key);
void NoteKnowledgeOfText(const TextKey& key, const std::shared_ptr<Knowledge>& shared);

}  // namespace soarbox::kernel
