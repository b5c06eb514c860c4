// SPDX-License-Identifier: BSD-2-Clause
#include "sim/vocabulary_percepts.h"

namespace soarbox::sim {
namespace {

constexpr SenseRow kSenses[] = {
    {"distance", "The thesis' one number"},
    {"time", "The clock"},
    {"self", "The own body"},
    {"agents", "Others: by sight (field of view, line of sight), by hearing, from memory"},
    {"objects", "Things in view"},
    {"path", "How moving goes"},
    {"waypoints", "The scenario's waypoints"},
    {"regions", "The scenario's regions"},
    {"messages", "What others say"},
    {"events", "Hits, collisions, shots that are heard"},
    {"orders", "What a leader wants"},
};

}  // namespace

std::span<const PerceptRow> Percepts() {
  return kPerceptTable;
}

std::span<const SenseRow> Senses() {
  return kSenses;
}

}  // namespace soarbox::sim
