// SPDX-License-Identifier: BSD-2-Clause
#include "record/writer.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>
#include <vector>

#include "bytes/byte_stream.h"
#include "diagnostics/problem.h"
#include "record/manifest.h"
#include "record/tick_codec.h"

namespace soarbox::record {
namespace fs = std::filesystem;
Writer::Writer(File file, fs::path path, const Header& header, const WriterSettings& settings)
    : file_(std::move(file)), path_(std::move(path)), settings_(settings), builder_(settings.ticks_per_block) {
  BlockFrame frame;
  frame.kind = BlockKind::kHeader;
  header_block_ = std::string(kMagic) + EncodeBlock(frame, EncodeHeader(header));
  if (settings.manifest.empty()) return;
  frame.kind = kManifestBlock;
  header_block_ += EncodeBlock(frame, settings.manifest);
}

Writer::~Writer() {
  (void)Flush();  // There is no caller to report an error to.
}

Result<std::unique_ptr<Writer>> Writer::Create(const fs::path& path, const Header& header,
                                               const WriterSettings& settings) {
  File file(std::fopen(path.c_str(), "wb"));
  if (file == nullptr) {
    return ProblemIn(path, std::string("this recording cannot be written: ") + std::strerror(errno),
                     "check the folder and its permissions");
  }
  std::unique_ptr<Writer> writer(new Writer(std::move(file), path, header, settings));
  if (const Result<void> written = writer->Write(writer->header_block_); !written) return written.error();
  return writer;
}

Result<void> Writer::Failed(const char* doing) {
  failure_ = ProblemIn(path_, std::string("the recording ends here: ") + doing + ": " + std::strerror(errno),
                       "what was recorded until now can be used; free some disk space and record again");
  failure_->severity = Severity::kWarning;
  return *failure_;
}

Result<void> Writer::Write(const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() || std::fflush(file_.get()) != 0)
    return Failed("writing failed");
  bytes_ += bytes.size();
  return {};
}

Result<void> Writer::Add(const TickRecord& tick) {
  TickRecord copy = tick;
  return AddAndSwap(copy);
}

Result<void> Writer::AddAndSwap(TickRecord& tick) {
  if (failure_) return *failure_;
  if (!tick.inputs.empty()) {
    ByteWriter inputs(new_inputs_);
    WriteInputs(inputs, tick.tick, tick.inputs);
  }
  return builder_.Add(tick) ? Flush() : Result<void>{};
}

Result<void> Writer::AddEarlierInputs(const std::vector<TickInputs>& earlier) {
  ByteWriter out(new_inputs_);
  for (const TickInputs& entry : earlier) WriteInputs(out, entry.tick, entry.inputs);
  return WriteInputsSoFar();
}

Result<void> Writer::WriteInputsSoFar() {
  if (new_inputs_.empty()) return {};
  BlockFrame frame;
  frame.kind = BlockKind::kInputs;
  const std::string inputs = std::exchange(new_inputs_, {});
  if (settings_.limit_bytes > 0) all_inputs_ += inputs;
  return Write(EncodeBlock(frame, inputs));
}

Result<void> Writer::Flush() {
  if (failure_) return *failure_;
  if (builder_.empty()) return {};
  // Inputs come first, so that a file never contains a tick without its inputs.
  if (const Result<void> written = WriteInputsSoFar(); !written) return written;
  const EncodedBlock block = builder_.Take();
  blocks_.push_back({bytes_, block.bytes.size()});
  if (const Result<void> written = Write(block.bytes); !written) return written;
  if (settings_.limit_bytes > 0 && bytes_ > settings_.limit_bytes && blocks_.size() > 2) return DropOlderHalf();
  return {};
}

Result<void> Writer::AddWaits(const Waits& waits) {
  if (failure_) return *failure_;
  BlockFrame frame;
  frame.kind = BlockKind::kWaits;
  std::string payload;
  ByteWriter out(payload);
  out.Number(waits.ticks);
  out.Double(waits.seconds);
  return Write(EncodeBlock(frame, payload));
}

/// Writes the remaining blocks to a new file and then replaces the old one, so that one complete file always exists.
/// All inputs are kept, because they are needed to simulate the run again from its beginning.
Result<void> Writer::DropOlderHalf() {
  const fs::path next = path_.string() + ".next";
  File old = std::exchange(file_, File(std::fopen(next.c_str(), "w+b")));
  const File from(std::fopen(path_.c_str(), "rb"));
  if (file_ == nullptr || from == nullptr) {
    file_ = std::move(old);
    return Failed("a bounded recording drops its beginning");
  }
  bytes_ = 0;
  BlockFrame frame;
  frame.kind = BlockKind::kInputs;
  if (const Result<void> head = Write(header_block_ + EncodeBlock(frame, all_inputs_)); !head) return head;
  std::uint64_t dropped = 0;
  const std::uint64_t to_drop = settings_.limit_bytes / 2;
  while (blocks_.size() > 1 && dropped < to_drop) {
    dropped += blocks_.front().bytes;
    blocks_.pop_front();
  }
  std::string bytes;
  for (Block& block : blocks_) {
    bytes.resize(block.bytes);
    if (std::fseek(from.get(), static_cast<long>(block.begin), SEEK_SET) != 0 ||
        std::fread(bytes.data(), 1, bytes.size(), from.get()) != bytes.size())
      return Failed("a bounded recording drops its beginning");
    block.begin = bytes_;
    if (const Result<void> written = Write(bytes); !written) return written;
  }
  std::error_code error;
  fs::rename(next, path_, error);
  if (error) {
    errno = error.value();
    return Failed("a bounded recording drops its beginning");
  }
  return {};
}

}  // namespace soarbox::record
