// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Kept so that programs which include it compile. WorkingMemory is an opaque part of Agent; its public faces are Agent
/// and the WMElement family.
#include "sml_ClientIdentifier.h"
#include "sml_DeltaList.h"
#include "sml_OutputDeltaList.h"
