// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace sml {

/// Names of arguments in structured answers.
struct sml_Names {
  static constexpr char const* kParamAgent = "agent";
  static constexpr char const* kParamName = "name";
  static constexpr char const* kParamLine = "line";
  static constexpr char const* kParamEcho = "echo";
  static constexpr char const* kParamNoFiltering = "nofilter";
  static constexpr char const* kParamValue = "value";
  static constexpr char const* kParamPhase = "phase";
  static constexpr char const* kParamEventID = "eventid";
  static constexpr char const* kParamMessage = "message";
  static constexpr char const* kParamFunction = "function";
  static constexpr char const* kParamDirectory = "directory";
  static constexpr char const* kParamPort = "port";
  static constexpr char const* kParamCount = "count";
  static constexpr char const* kParamRunResult = "runresult";
  static constexpr char const* kParamRealSeconds = "real-seconds";
  static constexpr char const* kParamStatsProductionCountDefault = "statsproductioncountdefault";
  static constexpr char const* kParamStatsProductionCountUser = "statsproductioncountuser";
  static constexpr char const* kParamStatsProductionCountChunk = "statsproductioncountchunk";
  static constexpr char const* kParamStatsProductionCountJustification = "statsproductioncountjustification";
  static constexpr char const* kParamStatsCycleCountDecision = "statscyclecountdecision";
  static constexpr char const* kParamStatsCycleCountElaboration = "statscyclecountelaboration";
  static constexpr char const* kParamStatsCycleCountInnerElaboration = "statscyclecountinnerelaboration";
  static constexpr char const* kParamStatsProductionFiringCount = "statsproductionfiringcount";
  static constexpr char const* kParamStatsWmeCountAddition = "statswmecountaddition";
  static constexpr char const* kParamStatsWmeCountRemoval = "statswmecountremoval";
  static constexpr char const* kParamStatsWmeCount = "statswmecount";
  static constexpr char const* kParamStatsWmeCountAverage = "statswmecountsverage";
  static constexpr char const* kParamStatsWmeCountMax = "statswecountmax";
  static constexpr char const* kParamStatsKernelCPUTime = "statskernelcputime";
  static constexpr char const* kParamStatsTotalCPUTime = "statstotalcputime";
};

}  // namespace sml
