// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Kept so that programs which include it compile. In process every call is direct; there are no functions for it.
#include "Export.h"
