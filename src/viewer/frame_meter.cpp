// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/frame_meter.h"

#include <imgui.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace soarbox::viewer {
namespace {

double ThreadTime_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Resident memory of the process in MB; 0 if the system does not report it.
long MemoryMegabytes() {
  std::ifstream in("/proc/self/statm");
  long all = 0, resident = 0;
  in >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE) >> 20;
}

}  // namespace

void FrameMeter::Begin() {
  frames_ = 0;
  panels_s_ = 0;
  most_corners_ = 0;
  began_s_ = ThreadTime_s();
}

void FrameMeter::BeginPanels() {
  panels_began_s_ = ThreadTime_s();
}

void FrameMeter::EndPanels() {
  panels_s_ += ThreadTime_s() - panels_began_s_;
  ++frames_;
}

void FrameMeter::NoteDrawn() {
  const ImDrawData* drawn = ImGui::GetDrawData();
  for (int i = 0; drawn != nullptr && i < drawn->CmdListsCount; ++i)
    most_corners_ = std::max(most_corners_, drawn->CmdLists[i]->VtxBuffer.Size);
}

std::string FrameMeter::Read(const std::string& name, double time_s) {
  const double frames = static_cast<double>(std::max<std::uint64_t>(1, frames_));
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  nlohmann::ordered_json line;
  line["event"] = "measure";
  line["name"] = name;
  line["time"] = rounded(time_s);
  line["frames"] = frames_;
  line["frame_ms"] = rounded((ThreadTime_s() - began_s_) * 1000 / frames);
  line["panels_ms"] = rounded(panels_s_ * 1000 / frames);
  line["corners"] = most_corners_;
  line["memory_mb"] = MemoryMegabytes();
  Begin();
  return line.dump();
}

}  // namespace soarbox::viewer
