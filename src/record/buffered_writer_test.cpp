// SPDX-License-Identifier: BSD-2-Clause
#include "bytes/buffered_writer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>

#include "bytes/byte_stream.h"

namespace soarbox {
namespace {

TEST(BufferedWriter, WritesTheSameBytesAsAByteWriterWhereverItsBufferEnds) {
  std::mt19937_64 random(5);
  std::string buffered, plain;
  BufferedWriter out(buffered);
  ByteWriter same(plain);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t value = random() >> (random() % 64);
    // Some texts are longer than the buffer.
    const std::string text(random() % 50 == 0 ? random() % 3000 : random() % 40, static_cast<char>('a' + i % 26));
    switch (random() % 7) {
      case 0:
        out.Byte(static_cast<std::uint8_t>(value));
        same.Byte(static_cast<std::uint8_t>(value));
        break;
      case 1:
        out.Number(value);
        same.Number(value);
        break;
      case 2:
        out.Float(static_cast<float>(value));
        same.Float(static_cast<float>(value));
        break;
      case 3:
        out.Double(static_cast<double>(value));
        same.Double(static_cast<double>(value));
        break;
      case 4:
        out.Text(text);
        same.Text(text);
        break;
      case 5:
        out.Append(text);
        same.Append(text);
        break;
      case 6: {
        const std::string_view part = std::string_view(text).substr(0, 1024);
        std::memcpy(out.Room(1024), part.data(), part.size());
        out.Wrote(part.size());
        same.Append(part);
        break;
      }
    }
  }
  out.Flush();
  EXPECT_EQ(buffered, plain);
}

}  // namespace
}  // namespace soarbox
