// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "sim/input.h"

namespace soarbox::sim {

/// The inputs in a text, and the problems of its lines.
struct InputText {
  InputList inputs;  ///< Sorted by tick; inputs of the same tick are in the order of the text.
  std::vector<Diagnostic> problems;
};

/// Parses inputs, one per line; `#` begins a comment. Skips and reports lines with errors.
///
///   TICK key NAME down|up|press          press: down and up in one tick
///   TICK button NAME down|up|click X Y
///   TICK pointer X Y [DX DY]             without DX DY: the difference from the previous position in the text
///   TICK wheel NOTCHES [X Y]
///   TICK panel BUTTON                    the name that a script gave a button on the screen
///   TICK pad NUMBER BUTTON down|up|press
///   TICK pad NUMBER AXIS VALUE           from -1 to 1
///   TICK screen WIDTH HEIGHT
///   TICK camera X Y Z [QW QX QY QZ]
///   TICK command AGENT TEXT              a line for the agent's Soar mind
///   TICK script AGENT|sandbox TEXT       Lua for the agent's machine
///   TICK order AGENT TEXT
///   TICK foreign ID NAME TEAM BODY HEALTH STANCE X Y Z VX VY VZ AX AY AZ HEADING TURN
///   TICK foreign-gone ID
///   TICK foreign-shot ID TARGET|"" DAMAGE RADIUS X Y Z X Y Z
///   TICK foreign-message ID TEAM|"" ABOUT TEXT
///
/// Names and texts with blanks are quoted. In quotes, \n, \t, \" and \\ have the same meaning as in C. A text that does
/// not begin with a quote extends to the end of the line.
InputText ReadInputs(std::string_view text, const std::string& file);

/// Returns a line that ReadInputs converts to this input, without a line feed.
std::string WriteInput(const Input& input);

/// Shortens such a line for display: it counts what the client of recorded agents did in a tick, "3 client: 2 command
/// lines, 12 changes of input". Returns other lines unchanged.
std::string ShownInput(const std::string& line);

}  // namespace soarbox::sim
