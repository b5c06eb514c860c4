// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "sim/input.h"

namespace soarbox::sim {

/// The inputs that a text holds, and what is wrong with its lines.
struct InputText {
  InputList inputs;  ///< In ascending tick; those of one tick in the order of the text.
  std::vector<Diagnostic> problems;
};

/// Reads inputs as text, one per line; `#` begins a comment. Reports lines that are wrong and reads the others.
///
///   TICK key NAME down|up|press          press: down and up in one tick
///   TICK button NAME down|up|click X Y
///   TICK pointer X Y [DX DY]             without DX DY: as far as from the place before it in the text
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
/// Names and texts with blanks are between quotes, in which \n, \t, \" and \\ mean what they do in C; a text that does
/// not begin with a quote is the rest of its line.
InputText ReadInputs(std::string_view text, const std::string& file);

/// The line that ReadInputs reads this input from, without a line feed.
std::string WriteInput(const Input& input);

/// Such a line for people: what the client of recorded agents did in a tick is counted, "3 client: 2 command lines, 12
/// changes of input"; other lines are returned unchanged.
std::string ShownInput(const std::string& line);

}  // namespace soarbox::sim
