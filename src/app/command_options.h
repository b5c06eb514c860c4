// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/editor_commands.h"
#include "app/engine/engine_window.h"
#include "app/inspect_command.h"
#include "app/kernel_server.h"
#include "app/learn_command.h"
#include "app/look_commands.h"
#include "app/manual.h"
#include "app/new_scenario.h"
#include "app/page_server.h"
#include "app/recording_commands.h"
#include "app/report_command.h"
#include "app/run_options.h"
#include "app/soar_shell.h"
#include "app/sweep_command.h"
#include "app/test_command.h"

namespace soarbox::app {

/// The options of all sub-commands.
struct CommandOptions {
  RunOptions run;
  SoarShellOptions soar;
  KernelServerOptions kernel;
  NewOptions made;
  RecordingOptions recording;  ///< Of all sub-commands for recordings.
  CheckOptions check;
  WhyOptions why;
  InspectOptions inspect;
  SweepOptions sweep;
  ReportOptions report;
  LearnOptions learn;
  TestOptions test;
  FormatOptions format;
  DatamapOptions datamap;
  std::string assistant_folder = ".";  ///< A coding assistant may read only files below this folder.
  ServeOptions serve;
  EngineOptions engine;
  HelpOptions help;
};

/// Adds all sub-commands and their options to the parser. Parsing fills in `options`, which must outlive the parser.
void AddCommands(CLI::App& program, CommandOptions& options);

}  // namespace soarbox::app
