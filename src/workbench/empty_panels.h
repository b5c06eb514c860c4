// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::workbench {

/// The text of an empty panel that no document describes: what is missing, and what to do about it. The window and
/// pages show the same text.
struct EmptyPanel {
  std::string_view what, advice;
};

inline constexpr EmptyPanel kEmptyTimeline{"Nothing has happened yet.",
                                           "Let the world run: operators, commands and events appear here."};
inline constexpr EmptyPanel kEmptyEdit{"No file is open.", "Choose one above, or press Edit at a rule."};

}  // namespace soarbox::workbench
