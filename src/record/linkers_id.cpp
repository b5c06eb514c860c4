// SPDX-License-Identifier: BSD-2-Clause
#include "record/linkers_id.h"

#include <elf.h>
#include <link.h>

#include <cstring>

namespace soarbox::record {

std::string LinkersId() {
  std::string id;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* found) {
        for (int i = 0; i < info->dlpi_phnum; ++i) {
          const ElfW(Phdr)& segment = info->dlpi_phdr[i];
          if (segment.p_type != PT_NOTE) continue;
          const char* at = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
          const char* const end = at + segment.p_memsz;
          while (at + sizeof(ElfW(Nhdr)) <= end) {
            ElfW(Nhdr) note;
            std::memcpy(&note, at, sizeof note);
            const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
            const char* const name = at + sizeof note;
            const char* const content = name + padded(note.n_namesz);
            if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0) {
              for (std::size_t b = 0; b < note.n_descsz; ++b) {
                constexpr char kDigits[] = "0123456789abcdef";
                const auto byte = static_cast<unsigned char>(content[b]);
                static_cast<std::string*>(found)->append({kDigits[byte >> 4], kDigits[byte & 15]});
              }
              return 1;
            }
            at = content + padded(note.n_descsz);
          }
        }
        return 1;  // The first object is the program itself.
      },
      &id);
  return id;
}

}  // namespace soarbox::record
