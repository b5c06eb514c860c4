// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "Export.h"

/// Programs written for Windows use TRUE and FALSE without a header of their own; sml_Client.h gives them the two
/// words. Define SOARBOX_SML_NO_TRUE before including it to keep them out.
#if !defined(SOARBOX_SML_NO_TRUE)
#if !defined(TRUE)
#define TRUE 1
#endif
#if !defined(FALSE)
#define FALSE 0
#endif
#endif
