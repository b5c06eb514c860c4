// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

namespace sml {
class Agent;
struct AgentData;
}  // namespace sml

namespace soarbox {

/// The input link of an agent whose kernel is in this process, without the elements of the client API: the kernel has
/// the only copy of the input. For the project's own programs that write much input; not installed.
///
/// As with the client API, the next input phase applies the changes in the order of the calls. Other clients of the
/// kernel would not see time tags and names of a client here, so there must be none. A handle of a removed element, and
/// kNone, have no effect. Use it while a CallBatch exists (soarbox_Observation.h). Destroy it before its agent.
class DirectInput {
 public:
  enum class Object : std::uint32_t { kInputLink = 0, kNone = 0xFFFFFFFFu };
  enum class Element : std::uint32_t { kNone = 0xFFFFFFFFu };

  /// Returns null if the kernel is in another process, if other clients may connect to it, or if it logs its clients'
  /// acts. An agent has at most one. `write_again` must add the entire input again: init-soar has removed it and made
  /// all handles invalid. It is called after the input of the client API was restored.
  static std::unique_ptr<DirectInput> Open(sml::Agent& agent, std::function<void()> write_again);
  ~DirectInput();
  DirectInput(const DirectInput&) = delete;
  DirectInput& operator=(const DirectInput&) = delete;

  /// False if the agent was destroyed or the kernel was shut down. No other function may be called then.
  bool IsUsable() const;

  /// Texts end at the first zero byte, as in the client API. An element without an attribute is not added.
  Element Add(Object parent, std::string_view attribute, std::string_view value);
  Element Add(Object parent, std::string_view attribute, std::int64_t value);
  Element Add(Object parent, std::string_view attribute, double value);
  /// Adds a new object. `object` is set to its handle.
  Element AddObject(Object parent, std::string_view attribute, Object& object);
  /// Replaces the element by one with another value. The handle stays valid.
  void Update(Element element, std::string_view value);
  void Update(Element element, std::int64_t value);
  void Update(Element element, double value);
  void Remove(Element element);

 private:
  explicit DirectInput(sml::AgentData& data) : data_(data) {}

  sml::AgentData& data_;
};

}  // namespace soarbox
