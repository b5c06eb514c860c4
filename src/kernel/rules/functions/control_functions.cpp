// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <string>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

std::string Glued(FunctionContext& context, Arguments arguments) {
  std::string text;
  for (const Symbol argument : arguments) {
    AppendTo(text, context.symbols(), argument, false);
  }
  return text;
}

/// Reads the first argument as a number within limits. If it is not one, reports the expected range and returns false.
bool ChannelOf(FunctionContext& context, Arguments arguments, int lowest, int highest, const char* what, int& channel) {
  if (!arguments.empty() && arguments[0].IsInteger()) {
    const std::int64_t value = context.symbols().IntegerValue(arguments[0]);
    if (value >= lowest && value <= highest) {
      channel = static_cast<int>(value);
      return true;
    }
  }
  context.PrintError("Error: First argument of agent's " + std::string(what) + " between " + std::to_string(lowest) +
                     " and " + std::to_string(highest) + ".  " +
                     (arguments.empty() ? std::string("Nothing") : Name(context, arguments[0])) + " is invalid.\n");
  return false;
}

Symbol SetLearning(FunctionContext& context, Arguments arguments, const char* function, bool learn) {
  if (arguments.size() != 1 || !arguments[0].IsIdentifier()) {
    context.PrintError("Error: non-identifier (" + Glued(context, arguments) + ") passed to " + function +
                       " function.\n");
  } else if (!context.IsGoal(arguments[0])) {
    context.PrintError("Error: identifier passed to " + std::string(function) +
                       " is not a state: " + Name(context, arguments[0]) + ".\n");
  } else {
    context.SetLearning(arguments[0], learn);
  }
  return {};
}

/// Reports that `exec` or `cmd` has no arguments. The value is the text that Soar returns in this case.
Symbol NothingToCall(FunctionContext& context, const char* message) {
  context.PrintError(message);
  return context.symbols().String("error_expected_rhs_function_to_return_value_but_it_did_NOT");
}

}  // namespace

Symbol Write(FunctionContext& context, Arguments arguments) {
  context.Write(Glued(context, arguments));
  return {};
}

Symbol Crlf(FunctionContext& context, Arguments) {
  return context.symbols().String("\n");
}

Symbol Halt(FunctionContext& context, Arguments) {
  context.RequestHalt();
  return {};
}

Symbol Interrupt(FunctionContext& context, Arguments) {
  context.RequestInterrupt();
  return {};
}

Symbol Wait(FunctionContext& context, Arguments arguments) {
  if (arguments.size() == 1 && arguments[0].IsInteger()) {
    context.WaitMilliseconds(std::max<std::int64_t>(0, context.symbols().IntegerValue(arguments[0])));
  }
  return {};
}

/// In Soar this counts for a statistic that no command prints.
Symbol Count(FunctionContext&, Arguments) {
  return {};
}

Symbol Log(FunctionContext& context, Arguments arguments) {
  int channel = 0;
  if (ChannelOf(context, arguments, 1, 100, "(log) rhs-function must be an integer channel number", channel)) {
    context.Log(channel, Glued(context, arguments.subspan(1)));
  }
  return {};
}

Symbol Trace(FunctionContext& context, Arguments arguments) {
  int level = 0;
  if (ChannelOf(context, arguments, 0, 5, "(trace) rhs-function must be an integer trace level", level)) {
    context.Trace(level, Glued(context, arguments.subspan(1)));
  }
  return {};
}

Symbol Exec(FunctionContext& context, Arguments arguments) {
  if (arguments.empty()) {
    return NothingToCall(context, "exec should be followed by a function name \n");
  }
  const std::string name = ToString(context.symbols(), arguments[0], false);
  std::string result;
  if (!context.CallUserFunction(name, Glued(context, arguments.subspan(1)), result)) {
    result = "Error: Nobody was registered to implement rhs function " + name;
  }
  return context.symbols().String(result);
}

Symbol Cmd(FunctionContext& context, Arguments arguments) {
  if (arguments.empty()) {
    return NothingToCall(context, "cmd should be followed by a command name \n");
  }
  std::string line;
  for (const Symbol argument : arguments) {
    if (!line.empty()) {
      line += ' ';
    }
    AppendTo(line, context.symbols(), argument, false);
  }
  return context.symbols().String(context.RunCommand(line));
}

Symbol DecisionCycle(FunctionContext& context, Arguments) {
  return context.symbols().Integer(static_cast<std::int64_t>(context.DecisionCycle()));
}

Symbol Timestamp(FunctionContext& context, Arguments) {
  return context.symbols().String(context.Timestamp());
}

/// Returns the empty string, because there is no keyboard input.
Symbol Accept(FunctionContext& context, Arguments) {
  return context.symbols().String("");
}

Symbol DontLearn(FunctionContext& context, Arguments arguments) {
  return SetLearning(context, arguments, "dont-learn", false);
}
Symbol ForceLearn(FunctionContext& context, Arguments arguments) {
  return SetLearning(context, arguments, "force-learn", true);
}

Symbol LinkToLongTerm(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 2) {
    return {};
  }
  if (!arguments[0].IsIdentifier()) {
    context.PrintError("Error: '@' rhs function cannot accept " + Name(context, arguments[0]) +
                       " because it is not a Soar identifier\n");
    return {};
  }
  if (!arguments[1].IsInteger()) {
    context.PrintError("Error: '@' rhs function cannot accept " + Name(context, arguments[1]) +
                       " as an LTI ID because it is not an integer\n");
    return {};
  }
  const std::int64_t number = context.symbols().IntegerValue(arguments[1]);
  if (number <= 0) {
    context.PrintError("Warning: Long-term memory @" + std::to_string(static_cast<std::uint64_t>(number)) +
                       " does not exist.  Could not link short-term memory " + Name(context, arguments[0]) + ".\n");
    return {};
  }
  context.LinkToLongTerm(arguments[0], static_cast<std::uint64_t>(number));
  return {};
}

}  // namespace soarbox::kernel::function_bodies
