// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Exists so that programs that include it compile. WorkingMemory is an internal part of Agent; use Agent and the
/// WMElement classes.
#include "sml_ClientIdentifier.h"
#include "sml_DeltaList.h"
#include "sml_OutputDeltaList.h"
