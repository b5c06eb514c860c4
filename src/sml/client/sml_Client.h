// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Everything that a program needs to create or join a kernel, host agents in it, and drive them.
///
///   sml::Kernel* kernel = sml::Kernel::CreateKernelInNewThread();
///   sml::Agent* agent = kernel->CreateAgent("scout");
///   agent->LoadProductions("scout.soar");
///   sml::FloatElement* range = agent->CreateFloatWME(agent->GetInputLink(), "range_m", 10.0);
///   agent->RunSelfTilOutput();
///   for (int i = 0; i < agent->GetNumberCommands(); ++i) agent->GetCommand(i)->AddStatusComplete();
///
/// Names, signatures and constants are those of Soar 9.6's client library, so that programs compile with either
/// library.
#include "portability.h"
#include "sml_ClientAgent.h"
#include "sml_ClientAnalyzedXML.h"
#include "sml_ClientEvents.h"
#include "sml_ClientFloatElement.h"
#include "sml_ClientIdentifier.h"
#include "sml_ClientIntElement.h"
#include "sml_ClientKernel.h"
#include "sml_ClientStringElement.h"
#include "sml_ClientTraceXML.h"
#include "sml_ClientXML.h"
