// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>

namespace soarbox::script {

/// Memory for the chunks of all machines of this process, allocated in blocks of the size of the processor's large
/// pages. A step of a crowd touches a little of each machine. With normal pages, address translation takes longer than
/// running the scripts. May be called on any thread.

/// Returns `bytes` bytes; null if there is no memory.
std::byte* TakePages(std::size_t bytes);
/// Releases them; `bytes` as in the call that allocated them.
void GivePagesBack(std::byte* pages, std::size_t bytes);

}  // namespace soarbox::script
