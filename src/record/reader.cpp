// SPDX-License-Identifier: BSD-2-Clause
#include "record/reader.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "bytes/byte_stream.h"
#include "diagnostics/problem.h"
#include "record/client_recording.h"
#include "record/kept_assets.h"
#include "record/tick_codec.h"

namespace soarbox::record {
namespace fs = std::filesystem;

bool IsRecording(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  if (IsClientLog(file)) return true;
  std::ifstream in(file, std::ios::binary);
  std::string magic(kMagic.size(), '\0');
  return in.read(magic.data(), static_cast<std::streamsize>(magic.size())) && magic == kMagic;
}

Diagnostic Reader::Damaged(std::uint64_t at, const std::string& what) const {
  return ProblemIn(path_.string(), what + " (at byte " + std::to_string(at) + ")",
                   "the other parts of the recording can still be used");
}

Result<std::unique_ptr<Reader>> Reader::Open(const fs::path& file) {
  Diagnostic problem;
  problem.file = file.string();
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    problem.message = error || !fs::exists(file, error) ? "there is no such file" : "this is not a plain file";
    problem.hint = "name a recording, as `soarbox run --record FILE` makes them";
    return problem;
  }
  if (IsClientLog(file)) {
    // A client's log is converted to a recording in a temporary file, which the reader keeps open.
    std::string name = (fs::temp_directory_path(error) / "soarbox-recording-XXXXXX").string();
    const int made = mkstemp(name.data());
    if (made < 0) return ProblemIn(name, std::string("this file cannot be made: ") + std::strerror(errno));
    close(made);
    const Result<void> recorded = RecordClientLog(file, name);
    Result<std::unique_ptr<Reader>> reader = recorded ? Open(name) : Result<std::unique_ptr<Reader>>(recorded.error());
    fs::remove(name, error);
    if (reader) (*reader)->path_ = file;
    return reader;
  }
  std::unique_ptr<Reader> reader(new Reader(file));
  reader->bytes_ = fs::file_size(file, error);
  if (!reader->in_ || error) {
    problem.message = std::string("this file cannot be read: ") + std::strerror(errno);
    return problem;
  }
  std::string magic(kMagic.size(), '\0');
  reader->in_.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (!reader->in_ || magic != kMagic) {
    problem.message = "this is not a recording of Soarbox";
    problem.hint = "`soarbox run --record FILE` makes one";
    return problem;
  }
  if (const Result<void> read = reader->ReadFrames(); !read) return read.error();
  return reader;
}

Result<void> Reader::ReadFrames() {
  std::uint64_t at = kMagic.size();
  bool has_header = false;
  while (at < bytes_) {
    std::string bytes(kFrameBytes, '\0');
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(at));
    in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    Block block;
    if (!in_ || !DecodeFrame(bytes, block.frame)) {
      ending_ = "after " + std::to_string(at) + " bytes something follows that is not a complete block";
      break;
    }
    if (block.frame.version != kVersion) {
      return ProblemIn(path_.string(),
                       "this recording has format " + std::to_string(block.frame.version) +
                           ", and this program reads format " + std::to_string(kVersion),
                       "use the version of Soarbox that made it");
    }
    block.payload_at = at + kFrameBytes;
    at = block.payload_at + block.frame.compressed_bytes;
    if (at > bytes_) {
      ending_ = "the last block is not complete";
      break;
    }
    switch (block.frame.kind) {
      case BlockKind::kHeader: {
        if (has_header) return Damaged(block.payload_at, "the recording has a second header");
        const Result<std::string> payload = ReadPayload(block);
        if (!payload) return payload.error();
        Result<Header> header = DecodeHeader(*payload);
        if (!header) return Damaged(block.payload_at, header.error().message);
        header_ = std::move(*header);
        StoreAssets(header_.files);
        has_header = true;
        break;
      }
      case BlockKind::kInputs:
        inputs_.push_back(block);
        break;
      case BlockKind::kTicks:
        if (block.frame.ticks == 0 || (!blocks_.empty() && block.frame.first_tick != last_tick() + 1))
          return Damaged(block.payload_at, "the blocks of the recording are out of order");
        blocks_.push_back(block);
        break;
      case BlockKind::kWaits: {
        // No tick depends on it. So a recording is read even if this block is damaged.
        const Result<std::string> payload = ReadPayload(block);
        if (!payload) break;
        ByteReader in(*payload);
        const Waits waits{in.Number(), in.Double()};
        if (!in.failed() && std::isfinite(waits.seconds)) waits_ = waits;
        break;
      }
      default:
        break;  // A kind that a later version added.
    }
  }
  Diagnostic problem;
  problem.file = path_.string();
  problem.hint = "the program that made it ended before it had recorded anything";
  if (!has_header) {
    problem.message = "the recording has no header";
    return problem;
  }
  if (blocks_.empty()) {
    problem.message = "the recording holds no ticks";
    return problem;
  }
  return {};
}

Result<std::string> Reader::ReadPayload(const Block& block) {
  std::string compressed(block.frame.compressed_bytes, '\0');
  std::string payload;
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(block.payload_at));
  in_.read(compressed.data(), static_cast<std::streamsize>(compressed.size()));
  if (!in_ || !DecodePayload(block.frame, compressed, payload))
    return Damaged(block.payload_at, "this block is damaged");
  return payload;
}

Result<const TickRecord*> Reader::At(std::uint64_t tick) {
  if (!Holds(tick)) return NotThere(*this, tick);
  const auto after =
      std::upper_bound(blocks_.begin(), blocks_.end(), tick,
                       [](std::uint64_t wanted, const Block& block) { return wanted < block.frame.first_tick; });
  const Block& block = *(after - 1);
  if (!cursor_.Has(tick)) {
    cursor_.Unload();
    Result<std::string> payload = ReadPayload(block);
    if (!payload) return payload.error();
    cursor_.Load(block.frame, std::move(*payload));
  }
  if (const TickRecord* record = cursor_.At(tick)) return record;
  return Damaged(block.payload_at, "this block is damaged");
}

Result<std::vector<TickInputs>> Reader::Inputs() {
  std::vector<TickInputs> all;
  for (const Block& block : inputs_) {
    const Result<std::string> payload = ReadPayload(block);
    if (!payload) return payload.error();
    ByteReader in(*payload);
    while (!in.AtEnd() && !in.failed()) {
      TickInputs entry;
      ReadInputs(in, entry.tick, entry.inputs);
      const bool is_next = all.empty() || entry.tick > all.back().tick;
      if (!is_next) in.Fail();
      // Inputs are written before their ticks, which may be missing after a kill.
      if (!in.failed() && entry.tick <= last_tick()) all.push_back(std::move(entry));
    }
    if (in.failed()) return Damaged(block.payload_at, "this block is damaged");
  }
  return all;
}

}  // namespace soarbox::record
