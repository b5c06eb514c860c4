// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sml {
class Agent;
class FloatElement;
class Identifier;
}  // namespace sml

namespace soarbox::sim {

/// The mind of one agent as a Soar program: perceives one number, answers with command words.
///
/// The vocabulary is the thesis': `^io.input-link.distance` holds the squared distance in m^2 from the agent's centre
/// to its target (or its leader's centre), and each attribute that the rules put on the output link is a command,
/// marked
/// `^status complete` or `^status error` once the body has done with it.
///
/// Owned by the simulation; the kernel behind it must outlive it.
class SoarMind {
 public:
  explicit SoarMind(sml::Agent& agent);

  /// Perceives and decides until there is output or the decision budget is used up (max-nil-output-cycles). The new
  /// commands are in commands(); none means a gap in the rules.
  void Decide(float distance_squared_m2);
  std::span<const std::string> commands() const { return commands_; }
  /// Tells the program how its command number `index` went.
  void Answer(std::size_t index, bool succeeded);

  /// True once the program has halted; it then does nothing more until it is restarted.
  bool Halted() const;
  /// What used up the program's memory, in the kernel's words; empty if nothing did. The program is at its end then.
  std::string_view Breakdown() const;
  /// Starts the program anew: working memory is cleared, the rules stay.
  void Restart();

 private:
  sml::Agent* agent_;
  sml::FloatElement* distance_;
  std::string answer_;  ///< The kernel's to the last run.
  std::vector<std::string> commands_;
  std::vector<sml::Identifier*> handles_;  ///< Beside commands_; valid until the next Decide.
};

}  // namespace soarbox::sim
