// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/draw_limit.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace soarbox::viewer {
namespace {

/// Leaves space for vertices that ImGui adds when it renders.
constexpr int kMostOfList = (1 << 16) - 512;

/// Number of indices that refer to kept vertices. The vertices of a triangle are created shortly before it, so an index
/// that is far behind has overflowed.
int KeptIndices(const ImDrawList& list) {
  int highest = 0;
  for (int i = 0; i + 2 < list.IdxBuffer.Size; i += 3) {
    for (int corner = i; corner < i + 3; ++corner) {
      const int index = list.IdxBuffer[corner];
      if (index >= kMostOfList || index + (1 << 15) < highest) return i;
      highest = std::max(highest, index);
    }
  }
  return list.IdxBuffer.Size;
}

bool Cut(ImDrawList& list) {
  if (sizeof(ImDrawIdx) > 2 || list.VtxBuffer.Size <= kMostOfList) return false;
  const int kept = KeptIndices(list);
  int commands = 0;
  for (ImDrawCmd& command : list.CmdBuffer) {
    const auto begin = static_cast<int>(command.IdxOffset);
    if (begin >= kept) break;
    command.ElemCount = std::min(command.ElemCount, static_cast<unsigned>(kept - begin));
    ++commands;
  }
  list.CmdBuffer.resize(commands);
  list.IdxBuffer.resize(kept);
  list.VtxBuffer.resize(kMostOfList);
  list._IdxWritePtr = list.IdxBuffer.Data + kept;
  list._VtxWritePtr = list.VtxBuffer.Data + kMostOfList;
  list._VtxCurrentIdx = kMostOfList;
  return true;
}

}  // namespace

std::vector<std::string> CutOverfullWindows() {
  std::vector<std::string> cut;
  for (ImGuiWindow* window : GImGui->Windows)
    if (window->Active && Cut(*window->DrawList)) cut.emplace_back(window->Name);
  if (Cut(*ImGui::GetBackgroundDrawList())) cut.emplace_back("the picture");
  if (Cut(*ImGui::GetForegroundDrawList())) cut.emplace_back("notes on the picture");
  return cut;
}

}  // namespace soarbox::viewer
