// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/longterm/installer.h"
#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {

/// A fingerprint of a command. The command has changed if the fingerprint has.
struct CommandStamp {
  std::uint64_t count = 0, time = 0;
  friend bool operator==(const CommandStamp&, const CommandStamp&) = default;
};

/// The command of one state, parsed from its elements.
struct SemanticCommand {
  enum class Kind { kNone, kBad, kStore, kStoreNew, kRetrieve, kQuery };

  std::vector<WmeId> wmes;  ///< On the command link, and those of ^query and ^store objects; last: that of ^result.
  CommandStamp store, other;
  Kind kind = Kind::kNone;
  std::vector<Symbol> stored;  ///< In the order of their elements.
  Symbol asked;                ///< ^retrieve, ^query
  Symbol negative, math;
  std::vector<Symbol> prohibited;
  std::int64_t depth = 1;
  bool link = true;  ///< link-to-ltm, or link-to-new-ltm.

  /// Makes it ready for the next command, keeping its memory.
  void Clear() {
    wmes.clear();
    store = other = {};
    kind = Kind::kNone;
    stored.clear();
    asked = negative = math = Symbol();
    prohibited.clear();
    depth = 1;
    link = true;
  }
};

/// The elements that a retrieval adds to working memory.
struct Retrieval {
  /// The identifier of an object, and whether the walk along its links has reached it.
  struct Made {
    std::uint32_t object = 0;
    Symbol id;
    bool is_opened = false;
  };
  std::vector<Triple> contents;
  std::vector<Made> made;      ///< One per object, by object.
  std::vector<Symbol> deeper;  ///< Objects added by ^depth, in order.
  std::vector<Triple> meta;    ///< The elements of ^result.
  // Scratch.
  std::vector<RankedEdge> edges;
  std::vector<std::uint32_t> wave, next;

  void Clear() {
    contents.clear();
    made.clear();
    deeper.clear();
    meta.clear();
  }
};

}  // namespace soarbox::kernel
