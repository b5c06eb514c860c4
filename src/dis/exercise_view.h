// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "dis/dis_settings.h"
#include "sim/input.h"

namespace soarbox::dis {

class StateSender;

/// A foreign entity as it is listed.
struct ForeignEntity {
  std::string id;       ///< "7:8:9"
  std::string marking;  ///< The owner's name for it; may be empty.
  std::string team, body;
  std::string type;     ///< "3.1.225.1.1.0.0"
  double silent_s = 0;  ///< Real time since the last PDU from it.
};

/// Used as a site or an application: all.
inline constexpr std::uint16_t kAllSites = 0xFFFF;

/// Converts PDUs of other simulations to inputs for our run. Keeps only the newest state of each entity.
class ExerciseView {
 public:
  enum class Taken : std::uint8_t { kYes, kOurs, kTooMany };

  explicit ExerciseView(const Settings& settings) : settings_(settings), frame_(settings.anchor) {}

  /// `now_s`: real time from any starting point.
  Taken Take(const Body& body, double now_s);
  /// Removes entities that were silent for too long.
  void ForgetSilent(double now_s);
  /// The inputs since the last call. `ours` provides the names of our entities.
  std::vector<sim::InputValue> TakeInputs(const StateSender& ours);
  std::size_t entities() const { return heard_.size(); }
  /// The first `most` entities, by id.
  std::vector<ForeignEntity> List(double now_s, std::size_t most) const;

 private:
  struct Heard {
    double at_s = 0;
    EntityState state;
    bool is_news = false;
  };
  bool IsOurs(const EntityId& id) const { return id.site == settings_.site && id.application == settings_.application; }
  sim::ForeignBodyInput ToInput(const EntityState& state) const;
  sim::ForeignShotInput ToInput(const Detonation& hit, const StateSender& ours) const;

  const Settings& settings_;
  LocalFrame frame_;
  std::map<EntityId, Heard> heard_;
  std::vector<EntityId> gone_;
  std::vector<Detonation> hits_;
  std::vector<Comment> comments_;
};

}  // namespace soarbox::dis
