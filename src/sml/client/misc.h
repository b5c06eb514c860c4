// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Kept so that programs which include it beside sml_Client.h compile.
#include "portability.h"
