// SPDX-License-Identifier: BSD-2-Clause
#include "vocabulary/vocabulary_percepts.h"

namespace soarbox::vocabulary {
namespace {

constexpr SenseRow kSenses[] = {
    {"distance", "The single number that the thesis' agents perceive"},
    {"time", "The clock"},
    {"self", "The agent's own body"},
    {"agents", "Other agents: by sight (field of view, line of sight), by hearing, from memory"},
    {"objects", "Things in view"},
    {"path", "How its movement is going"},
    {"waypoints", "The scenario's waypoints"},
    {"regions", "The scenario's regions"},
    {"messages", "What other agents say to it"},
    {"events", "Hits, collisions and shots that it hears"},
    {"orders", "What a leader wants it to do"},
};

}  // namespace

std::span<const PerceptRow> Percepts() {
  return kPerceptTable;
}

std::span<const SenseRow> Senses() {
  return kSenses;
}

}  // namespace soarbox::vocabulary
