// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <random>

#include "cli/command.h"
#include "cli/lookup.h"
#include "cli/session.h"
#include "cli/summary.h"
#include "kernel/agent.h"
#include "kernel/decide/exploration.h"

namespace soarbox::cli {
namespace {

using kernel::ExplorationParameter;
using kernel::ExplorationPolicy;
using kernel::ExplorationSettings;
using kernel::ReductionPolicy;

struct PolicyName {
  ExplorationPolicy policy;
  char letter;
  std::string_view name;
};
constexpr PolicyName kPolicies[] = {
    {ExplorationPolicy::kBoltzmann, 'b', "boltzmann"}, {ExplorationPolicy::kEpsilonGreedy, 'g', "epsilon-greedy"},
    {ExplorationPolicy::kFirst, 'f', "first"},         {ExplorationPolicy::kLast, 'l', "last"},
    {ExplorationPolicy::kSoftmax, 'x', "softmax"},
};

std::string_view Name(ExplorationPolicy policy) {
  for (const PolicyName& entry : kPolicies) {
    if (entry.policy == policy) return entry.name;
  }
  return "";
}

std::string_view Name(ReductionPolicy policy) {
  return policy == ReductionPolicy::kExponential ? "exponential" : "linear";
}

bool DecideOverview(CommandCall& call) {
  const ExplorationSettings& settings = call.agent().exploration();
  Summary summary(55);
  summary.Rule('=').Text("                     Decide Summary\n").Rule('=');
  summary.Row("Numeric indifference mode:", settings.average_numbers ? "average" : "sum").Rule('-');
  summary.Row("Exploration Policy:", Name(settings.policy));
  summary.Row("Automatic Policy Parameter Reduction:", OnOff(settings.auto_reduce));
  summary.Row("Epsilon:", fmt::format("{:f}", settings.epsilon.value));
  summary.Row("Epsilon Reduction Policy:", Name(settings.epsilon.reduction));
  summary.Row("Temperature:", fmt::format("{:f}", settings.temperature.value));
  summary.Row("Temperature Reduction Policy:", Name(settings.temperature.reduction)).Rule('-');
  summary.Text("\nUse 'decide ?' for a command overview or 'help decide' for the manual page.");
  std::string text = summary.Take();
  call.Out(text);
  return true;
}

constexpr OptionSpec kNumericOptions[] = {
    {'a', "avg", OptionArgument::kNone, "numeric preferences count by their mean"},
    {'a', "average"},
    {'s', "sum", OptionArgument::kNone, "numeric preferences count by their sum"},
};

bool NumericMode(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kNumericOptions, parsed)) return false;
  ExplorationSettings& settings = call.agent().mutable_exploration();
  if (!parsed.arguments.empty()) return call.Fail("Too many arguments.");
  if (!parsed.options.empty()) {
    settings.average_numbers = parsed.options.back().letter == 'a';
  } else {
    call.Out(fmt::format("Current numeric indifferent mode: Soar will {} numeric preferences.",
                         settings.average_numbers ? "average" : "use the sum of"));
  }
  call.AddArgument("numericindifferentmode", "int", settings.average_numbers ? "0" : "1");
  return true;
}

ExplorationParameter* FindParameter(ExplorationSettings& settings, std::string_view name) {
  if (name == "epsilon") return &settings.epsilon;
  if (name == "temperature") return &settings.temperature;
  return nullptr;
}

/// Formats a parameter like Soar: at most 16 digits.
std::string ParameterText(double value) {
  return fmt::format("{:.16g}", value);
}

bool ShowValue(CommandCall& call, double value) {
  call.Out(ParameterText(value));
  return true;
}

bool Parameter(CommandCall& call, bool epsilon, const ParsedWords& parsed) {
  ExplorationSettings& settings = call.agent().mutable_exploration();
  if (parsed.arguments.size() > 1) return call.Fail("Too many arguments.");
  if (parsed.arguments.empty()) return ShowValue(call, epsilon ? settings.epsilon.value : settings.temperature.value);
  const auto value = ParseDouble(parsed.arguments.front().text);
  if (!value || !(epsilon ? settings.SetEpsilon(*value) : settings.SetTemperature(*value))) {
    return call.Fail("Invalid parameter value.");
  }
  return true;
}

