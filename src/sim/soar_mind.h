// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace sml {
class Agent;
class FloatElement;
}  // namespace sml

namespace soarbox::sim {

/// The mind of one agent as a Soar program: perceives one number, answers with command words.
///
/// The vocabulary is the thesis': `^io.input-link.distance` holds the squared distance in m^2 from the agent's centre to
/// its target (or its leader's centre), and each attribute that the rules put on the output link is a command, marked
/// `^status complete` (or `^status error`) once it has been carried out.
///
/// Owned by the simulation; the kernel behind it must outlive it.
class SoarMind {
 public:
  explicit SoarMind(sml::Agent& agent);

  /// Does one command; false marks it with ^status error.
  using Perform = std::function<bool(std::string_view command)>;

  /// Perceives `distance_squared_m2` and decides until there is output or the decision budget is used up
  /// (max-nil-output-cycles), then performs each new command. Returns how many there were; 0 is a gap in the rules.
  int Tick(float distance_squared_m2, const Perform& perform);

  /// True once the program has halted; it then does nothing more until it is initialised again.
  bool Halted() const;
  /// Starts the program anew: working memory is cleared, the rules stay.
  void Restart();

 private:
  void MakePercepts();

  sml::Agent& agent_;
  sml::FloatElement* distance_ = nullptr;
};

}  // namespace soarbox::sim
