// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>

namespace soarbox::script {

/// Memory for the chunks of all machines of this process, taken in blocks as long as the processor's large pages. A
/// crowd's step touches a little of each of its machines: with pages of the usual size, finding out where those lie
/// takes longer than running the scripts. For any thread.

/// This many bytes; null if there are none.
std::byte* TakePages(std::size_t bytes);
/// Gives them back; `bytes` as when they were taken.
void GivePagesBack(std::byte* pages, std::size_t bytes);

}  // namespace soarbox::script
