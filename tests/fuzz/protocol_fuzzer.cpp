// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the wire protocol: the framing, the parser of documents, and the writer.
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

/// A parsed document must be written and parsed again with the same contents.
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
  // The first byte determines the size of the pieces of the stream.
  const std::size_t piece = size > 0 ? 1 + data[0] % 64 : 1;
  FrameReader reader(1u << 16);
  std::vector<std::string> messages;
  for (std::size_t i = 0; i < size; i += piece) {
    if (!reader.Feed(bytes.substr(i, piece), messages)) break;
  }
  for (const std::string& message : messages) CheckDocument(message);
  return 0;
}
