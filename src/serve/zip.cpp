// SPDX-License-Identifier: BSD-2-Clause
#include "serve/zip.h"

#include <zlib.h>

#include <optional>

#include "diagnostics/problem.h"

namespace soarbox::serve {
namespace {

// Records of the format (PKWARE's APPNOTE 6.3), as far as files of some megabytes need them.
constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::size_t kLocalBytes = 30, kCentralBytes = 46, kEndBytes = 22, kMostComment = 65535;
constexpr std::uint16_t kStored = 0, kDeflated = 8, kUtf8Names = 1u << 11, kEncrypted = 1;
constexpr std::uint16_t kVersion = 20, kFirstDay = 0x21;

void Put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xff);
}

std::uint32_t Get(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)])) << (8 * i);
  return value;
}

std::uint32_t Sum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Returns nothing if it is not deflated data, or would be larger than `most` bytes.
std::optional<std::string> Inflate(std::string_view bytes, std::uintmax_t most) {
  z_stream stream{};
  constexpr int kRaw = -15;
  if (inflateInit2(&stream, kRaw) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  char piece[16384];
  int state = Z_OK;
  while (state == Z_OK && out.size() <= most) {
    stream.next_out = reinterpret_cast<Bytef*>(piece);
    stream.avail_out = sizeof piece;
    state = inflate(&stream, Z_NO_FLUSH);
    out.append(piece, sizeof piece - stream.avail_out);
    if (state == Z_OK && stream.avail_in == 0 && stream.avail_out != 0) state = Z_DATA_ERROR;
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || out.size() > most) return std::nullopt;
  return out;
}

Diagnostic Damaged(const std::string& why) {
  return NewProblem("this is not a zip archive that can be read: " + why);
}

}  // namespace

std::string Deflate(std::string_view bytes, DeflateAs format) {
  z_stream stream{};
  const bool is_gzip = format == DeflateAs::kGzip;
  constexpr int kRaw = -15, kGzip = 15 + 16, kMemory = 8;
  if (deflateInit2(&stream, is_gzip ? Z_BEST_COMPRESSION : Z_DEFAULT_COMPRESSION, Z_DEFLATED, is_gzip ? kGzip : kRaw,
                   kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    return {};
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const bool is_whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  out.resize(is_whole ? stream.total_out : 0);
  deflateEnd(&stream);
  return out;
}

std::string WriteZip(const std::vector<ZipEntry>& entries) {
  std::string out, directory;
  for (const ZipEntry& entry : entries) {
    const std::string packed = Deflate(entry.bytes, DeflateAs::kRaw);
    std::string common;
    Put(common, kVersion, 2);
    Put(common, kUtf8Names, 2);
    Put(common, kDeflated, 2);
    Put(common, 0, 2);
    Put(common, kFirstDay, 2);
    Put(common, Sum(entry.bytes), 4);
    Put(common, packed.size(), 4);
    Put(common, entry.bytes.size(), 4);
    Put(common, entry.path.size(), 2);
    Put(common, 0, 2);
    Put(directory, kCentral, 4);
    Put(directory, kVersion, 2);
    directory += common;
    directory.append(10, '\0');  // No comment, on this disk, no attributes.
    Put(directory, out.size(), 4);
    directory += entry.path;
    Put(out, kLocal, 4);
    out += common + entry.path + packed;
  }
  const std::size_t begin = out.size();
  out += directory;
  Put(out, kEnd, 4);
  Put(out, 0, 4);
  Put(out, entries.size(), 2);
  Put(out, entries.size(), 2);
  Put(out, directory.size(), 4);
  Put(out, begin, 4);
  Put(out, 0, 2);
  return out;
}

Result<std::vector<ZipEntry>> ReadZip(std::string_view zip, std::size_t most_files, std::uintmax_t most_bytes) {
  if (zip.size() < kEndBytes) return Damaged("it is too short");
  std::size_t end = zip.size() - kEndBytes;
  const std::size_t lowest = end > kMostComment ? end - kMostComment : 0;
  while (end > lowest && Get(zip, end, 4) != kEnd) --end;
  if (Get(zip, end, 4) != kEnd) return Damaged("its end is missing");
  const std::size_t count = Get(zip, end + 10, 2);
  std::size_t at = Get(zip, end + 16, 4);
  std::vector<ZipEntry> entries;
  std::uintmax_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (at > zip.size() || zip.size() - at < kCentralBytes || Get(zip, at, 4) != kCentral)
      return Damaged("its list of files is cut");
    const std::uint32_t flags = Get(zip, at + 8, 2), method = Get(zip, at + 10, 2), crc = Get(zip, at + 16, 4);
    const std::size_t packed = Get(zip, at + 20, 4), name = Get(zip, at + 28, 2), extra = Get(zip, at + 30, 2),
                      comment = Get(zip, at + 32, 2), local = Get(zip, at + 42, 4);
    if (zip.size() - at - kCentralBytes < name + extra + comment) return Damaged("its list of files is cut");
    ZipEntry entry;
    entry.path = zip.substr(at + kCentralBytes, name);
    at += kCentralBytes + name + extra + comment;
    if (entry.path.ends_with('/')) continue;
    if (entries.size() == most_files)
      return NewProblem("this archive holds more than " + std::to_string(most_files) + " files");
    if ((flags & kEncrypted) != 0 || (method != kStored && method != kDeflated))
      return NewProblem("this archive is packed in a way that the server does not know: " + entry.path,
                        "pack it with the usual settings, without a password");
    if (local > zip.size() || zip.size() - local < kLocalBytes || Get(zip, local, 4) != kLocal)
      return Damaged(entry.path + " is missing");
    const std::size_t begin = local + kLocalBytes + Get(zip, local + 26, 2) + Get(zip, local + 28, 2);
    if (begin > zip.size() || zip.size() - begin < packed) return Damaged(entry.path + " is cut");
    const std::string_view bytes = zip.substr(begin, packed);
    const std::uintmax_t room = most_bytes - sum;
    std::optional<std::string> whole = method == kStored ? std::optional<std::string>(bytes) : Inflate(bytes, room);
    if (whole && whole->size() > room) whole.reset();
    if (!whole)
      return NewProblem(entry.path + " in this archive is damaged, or its files together need more than " +
                        std::to_string(most_bytes >> 20) + " MB");
    if (Sum(*whole) != crc) return Damaged(entry.path + " is damaged");
    sum += whole->size();
    entry.bytes = *std::move(whole);
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace soarbox::serve
