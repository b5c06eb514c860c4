// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/agent.h"
#include "kernel/io/input_tap.h"

/// Recording and replay of an agent's input (`save percepts`, `load percepts`).
///
/// The file is text, with one change per line. Cycles count input phases since the recording began. A replay uses time
/// tags to find the element that a line refers to, and to check that the run is still the same:
///
///     soarbox percepts 1
///     seed 1234567
///     1 add 20 I2 |block| new B1
///     1 add 21 B1 |weight| float 2.5
///     3 remove 21
///     5 init
///     9 end
///
/// Values: int N, float X, string |...| (with \| \\ \n \r), id NAME, new NAME (an identifier that is created). Changes
/// by `wm add` and `wm remove` are not recorded, because they are commands and not input from clients.
namespace soarbox::cli {

/// One line of a recording.
struct PerceptAction {
  enum class Kind : std::uint8_t { kAdd, kRemove, kInit };
  struct Identifier {
    std::string name;
    bool is_new = false;
  };

  Kind kind = Kind::kAdd;
  int line = 0;
  std::uint64_t cycle = 0, timetag = 0;
  std::string parent, attribute;
  std::variant<std::int64_t, double, std::string, Identifier> value;
};

struct PerceptFile {
  std::uint32_t seed = 0;
  std::uint64_t last_cycle = 0;
  std::vector<PerceptAction> actions;
  std::size_t changes = 0;  ///< Number of actions except inits.
};

/// Parses a recording; an error names the line. `name` is the name of the file, for messages.
Result<PerceptFile> ReadPercepts(std::string_view text, const std::string& name);

/// Writes the agent's input to a file during its lifetime. Seeds the agent's random numbers with a number drawn from
/// them; the replay uses the same seed.
class PerceptRecorder : public kernel::InputTap {
 public:
  PerceptRecorder(kernel::Agent& agent, const std::string& path);
  ~PerceptRecorder() override;

  /// False if the file could not be written.
  bool good() const { return out_.good(); }
  std::uint32_t seed() const { return seed_; }
  std::uint64_t changes() const { return changes_; }
  void Flush() { out_.flush(); }
  /// Ends the recording. Returns false if writing failed.
  bool Close();

  void OnInputPhase(kernel::InputLink&) override { ++cycle_; }
  void OnInputChange(const kernel::InputChange& change) override;
  void OnInputReset() override;

 private:
  kernel::Agent& agent_;
  std::ofstream out_;
  std::uint32_t seed_ = 0;
  std::uint64_t cycle_ = 0, changes_ = 0;
};

/// Replaces the agent's input by recorded input. The input of clients is dropped until the recording ends. Reports once
/// if the run differs from the recorded one.
class PerceptPlayer : public kernel::InputTap {
 public:
  /// `tell` prints a line for the user.
  PerceptPlayer(kernel::Agent& agent, PerceptFile file, std::function<void(const std::string&)> tell);
  ~PerceptPlayer() override;

  /// False after the recording has ended, or if a change of it is impossible in this run.
  bool playing() const { return playing_; }

  void OnInputPhase(kernel::InputLink& link) override;
  void OnInputChange(const kernel::InputChange& change) override;
  void OnInputReset() override;

 private:
  bool Play(kernel::InputLink& link, const PerceptAction& action);
  kernel::InputObject Object(kernel::InputLink& link, const std::string& name);
  /// Ends the replay and stops the agent, because its input would now differ from the recording.
  void GiveUp(const PerceptAction* action, const std::string& why);

  kernel::Agent& agent_;
  PerceptFile file_;
  std::function<void(const std::string&)> tell_;
  bool playing_ = true;
  bool differs_ = false;
  std::uint64_t cycle_ = 0;
  std::size_t next_ = 0;
  std::deque<const PerceptAction*> awaited_;                ///< Changes that are still to be made in this phase.
  std::map<std::uint64_t, kernel::InputElement> elements_;  ///< By recorded time tag.
  std::map<std::string, kernel::InputObject> objects_;      ///< By recorded name.
};

}  // namespace soarbox::cli
