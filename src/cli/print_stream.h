// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// Where the texts of one agent go, and the column in which the next one begins.
///
/// The column survives from command to command, because objects are wrapped by it. While a Capture lives, texts go to
/// its string instead of the sink; captures nest, and Uncaptured lets texts through to the sink again. Copies, such as
/// a log file, receive every text.
class PrintStream {
 public:
  using Sink = std::function<void(std::string_view)>;

  /// Texts go to this function if nothing captures them. None: they are dropped.
  void SetSink(Sink sink) { sink_ = std::move(sink); }
  /// Receives every text, captured or not. None: nobody does.
  void SetCopy(Sink copy) { copy_ = std::move(copy); }
  /// Off: nothing is printed at all (`output enabled off`).
  void SetEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  /// Off: the sink is not called (`output callbacks off`).
  void SetSinkEnabled(bool enabled) { sink_enabled_ = enabled; }
  bool sink_enabled() const { return sink_enabled_; }

  /// Texts that nothing captures also go to the standard output (`output console`), unless the sink writes there
  /// itself.
  void SetConsole(bool on) { console_ = on; }
  bool console() const { return console_; }
  void SetSinkIsConsole(bool is_console) { sink_is_console_ = is_console; }
  /// Writes to the standard output if `output console` is on: for texts that are answers and are not printed.
  void ToConsole(std::string_view text) const;

  void Print(std::string_view text);
  /// Prints without counting columns: for texts that Soar's printer ignores.
  void PrintUncounted(std::string_view text);
  /// Sets where the next text begins, if the last one was printed elsewhere.
  void SetColumn(int column) { column_ = column; }
  /// A newline, unless the column is 0.
  void FreshLine();
  int column() const { return column_; }
  /// True if texts go to a capture now.
  bool captured() const { return !targets_.empty() && targets_.back() != nullptr; }

  /// Diverts texts into a string for as long as it lives.
  class Capture {
   public:
    Capture(PrintStream& stream, std::string* target) : stream_(stream) { stream_.targets_.push_back(target); }
    ~Capture() { stream_.targets_.pop_back(); }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

   private:
    PrintStream& stream_;
  };

  /// Lets texts through to the sink for as long as it lives: a Capture into nothing.
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
