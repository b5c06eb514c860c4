// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// The output of one agent, and the column at which the next text begins.
///
/// The column is kept between commands, because the line breaks of objects depend on it. While a Capture exists, texts
/// go to its string instead of the sink. Captures can be nested; Uncaptured sends texts to the sink again. The function
/// of SetCopy, such as a log file, receives all texts.
class PrintStream {
 public:
  using Sink = std::function<void(std::string_view)>;

  /// Sets the function that receives texts that are not captured. If empty, they are dropped.
  void SetSink(Sink sink) { sink_ = std::move(sink); }
  /// Sets a function that receives all texts, captured or not. May be empty.
  void SetCopy(Sink copy) { copy_ = std::move(copy); }
  /// Off: nothing is printed (`output enabled off`).
  void SetEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  /// Off: the sink is not called (`output callbacks off`).
  void SetSinkEnabled(bool enabled) { sink_enabled_ = enabled; }
  bool sink_enabled() const { return sink_enabled_; }

  /// Also prints to standard output the texts that are not captured (`output console`), unless the sink does so itself.
  void SetConsole(bool on) { console_ = on; }
  bool console() const { return console_; }
  void SetSinkIsConsole(bool is_console) { sink_is_console_ = is_console; }
  /// Prints to standard output if `output console` is on. For texts that are results and are not printed otherwise.
  void ToConsole(std::string_view text) const;

  void Print(std::string_view text);
  /// Prints without changing the column, for texts that Soar's printer does not count.
  void PrintUncounted(std::string_view text);
  /// Sets the column of the next text, if the last one was printed elsewhere.
  void SetColumn(int column) { column_ = column; }
  /// Prints a newline, unless the column is 0.
  void FreshLine();
  int column() const { return column_; }
  /// Whether texts are captured now.
  bool captured() const { return !targets_.empty() && targets_.back() != nullptr; }

  /// Redirects texts to a string during its lifetime.
  class Capture {
   public:
    Capture(PrintStream& stream, std::string* target) : stream_(stream) { stream_.targets_.push_back(target); }
    ~Capture() { stream_.targets_.pop_back(); }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

   private:
    PrintStream& stream_;
  };

  /// Sends texts to the sink during its lifetime: a Capture without a target.
  class Uncaptured : public Capture {
   public:
    explicit Uncaptured(PrintStream& stream) : Capture(stream, nullptr) {}
  };

 private:
  Sink sink_;
  Sink copy_;
  std::vector<std::string*> targets_;
  int column_ = 0;
  bool enabled_ = true;
  bool sink_enabled_ = true;
  bool console_ = false;
  bool sink_is_console_ = false;
};

}  // namespace soarbox::cli
