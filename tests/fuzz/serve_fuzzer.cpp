// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the server's readers other than HTTP: uploaded archives, and frames. Archives that were
// read must be within their limits, and must be the same after packing and unpacking.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "serve/frames.h"
#include "serve/zip.h"

using namespace soarbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostFiles = 20, kMostBytes = 100'000;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  serve::FrameReader frames;
  // In two pieces, as from a socket.
  frames.Add(bytes.substr(0, size / 2));
  std::size_t taken = 0;
  while (const auto frame = frames.Take()) taken += frame->bytes.size();
  frames.Add(bytes.substr(size / 2));
  while (const auto frame = frames.Take()) taken += frame->bytes.size();
  if (taken > size) std::abort();

  const Result<std::vector<serve::ZipEntry>> read = serve::ReadZip(bytes, kMostFiles, kMostBytes);
  if (!read) {
    if (read.error().message.empty()) std::abort();
    return 0;
  }
  std::size_t sum = 0;
  for (const serve::ZipEntry& entry : *read) sum += entry.bytes.size();
  if (read->size() > kMostFiles || sum > kMostBytes) std::abort();
  const Result<std::vector<serve::ZipEntry>> again = serve::ReadZip(serve::WriteZip(*read), kMostFiles, kMostBytes);
  if (!again || again->size() != read->size()) std::abort();
  for (std::size_t i = 0; i < read->size(); ++i)
    if ((*again)[i].path != (*read)[i].path || (*again)[i].bytes != (*read)[i].bytes) std::abort();
  return 0;
}
