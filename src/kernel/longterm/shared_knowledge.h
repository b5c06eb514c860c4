// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {

/// The one Knowledge that all agents of the process use which know the very same: `own`, if it is the first of its
/// kind, else the one of those before. From then on nobody may change it; it lives as long as an agent uses it. Any
/// thread.
std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own);

}  // namespace soarbox::kernel
