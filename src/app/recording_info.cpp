// SPDX-License-Identifier: BSD-2-Clause
#include "app/recording_info.h"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "record/manifest.h"

namespace soarbox::app {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson InfoOf(const record::Reader& recording) {
  const record::Header& header = recording.header();
  OrderedJson made{{"file", recording.name()},
                   {"bytes", recording.bytes()},
                   {"scenario", header.scenario},
                   {"seed", header.seed},
                   {"level", record::NameOf(header.level)},
                   {"first_tick", recording.first_tick()},
                   {"last_tick", recording.last_tick()},
                   {"seconds", static_cast<double>(recording.last_tick()) * header.step_s},
                   {"step_s", header.step_s},
                   {"build", header.build},
                   {"kept_files", header.files.size()}};
  if (const record::Waits& waits = recording.waits(); waits.ticks > 0) {
    made["ticks_that_waited"] = waits.ticks;
    made["seconds_waited"] = waits.seconds;
  }
  if (!header.branched_from.empty()) {
    made["branched_from"] = header.branched_from;
    made["branch_tick"] = header.branch_tick;
  }
  if (OrderedJson manifest = OrderedJson::parse(record::ManifestIn(recording.file()), nullptr, false);
      manifest.is_object())
    made["manifest"] = std::move(manifest);
  return made;
}

/// A value in one line; the elements of a list are joined.
std::string ValueText(const OrderedJson& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  std::string text;
  for (const OrderedJson& word : value) text += (text.empty() ? "" : " ") + ValueText(word);
  return text;
}

void PrintDigests(const OrderedJson& digests) {
  for (const auto& [name, digest] : digests.items()) std::cout << "  " << ValueText(digest) << "  " << name << '\n';
}

void PrintEntries(const OrderedJson& entries) {
  for (const auto& [name, value] : entries.items()) {
    if (!value.is_object()) std::cout << fmt::format("{:<15} {}\n", name, ValueText(value));
  }
  for (const auto& [name, value] : entries.items()) {
    if (!value.is_object()) continue;
    std::cout << '\n' << name << '\n';
    if (name == "manifest") {
      PrintEntries(value);
    } else {
      PrintDigests(value);
    }
  }
}

}  // namespace

void PrintRecordingInfo(const record::Reader& recording, bool as_json) {
  const OrderedJson info = InfoOf(recording);
  if (as_json) {
    std::cout << info.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
    return;
  }
  PrintEntries(info);
  if (!info.contains("manifest"))
    std::cout << "\nno manifest: the version of Soarbox that made this recording wrote none\n";
}

}  // namespace soarbox::app
