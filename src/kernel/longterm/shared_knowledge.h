// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string_view>

#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {

/// The one Knowledge that all agents of the process use which know the very same: `own`, if it is the first of its
/// kind, else the one of those before. From then on nobody may change it; it lives as long as an agent uses it. Any
/// thread.
std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own);

/// What a text of `smem --add` is recognised by when the next agent reads it into an empty memory.
struct TextKey {
  std::uint64_t first = 0, second = 0, size = 0;
  Lti next_number = 0;  ///< Where the numbers of new objects began.
  auto operator<=>(const TextKey&) const = default;
};
TextKey KeyOfText(std::string_view text, Lti next_number);
/// The shared knowledge that came of this text in an empty memory, if an agent still uses it, else null. Any thread.
std::shared_ptr<Knowledge> KnowledgeOfText(const TextKey& key);
void NoteKnowledgeOfText(const TextKey& key, const std::shared_ptr<Knowledge>& shared);

}  // namespace soarbox::kernel
