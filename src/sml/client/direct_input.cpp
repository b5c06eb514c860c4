// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/agent.h"
#include "sml/client/agent_data.h"
#include "sml/client/local_agent_link.h"
#include "soarbox_DirectInput.h"

namespace soarbox {
namespace {

std::string_view UpToZero(std::string_view text) {
  return text.substr(0, text.find('\0'));
}

/// The lower 32 bits of a handle are the kernel's handle plus 1. For an element, the upper 32 bits are the number of
/// its addition.
class DirectInput final : public mind::InputWriter {
 public:
  DirectInput(sml::AgentData& data, std::function<void()> write_again) : data_(data) {
    data_.write_direct_input = [this, write_again = std::move(write_again)] {
      added_ = 0;
      write_again();
    };
  }
  ~DirectInput() override { data_.write_direct_input = nullptr; }

  Handle InputLink() override { return HandleOf(kernel::InputObject::kInputLink); }
  Handle Add(Handle object, std::string_view attribute, const mind::Value& value) override {
    if (const auto* text = std::get_if<std::string_view>(&value)) return AddValue(object, attribute, UpToZero(*text));
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return AddValue(object, attribute, *integer);
    return AddValue(object, attribute, std::get<double>(value));
  }
  Handle AddObject(Handle object, std::string_view attribute, Handle& made) override {
    made = 0;
    if (object == 0 || UpToZero(attribute).empty() || !IsUsable()) return 0;
    made = HandleOf(Link().NewObject());
    return AddLink(object, attribute, made);
  }
  Handle AddLink(Handle object, std::string_view attribute, Handle to) override {
    return AddValue(object, attribute, KernelHandle<kernel::InputObject>(to));
  }
  void Change(Handle element, const mind::Value& value) override {
    if (!IsUsable()) return;
    const auto changed = KernelHandle<kernel::InputElement>(element);
    if (const auto* number = std::get_if<double>(&value)) return Link().Update(changed, *number);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return Link().Update(changed, *integer);
    Link().Update(changed, UpToZero(std::get<std::string_view>(value)));
  }
  void Remove(Handle element) override {
    if (IsUsable()) Link().Remove(KernelHandle<kernel::InputElement>(element));
  }

 private:
  static Handle HandleOf(kernel::InputObject object) { return Handle{static_cast<std::uint32_t>(object)} + 1; }
  template <typename Kernel>
  static Kernel KernelHandle(Handle handle) {
    return static_cast<Kernel>(static_cast<std::uint32_t>(handle) - 1);
  }

  /// False if the agent was destroyed or the kernel was shut down.
  bool IsUsable() const { return data_.link != nullptr && !data_.kernel_data().shut_down; }
  kernel::InputLink& Link() { return static_cast<sml::LocalAgentLink&>(*data_.link).hosted().agent().input(); }

  Handle AddValue(Handle object, std::string_view attribute, const kernel::InputValue& value) {
    attribute = UpToZero(attribute);
    if (object == 0 || attribute.empty() || !IsUsable()) return 0;
    const kernel::InputElement element = Link().Add(KernelHandle<kernel::InputObject>(object), attribute, value);
    return Handle{++added_} << 32 | (static_cast<std::uint32_t>(element) + 1);
  }

  sml::AgentData& data_;
  std::uint32_t added_ = 0;
};

}  // namespace

std::unique_ptr<mind::InputWriter> OpenDirectInput(sml::Agent& agent, std::function<void()> write_again) {
  sml::AgentData& data = sml::AgentData::Of(agent);
  auto* const link = sml::LocalLinkOf(agent);
  if (link == nullptr || link->host().Port() != 0 || link->hosted().log != nullptr || data.write_direct_input)
    return nullptr;
  return std::make_unique<DirectInput>(data, std::move(write_again));
}

}  // namespace soarbox
