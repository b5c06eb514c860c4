// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "dis/earth.h"

namespace soarbox::dis {

/// The beginning of an entity type, part by part; parts that are not given fit any.
struct TypePattern {
  std::array<std::optional<std::uint16_t>, 7> parts;

  bool Fits(const EntityType& type) const;
  /// The type with those numbers, 0 for parts that are not given.
  EntityType Type() const;
};
/// "3.1.225.1", "3.1.*.1". Nothing if it is neither.
std::optional<TypePattern> ParseTypePattern(std::string_view text);

/// What our bodies are in an exercise, and which bodies foreign entities have here. The first row that fits counts.
struct EntityRow {
  TypePattern type;
  std::string body;  ///< A kind of body (docs/scenarios.md).
};

/// What a munition does to a body of ours.
struct MunitionRow {
  TypePattern type;
  float damage = 20;   ///< Health that a hit takes.
  float radius_m = 0;  ///< Bodies within this distance also lose health, less with distance.
};

/// How a scenario takes part in an exercise: `[dis]` of its file, or `--dis`. docs/dis.md describes it.
struct Settings {
  std::string address = "127.0.0.1";    ///< Where PDUs go: a host, a broadcast address or a multicast group.
  std::string interface = "127.0.0.1";  ///< For a group: the address of the interface of this machine to use.
  std::uint16_t port = 3000;
  std::uint16_t site = 1, application = 1;
  std::uint8_t exercise = 1;
  std::uint8_t version = 7;
  Geodetic anchor{47.3976, 8.5486, 408};
  double heartbeat_s = 5;    ///< How often the state of an entity that does not change is sent.
  double timeout_s = 12;     ///< A foreign entity that is silent for so long is removed.
  double threshold_m = 0.5;  ///< How far an entity may be from where others suppose it to be.
  double threshold_deg = 3;
  std::size_t most_entities = 1000;            ///< Foreign entities.
  bool takes_orders = false;                   ///< Start/Resume and Stop/Freeze of others are obeyed.
  bool listens_only = false;                   ///< Sends nothing.
  std::map<std::string, std::uint8_t> forces;  ///< By team.
  std::vector<EntityRow> entities;
  std::vector<MunitionRow> munitions;

  /// 0 (other) for teams that nothing names.
  std::uint8_t ForceOf(const std::string& team) const;
  /// The team of a force; "foreign" if none has it.
  std::string TeamOf(std::uint8_t force) const;
  EntityType TypeOf(std::string_view body) const;
  /// The kind of body for a foreign entity; "walker" if no row fits.
  std::string_view BodyOf(const EntityType& type) const;
  const MunitionRow& MunitionOf(const EntityType& type) const;
};

/// Reads `[dis]` of a scenario file over these settings. Nothing if the file has none; problems name file and line.
Result<std::optional<Settings>> ReadSettings(const std::filesystem::path& scenario, Settings over);
/// Reads the table of entities and munitions that comes with the program.
Result<Settings> ReadTable(const std::filesystem::path& table);
/// ADDRESS:PORT[,SITE,APPLICATION[,EXERCISE]], as `--dis` takes it, over these settings.
Result<Settings> ParseOption(std::string_view option, Settings over);

}  // namespace soarbox::dis
