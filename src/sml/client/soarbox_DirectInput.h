// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>

#include "mind/input_writer.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// Opens the input link of an agent whose kernel is in this process, without the elements of the client API: the kernel
/// has the only copy of the input. For the project's own programs that write much input; not installed.
///
/// Returns null if the kernel is in another process or logs its clients' acts, or if the agent has a writer already.
/// Also returns null if other clients may connect: they would not see the time tags and names of this input.
///
/// `write_again` must add the entire input again: init-soar has removed it and made all handles invalid. It is called
/// after the input of the client API was restored. The handles of elements ascend in the order in which they are added.
/// Use the writer while a CallBatch exists (soarbox_Observation.h). Destroy it before its agent.
std::unique_ptr<mind::InputWriter> OpenDirectInput(sml::Agent& agent, std::function<void()> write_again);

}  // namespace soarbox
