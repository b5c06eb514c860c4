// SPDX-License-Identifier: BSD-2-Clause
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/svs_facts.h"
#include "cli/svs_paths.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using kernel::Imagery;

/// Executes the switches (--on, --off, ...). Returns true if the word is a switch; `ok` receives its success.
bool Switch(CommandCall& call, const std::string& word, bool& ok) {
  const bool enable = word == "--enable" || word == "-e" || word == "--on";
  const bool disable = word == "--disable" || word == "-d" || word == "--off";
  const bool below = word == "--enable-in-substates" || word == "--disable-in-substates";
  if (!enable && !disable && !below) return false;
  const std::string where = below ? " in substates" : "";
  const bool on = enable || word == "--enable-in-substates";
  const Imagery* const known = std::as_const(call.agent()).find_imagery();
  const bool is_on = below ? known == nullptr || known->in_substates() : known != nullptr && known->enabled();
  ok = true;
  if (on == is_on) {
    call.Out("Spatial Visual System is already " + std::string(on ? "enabled" : "disabled") + where + ". ");
    return true;
  }
  Imagery& imagery = call.agent().imagery();
  if (on) {
    below ? imagery.EnableInSubstates() : imagery.Enable();
  } else if (const Result<void> result = below ? imagery.DisableInSubstates() : imagery.Disable(); !result) {
    call.Out(result.error().message + "\n");
    ok = call.FailPrinted();
    return true;
  }
  call.Out("Spatial Visual System " + std::string(on ? "enabled" : "disabled") + where + ". ");
  return true;
}

}  // namespace

bool CommandSvs(CommandCall& call) {
  const Imagery* const known = std::as_const(call.agent()).find_imagery();
  const bool enabled = known != nullptr && known->enabled();
  if (call.words.size() < 2) {
    call.Out("Spatial Visual System is " + std::string(enabled ? "enabled." : "disabled."));
    return true;
  }
  const std::string& word = call.words[1].text;
  if (call.agent().running()) return call.Fail("svs cannot be used while the agent runs.");
  bool ok = true;
  if (call.words.size() == 2 && Switch(call, word, ok)) return ok;
  // The list of commands does not depend on whether SVS is on.
  if (call.words.size() == 3 && word == "commands" && call.words[2].text == "all") {
    call.Out(AllSceneKinds());
    return true;
  }
  if (word == "facts") {
    call.Out(SceneFactsText(call.agent(), call.words.size() > 2 ? call.words[2].text : std::string()));
    return true;
  }
  if (!enabled) {
    call.Out("Spatial Visual System is currently disabled.  Please enable to execute SVS commands.\n");
    return call.FailPrinted();
  }
  std::vector<std::string> arguments;
  for (const Word& argument : call.words.subspan(2)) arguments.push_back(argument.text);
  SvsPaths paths(call.agent().imagery());
  const std::string text = paths.Use(word, arguments);
  if (paths.failed()) return call.Fail(text.substr(0, text.find_last_not_of('\n') + 1));
  call.Out(text);
  return true;
}

}  // namespace soarbox::cli
