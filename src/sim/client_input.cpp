// SPDX-License-Identifier: BSD-2-Clause
#include "sim/client_input.h"

#include <string>

#include "sml_Client.h"

namespace soarbox::sim {
namespace {

/// Handles are addresses of elements, and of identifiers.
class ClientInput final : public mind::InputWriter {
 public:
  explicit ClientInput(sml::Agent& agent) : agent_(agent) {}

  Handle InputLink() override { return HandleOf(agent_.GetInputLink()); }
  Handle Add(Handle object, std::string_view attribute, const mind::Value& value) override {
    auto* const parent = PointerOf<sml::Identifier>(object);
    const std::string name(attribute);
    if (const auto* integer = std::get_if<std::int64_t>(&value))
      return ElementHandle(agent_.CreateIntWME(parent, name.c_str(), *integer));
    if (const auto* number = std::get_if<double>(&value))
      return ElementHandle(agent_.CreateFloatWME(parent, name.c_str(), *number));
    return ElementHandle(agent_.CreateStringWME(parent, name.c_str(), Text(value).c_str()));
  }
  Handle AddObject(Handle object, std::string_view attribute, Handle& made) override {
    auto* const added = agent_.CreateIdWME(PointerOf<sml::Identifier>(object), std::string(attribute).c_str());
    made = HandleOf(added);
    return ElementHandle(added);
  }
  Handle AddLink(Handle object, std::string_view attribute, Handle to) override {
    return ElementHandle(agent_.CreateSharedIdWME(PointerOf<sml::Identifier>(object), std::string(attribute).c_str(),
                                                  PointerOf<sml::Identifier>(to)));
  }
  void Change(Handle element, const mind::Value& value) override {
    auto* const changed = PointerOf<sml::WMElement>(element);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      agent_.Update(static_cast<sml::IntElement*>(changed), *integer);
    } else if (const auto* number = std::get_if<double>(&value)) {
      agent_.Update(static_cast<sml::FloatElement*>(changed), *number);
    } else {
      agent_.Update(static_cast<sml::StringElement*>(changed), Text(value).c_str());
    }
  }
  void Remove(Handle element) override { agent_.DestroyWME(PointerOf<sml::WMElement>(element)); }

 private:
  template <typename T>
  static T* PointerOf(Handle handle) {
    return reinterpret_cast<T*>(static_cast<std::uintptr_t>(handle));
  }
  static Handle HandleOf(const void* pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }
  static Handle ElementHandle(const sml::WMElement* element) { return HandleOf(element); }
  static std::string Text(const mind::Value& value) { return std::string(std::get<std::string_view>(value)); }

  sml::Agent& agent_;
};

}  // namespace

std::unique_ptr<mind::InputWriter> OpenClientInput(sml::Agent& agent) {
  return std::make_unique<ClientInput>(agent);
}

}  // namespace soarbox::sim
