// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the readers of a recording's blocks. The first byte selects a header, inputs, ticks, or a
// block's frame with its payload. Ticks that were read must be written and read again with the same contents.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_stream.h"
#include "record/file_format.h"
#include "record/header.h"
#include "record/percept_values.h"
#include "record/tick_codec.h"

namespace {

using namespace soarbox;
using namespace soarbox::record;

std::string Alone(const TickRecord& record) {
  std::string bytes;
  BufferedWriter out(bytes);
  MindsEncoder minds;
  WriteTick(out, {}, record, minds);
  out.Flush();
  return bytes;
}

void ReadTicks(std::string_view bytes) {
  ByteReader in(bytes);
  TickRecord record;
  MindsDecoder minds;
  PerceptValues percepts;
  while (!in.AtEnd()) {
    ReadTick(in, record, minds);
    if (in.failed()) return;
    for (const MindRecord& mind : record.minds) ApplyPercepts(mind.events, percepts);
    const std::string bytes_alone = Alone(record);
    ByteReader again(bytes_alone);
    TickRecord copy;
    MindsDecoder minds_of_copy;
    ReadTick(again, copy, minds_of_copy);
    if (again.failed() || Alone(copy) != bytes_alone) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0:
      (void)DecodeHeader(bytes);
      break;
    case 1: {
      ByteReader in(bytes);
      std::uint64_t tick = 0;
      std::vector<std::string> inputs;
      while (!in.AtEnd()) ReadInputs(in, tick, inputs);
      break;
    }
    case 2:
      ReadTicks(bytes);
      break;
    default: {
      BlockFrame frame;
      std::string payload;
      if (!DecodeFrame(bytes, frame)) {
        // As if the frame were valid, but limited to a fuzzer's memory.
        frame.plain_bytes = frame.plain_bytes % (1u << 20);
      }
      const std::string_view compressed = bytes.substr(std::min(bytes.size(), kFrameBytes));
      frame.payload_check = CheckOfPayload(compressed);
      (void)DecodePayload(frame, compressed, payload);
    }
  }
  return 0;
}
