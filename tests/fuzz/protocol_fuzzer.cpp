// SPDX-License-Identifier: BSD-2-Clause
// Feeds arbitrary bytes to the wire protocol: the framing, the reader of documents, and the writer with what was read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "sml/wire/framing.h"
#include "sml/wire/message.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace {

using namespace soarbox::wire;

/// What is read must be written so that it reads back the same.
void CheckDocument(std::string_view document) {
  const soarbox::Result<Element> read = ReadXml(document);
  if (!read) return;
  const std::string written = ToXml(read.value());
  const soarbox::Result<Element> again = ReadXml(written);
  if (!again || ToXml(again.value()) != written) std::abort();
  const soarbox::Result<Message> message = ReadMessage(document);
  if (message) static_cast<void>(ToDocument(message.value()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  CheckDocument(bytes);
  // The first byte says how large the pieces are in which the stream comes.
  const std::size_t piece = size > 0 ? 1 + data[0] % 64 : 1;
  FrameReader reader(1u << 16);
  std::vector<std::string> messages;
  for (std::size_t i = 0; i < size; i += piece) {
    if (!reader.Feed(bytes.substr(i, piece), messages)) break;
  }
  for (const std::string& message : messages) CheckDocument(message);
  return 0;
}
