// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "vocabulary/vocabulary.h"

namespace sml {
class Agent;
}

namespace soarbox::sim {

/// A percept as it is on the input link of an agent: the only copy of it outside the kernel. It is small, so that the
/// percepts of an object are close together in memory; most of them are only compared. The texts that it points to
/// belong to the InputMirror that contains it.
struct PerceptSlot {
  enum class Kind : std::uint8_t { kInteger, kFloat, kText, kObject };
  struct Object {
    std::vector<PerceptSlot>* below;
    std::uint64_t handle;  ///< See PerceptLink.
  };
  static constexpr std::size_t kShort = 16;
  static constexpr std::uint8_t kLong = 0xFF;

  union {
    std::int64_t integer = 0;
    double number;
    char text[kShort];             ///< A short text.
    const std::string* long_text;  ///< A text of more than kShort bytes.
    Object object;
  };
  /// Identifies the attribute: a row of the table of percepts, or the text of another attribute.
  union {
    const vocabulary::PerceptRow* row = nullptr;
    const std::string* other;
  };
  std::uint64_t element = 0;  ///< See PerceptLink.
  std::uint32_t key = 0;
  Kind kind = Kind::kText;
  std::uint8_t size = 0;  ///< Size of a text, or kLong.
  std::uint8_t attribute_size = 0;
  bool has_row = false;

  std::string_view Attribute() const {
    return has_row ? row->path.substr(row->path.size() - attribute_size) : std::string_view(*other);
  }
  std::string_view Text() const { return size == kLong ? std::string_view(*long_text) : std::string_view(text, size); }
};
using PerceptSlots = std::vector<PerceptSlot>;

/// The input link of one agent, as its InputMirrors write to it. There are two ways to the kernel:
/// * to our kernel in this process, if no other client can see the input: directly (soarbox_DirectInput.h). After
///   init-soar, the link writes all percepts again, in the order in which they were first added;
/// * to any other kernel: through the client API, which does this itself and has its own copy of the input.
/// Both have the same effects on the agent: the same elements, in the same order, with the same time tags. If others
/// write the input of the agent, too, use kClientApi: after init-soar, the elements of the client API are written
/// first.
///
/// `element` and `handle` of slots are values of the present way. Use it while no other thread uses the kernel. Destroy
/// it before its agent, and with its InputMirrors.
class PerceptLink {
 public:
  enum class Way : std::uint8_t { kShortest, kClientApi };
  explicit PerceptLink(sml::Agent& agent, Way way = Way::kShortest);
  ~PerceptLink();
  PerceptLink(const PerceptLink&) = delete;
  PerceptLink& operator=(const PerceptLink&) = delete;

  /// Percepts directly on the input link that must be written again after init-soar. Not owned.
  void Include(PerceptSlots& top) { tops_.push_back(&top); }

  /// Forgets the agent, which may be destroyed before this then. Nothing is added or changed any more.
  void Close();

  /// The handle of the input link.
  std::uint64_t InputLink();
  /// Adds the percept of the slot to an object, and sets its `element`, and `handle` for objects. Returns false if the
  /// kernel no longer answers.
  bool Add(std::uint64_t parent, PerceptSlot& slot);
  /// Replaces the element of a constant by one with the slot's new value.
  void Change(const PerceptSlot& slot);
  /// Removes the percept, with everything below it.
  void Remove(const PerceptSlot& slot);

 private:
  struct Direct;
  struct EndDirect {
    void operator()(Direct* direct) const;
  };

  bool AddDirectly(std::uint64_t parent, PerceptSlot& slot);
  void WriteAgain(std::uint64_t parent, std::vector<PerceptSlot*> slots);

  sml::Agent& agent_;
  std::unique_ptr<Direct, EndDirect> direct_;  ///< Null: the client API is used.
  bool is_closed_ = false;
  std::vector<PerceptSlots*> tops_;
  std::uint32_t added_ = 0;  ///< Number of percepts that were added directly.
};

}  // namespace soarbox::sim
