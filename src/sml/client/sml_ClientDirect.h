// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Exists so that programs that include it compile. It declares nothing: calls within a process are always direct.
#include "Export.h"
