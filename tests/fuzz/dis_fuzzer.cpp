// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary datagrams to the code of DIS exercises. PDUs that were read must be written and read again with the
// same contents, and the view of the exercise must convert all of them to inputs.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "dis/exercise_view.h"
#include "dis/pdu_codec.h"
#include "dis/state_sender.h"
#include "sim/input_text.h"

using namespace soarbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::span<const std::byte> datagram(reinterpret_cast<const std::byte*>(data), size);
  dis::Settings settings;
  settings.most_entities = 4;
  dis::ExerciseView view(settings);
  const dis::StateSender ours(settings);
  double now_s = 0;
  while (!datagram.empty()) {
    const auto read = dis::Decode(datagram);
    if (const auto* pdu = std::get_if<dis::Pdu>(&read)) {
      const auto again = dis::Decode(dis::Encode(*pdu));
      if (!std::holds_alternative<dis::Pdu>(again)) std::abort();
      view.Take(pdu->body, now_s += 5);
      view.ForgetSilent(now_s);
    }
    const std::size_t length = dis::LengthOf(datagram);
    if (length == 0) break;
    datagram = datagram.subspan(length);
  }
  // Recordings contain inputs as text.
  for (sim::InputValue& value : view.TakeInputs(ours)) {
    const sim::Input input{1, std::move(value), false};
    const sim::InputText text = sim::ReadInputs(sim::WriteInput(input), "fuzzed");
    if (text.inputs.size() != 1 || !(text.inputs.front().value == input.value)) std::abort();
  }
  return 0;
}
