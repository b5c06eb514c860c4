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

/// The beginning of an entity type. Parts that are not set match any number.
struct TypePattern {
  std::array<std::optional<std::uint16_t>, 7> parts;

  bool Fits(const EntityType& type) const;
  /// The entity type with these numbers; 0 for parts that are not set.
  EntityType Type() const;
};
/// Parses "3.1.225.1" or "3.1.*.1". Returns nothing if the text is invalid.
std::optional<TypePattern> ParseTypePattern(std::string_view text);

/// Relates bodies and entity types, for our agents and for foreign entities. The first matching row is used.
struct EntityRow {
  TypePattern type;
  std::string body;  ///< A kind of body (docs/scenarios.md).
};

/// The effect of a munition on our bodies.
struct MunitionRow {
  TypePattern type;
  float damage = 20;   ///< Health that a hit removes.
  float radius_m = 0;  ///< Bodies within this distance also lose health, less with distance.
};

/// How a scenario takes part in an exercise: `[dis]` in its file, or `--dis`. docs/dis.md describes it.
struct Settings {
  std::string address = "127.0.0.1";    ///< Destination of PDUs: a host, a broadcast address or a multicast group.
  std::string interface = "127.0.0.1";  ///< For a multicast group: the address of the network interface to use.
  std::uint16_t port = 3000;
  std::uint16_t site = 1, application = 1;
  std::uint8_t exercise = 1;
  std::uint8_t version = 7;
  Geodetic anchor{47.3976, 8.5486, 408};
  double heartbeat_s = 5;    ///< Interval at which the state of an unchanged entity is sent.
  double timeout_s = 12;     ///< A foreign entity that sends nothing for this time is removed.
  double threshold_m = 0.5;  ///< Maximum distance of an entity from its extrapolated position.
  double threshold_deg = 3;
  std::size_t most_entities = 1000;            ///< Maximum number of foreign entities.
  bool takes_orders = false;                   ///< Obey Start/Resume and Stop/Freeze of others.
  bool listens_only = false;                   ///< Sends nothing.
  std::map<std::string, std::uint8_t> forces;  ///< By team.
  std::vector<EntityRow> entities;
  std::vector<MunitionRow> munitions;

  /// 0 (other) for teams without an entry.
  std::uint8_t ForceOf(const std::string& team) const;
  /// The team with this force; "foreign" if there is none.
  std::string TeamOf(std::uint8_t force) const;
  EntityType TypeOf(std::string_view body) const;
  /// The kind of body for a foreign entity; "walker" if no row matches.
  std::string_view BodyOf(const EntityType& type) const;
  const MunitionRow& MunitionOf(const EntityType& type) const;
};

/// Adds `[dis]` of a scenario file to the settings `over`. Returns nothing if the file has none. Errors name file and
/// line.
Result<std::optional<Settings>> ReadSettings(const std::filesystem::path& scenario, Settings over);
/// Reads the table of entities and munitions that comes with the program.
Result<Settings> ReadTable(const std::filesystem::path& table);
/// Parses ADDRESS:PORT[,SITE[,APPLICATION[,EXERCISE]]], the argument of `--dis`, and adds it to the settings `over`.
Result<Settings> ParseOption(std::string_view option, Settings over);

}  // namespace soarbox::dis
