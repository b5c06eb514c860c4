// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::sim {

/// What an agent does after its script or its Soar program has failed, for users.
inline constexpr char kStoppedByError[] = "stopped by an error";

}  // namespace soarbox::sim
