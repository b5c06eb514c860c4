// SPDX-License-Identifier: BSD-2-Clause
#include "stream/deflate.h"

#include <zlib.h>

namespace soarbox::stream {

std::string Deflate(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), 4) != Z_OK)
    return {};
  out.resize(size);
  return out;
}

}  // namespace soarbox::stream
