// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "ElementXML.h"
#include "sml_Events.h"
#include "sml_Names.h"

namespace sml {

/// An internal part of Kernel.
class Connection;

}  // namespace sml