bool ReadReduction(std::string_view word, ReductionPolicy& policy) {
  if (word == "exponential")
    policy = ReductionPolicy::kExponential;
  else if (word == "linear")
    policy = ReductionPolicy::kLinear;
  else
    return false;
  return true;
}

bool Reduction(CommandCall& call, const ParsedWords& parsed) {
  if (parsed.arguments.empty()) return call.Fail("Too few arguments.");
  if (parsed.arguments.size() > 2) return call.Fail("Too many arguments.");
  ExplorationParameter* parameter = FindParameter(call.agent().mutable_exploration(), parsed.arguments[0].text);
  if (!parameter) return call.Fail("Invalid parameter value.");
  if (parsed.arguments.size() == 1) {
    call.Out(Name(parameter->reduction));
    return true;
  }
  if (!ReadReduction(parsed.arguments[1].text, parameter->reduction)) return call.Fail("Invalid parameter value.");
  return true;
}

bool Rate(CommandCall& call, const ParsedWords& parsed) {
  if (parsed.arguments.size() < 2) return call.Fail("Too few arguments.");
  if (parsed.arguments.size() > 3) return call.Fail("Too many arguments.");
  ExplorationParameter* parameter = FindParameter(call.agent().mutable_exploration(), parsed.arguments[0].text);
  ReductionPolicy policy;
  if (!parameter) return call.Fail("Invalid exploration parameter.");
  if (!ReadReduction(parsed.arguments[1].text, policy)) return call.Fail("Invalid exploration reduction policy.");
  if (parsed.arguments.size() == 2) {
    return ShowValue(call,
                     policy == ReductionPolicy::kExponential ? parameter->exponential_rate : parameter->linear_rate);
  }
  const auto rate = ParseDouble(parsed.arguments[2].text);
  if (!rate || !ExplorationSettings::SetRate(*parameter, policy, *rate)) return call.Fail("Invalid parameter value.");
  return true;
}

void Stats(CommandCall& call) {
  const ExplorationSettings& settings = call.agent().exploration();
  call.Out(fmt::format("Exploration Policy: {}\nAutomatic Policy Parameter Reduction: {}\n\n", Name(settings.policy),
                       OnOff(settings.auto_reduce)));
  const auto show = [&](std::string_view name, const ExplorationParameter& parameter) {
    call.Out(fmt::format("{0}: {1}\n{0} Reduction Policy: {2}\n{0} Reduction Rate (exponential/linear): {3}/{4}\n\n",
                         name, ParameterText(parameter.value), Name(parameter.reduction),
                         ParameterText(parameter.exponential_rate), ParameterText(parameter.linear_rate)));
  };
  show("epsilon", settings.epsilon);
  show("temperature", settings.temperature);
}

constexpr OptionSpec kIndifferentOptions[] = {
    {'b', "boltzmann", OptionArgument::kNone, "chances by exp(value / temperature)"},
    {'g', "epsilon-greedy", OptionArgument::kNone, "the best one, or with chance epsilon any"},
    {'f', "first", OptionArgument::kNone, "the first candidate; of those proposed in the same elaboration, the newest"},
    {'l', "last", OptionArgument::kNone, "the last candidate; of those proposed in the same elaboration, the oldest"},
    {'x', "softmax", OptionArgument::kNone, "chances in proportion to values"},
    {'e', "epsilon", OptionArgument::kNone, "show or set epsilon"},
    {'t', "temperature", OptionArgument::kNone, "show or set the temperature"},
    {'p', "reduction-policy", OptionArgument::kNone, "how a parameter shrinks"},
    {'r', "reduction-rate", OptionArgument::kNone, "how fast a parameter shrinks"},
    {'a', "auto-reduce", OptionArgument::kNone, "whether parameters shrink after each decision"},
    {'s', "stats", OptionArgument::kNone, "show all settings"},
};

