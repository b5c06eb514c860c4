// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/random.h"
#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

/// The interface through which right-hand-side functions access the firing agent. The core implements it; the
/// functions access nothing else. Single-threaded; used only while a rule fires.
class FunctionContext {
 public:
  /// An element of an identifier, for functions that inspect working memory.
  struct Child {
    Symbol attribute;
    Symbol value;
    WmeId element = WmeId::kNone;  ///< The element, if there is one.
  };

  virtual ~FunctionContext() = default;

  virtual SymbolTable& symbols() = 0;
  virtual RandomStream& random() = 0;

  // Text and control ----------------------------------------------------------------------------------------------

  /// Prints a message of the architecture ("Error: ...") unchanged. The text ends with a line end; it begins with one
  /// only if Soar's message does.
  virtual void PrintError(std::string_view text) = 0;
  /// Prints text that a rule writes, unless the agent's writes are disabled.
  virtual void Write(std::string_view text) = 0;
  /// Prints to a log channel (1 to 9) if that channel is on.
  virtual void Log(int channel, std::string_view text) = 0;
  /// Prints if the trace of that level (0 to 5) is on.
  virtual void Trace(int level, std::string_view text) = 0;
  virtual void RequestHalt() = 0;
  virtual void RequestInterrupt() = 0;
  virtual void WaitMilliseconds(std::int64_t milliseconds) = 0;
  /// The wall clock as "YYYY-MM-DD HH:MM:SS.mmm", or a fixed text in a deterministic run.
  virtual std::string Timestamp() = 0;
  virtual std::uint64_t DecisionCycle() const = 0;
  /// The next number for `make-constant-symbol`: from 1, increasing during the agent's life.
  virtual std::uint64_t NextConstantNumber() = 0;

  // Calls outwards ------------------------------------------------------------------------------------------------

  /// Executes a command line and returns its output.
  virtual std::string RunCommand(std::string_view line) = 0;
  /// Calls the function that a client registered. Returns false if there is none.
  virtual bool CallUserFunction(std::string_view name, std::string_view argument, std::string& result) = 0;

  // Working memory and learning -----------------------------------------------------------------------------------

  /// The elements of an identifier that rules created (not those of the architecture or input), newest slot first,
  /// values in list order. Excludes elements of acceptable preferences.
  virtual void SlotChildren(Symbol identifier, std::vector<Child>& out) const = 0;
  /// All elements of an identifier: those of rules, the architecture and input.
  virtual void AllChildren(Symbol identifier, std::vector<Child>& out) const = 0;
  /// Creates an identifier that belongs to the firing instantiation, with the next number of its letter.
  virtual Symbol NewIdentifier(char letter) = 0;
  /// Adds an acceptable preference to the results of the firing instantiation.
  virtual void MakePreference(Symbol identifier, Symbol attribute, Symbol value) = 0;
  /// Adds a preference for the copy of an element of `original`. It follows the action's own results, and the firing
  /// now also depends on the element.
  virtual void CopyElement([[maybe_unused]] const Child& element, [[maybe_unused]] Symbol original, Symbol copy,
                           Symbol attribute, Symbol value) {
    MakePreference(copy, attribute, value);
  }
  virtual bool IsGoal(Symbol identifier) const = 0;
  /// The long-term identifier that an identifier is linked to; 0 if there is none.
  virtual std::uint64_t LongTermIdentifier(Symbol identifier) const = 0;
  virtual void LinkToLongTerm(Symbol identifier, std::uint64_t lti) = 0;
  virtual void SetLearning(Symbol state, bool learn) = 0;
};

/// The text of a symbol in messages.
inline std::string Name(FunctionContext& context, Symbol symbol) {
  return ToString(context.symbols(), symbol);
}

}  // namespace soarbox::kernel
