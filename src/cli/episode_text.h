// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "kernel/longterm/episode_intervals.h"

namespace soarbox::kernel {
class EpisodicMemory;
}

namespace soarbox::cli {

/// An episode as `epmem --print` shows it: one object per line, attributes in order. The episode must exist.
std::string EpisodeText(const kernel::EpisodicMemory& memory, kernel::EpisodeNumber episode);
/// The same as a graph for Graphviz (`epmem --viz`).
std::string EpisodeGraph(const kernel::EpisodicMemory& memory, kernel::EpisodeNumber episode);

}  // namespace soarbox::cli