bool Indifferent(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kIndifferentOptions, parsed)) return false;
  ExplorationSettings& settings = call.agent().mutable_exploration();
  if (parsed.options.empty()) {
    if (!parsed.arguments.empty()) return call.Fail("Too many args.");
    call.Out(Name(settings.policy));
    call.AddArgument("indifferentselectionmode", "string", std::string(Name(settings.policy)));
    return true;
  }
  if (parsed.options.size() > 1) return call.Fail("indifferent-selection takes only one option at a time.");
  const char letter = parsed.options.front().letter;
  for (const PolicyName& entry : kPolicies) {
    if (entry.letter == letter) {
      if (!parsed.arguments.empty()) return call.Fail("Too many arguments.");
      settings.policy = entry.policy;
      return true;
    }
  }
  switch (letter) {
    case 'e':
      return Parameter(call, true, parsed);
    case 't':
      return Parameter(call, false, parsed);
    case 'p':
      return Reduction(call, parsed);
    case 'r':
      return Rate(call, parsed);
    case 's':
      if (!parsed.arguments.empty()) return call.Fail("Too many arguments.");
      Stats(call);
      return true;
    case 'a':
      if (parsed.arguments.size() > 1) return call.Fail("Too many arguments.");
      if (parsed.arguments.empty()) {
        call.Out(OnOff(settings.auto_reduce));
      } else {
        const std::string& word = parsed.arguments.front().text;
        if (word != "on" && word != "off") return call.Fail("Invalid parameter value.");
        settings.auto_reduce = word == "on";
      }
      return true;
    default:
      return true;
  }
}

bool Predict(CommandCall& call) {
  if (call.words.size() > 1) return call.Fail("predict takes no arguments.");
  call.Out(call.agent().PredictDecision());
  return true;
}

bool Select(CommandCall& call) {
  kernel::Agent& agent = call.agent();
  if (call.words.size() < 2) {
    const std::string_view selected = agent.selected_operator();
    call.Out(selected.empty() ? "No operator selected." : selected);
    return true;
  }
  if (call.words.size() > 2) return call.Fail("Syntax: decide select <id>");
  const std::string& word = call.words[1].text;
  agent.SelectOperator(word);
  call.Out(fmt::format("Operator {} will be selected.", word));
  return true;
}

bool SetRandomSeed(CommandCall& call) {
  if (call.words.size() > 2) return call.Fail("Syntax: decide set-random-seed [seed]");
  if (call.words.size() < 2) {
    std::random_device device;
    call.agent().random().Seed(device());
    call.Out("Random number generator seed set to new random value.\n");
    return true;
  }
  const auto number = ParseLeadingInteger(call.words[1].text);
  const auto seed = static_cast<std::uint32_t>(number.value_or(0));
  call.agent().random().Seed(seed);
  call.Out(fmt::format("Random number generator seed set to {}\n", seed));
  return true;
}

constexpr SubcommandInfo kDecideSubcommandList[] = {
    {"numeric-indifferent-mode", "[--avg | --sum]", "how several numbers for one operator count", kNumericOptions,
     NumericMode},
    {"indifferent-selection", "[OPTION [VALUE]]", "how one of several indifferent operators is chosen",
     kIndifferentOptions, Indifferent},
    {"predict", "", "what the next decision will be", {}, Predict},
    {"select", "[OPERATOR]", "the operator that the next decision selects, if it is proposed", {}, Select},
    {"set-random-seed", "[SEED]", "restarts the random numbers", {}, SetRandomSeed},
    {"srand", "[SEED]", "restarts the random numbers", {}, SetRandomSeed},
};

}  // namespace

const std::span<const SubcommandInfo> kDecideSubcommands = kDecideSubcommandList;

bool CommandDecide(CommandCall& call) {
  if (call.words.size() < 2) return DecideOverview(call);
  return RunSubcommand(call, {.also_known = "qvz"});
}

}  // namespace soarbox::cli
