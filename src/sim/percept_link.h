// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mind/input_writer.h"
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
    mind::InputWriter::Handle handle;
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
  mind::InputWriter::Handle element = 0;
  std::uint32_t key = 0;
  Kind kind = Kind::kText;
  std::uint8_t size = 0;  ///< Size of a text, or kLong.
  std::uint8_t attribute_size = 0;
  bool has_row = false;

  std::string_view Attribute() const {
    return has_row ? row->path.substr(row->path.size() - attribute_size) : std::string_view(*other);
  }
  std::string_view Text() const { return size == kLong ? std::string_view(*long_text) : std::string_view(text, size); }
  /// The value of a constant.
  mind::Value Value() const;
};
using PerceptSlots = std::vector<PerceptSlot>;

/// The input link of one agent, as its InputMirrors and its GraphMirror write to it. It uses the shortest way:
/// * to our kernel in this process, if no other client can see the input: directly (soarbox_DirectInput.h). After
///   init-soar, the link writes all percepts again, depth first, in the order in which they were first added;
/// * to any other kernel: through the client API (client_input.h), which does this itself and has its own copy.
/// Both have the same effects on the agent: the same elements, in the same order, with the same time tags.
///
/// Use it while no other thread uses the kernel. Destroy it before its agent, and with its mirrors.
class PerceptLink {
 public:
  using Handle = mind::InputWriter::Handle;
  /// An element that is written again after init-soar, with everything below it.
  struct Again {
    Handle element = 0;  ///< Its previous handle.
    /// Writes it, and appends what is directly below it.
    std::function<void(std::vector<Again>& below)> write;
  };
  using Lister = std::function<void(std::vector<Again>& again)>;

  explicit PerceptLink(sml::Agent& agent);
  explicit PerceptLink(std::unique_ptr<mind::InputWriter> input) : input_(std::move(input)) {}
  PerceptLink(const PerceptLink&) = delete;
  PerceptLink& operator=(const PerceptLink&) = delete;

  /// Percepts directly on the input link that must be written again after init-soar. Not owned.
  void Include(PerceptSlots& top) {
    Include([this, &top](std::vector<Again>& again) { ListAgain(InputLink(), top, again); });
  }
  void Include(Lister list) { listers_.push_back(std::move(list)); }

  /// Forgets the agent, which may be destroyed before this then. Nothing is added or changed any more.
  void Close() { input_.reset(); }
  /// Null after Close.
  mind::InputWriter* input() { return input_.get(); }

  Handle InputLink() { return input_ == nullptr ? 0 : input_->InputLink(); }
  /// Adds the percept of the slot to an object, and sets its `element`, and `handle` for objects. Returns false if the
  /// kernel no longer answers.
  bool Add(Handle object, PerceptSlot& slot);
  /// Replaces the element of a constant by one with the slot's new value.
  void Change(const PerceptSlot& slot) {
    if (input_ != nullptr) input_->Change(slot.element, slot.Value());
  }
  /// Removes the percept, with everything below it.
  void Remove(const PerceptSlot& slot) {
    if (input_ != nullptr) input_->Remove(slot.element);
  }

 private:
  /// Writes elements again, depth first. The elements of one object are in the order in which they were first added.
  static void WriteAgain(std::vector<Again> again);
  void ListAgain(Handle object, PerceptSlots& slots, std::vector<Again>& again);

  std::unique_ptr<mind::InputWriter> input_;
  std::vector<Lister> listers_;
};

}  // namespace soarbox::sim
