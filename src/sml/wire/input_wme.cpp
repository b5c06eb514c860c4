// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/input_wme.h"

#include <cstdlib>
#include <string>

#include "sml/wire/message.h"

namespace soarbox::wire {

void AddWme(Element& command, const InputWme& wme) {
  Element& element = command.Add("wme");
  element.Set("action", wme.add ? "add" : "remove");
  if (!wme.add) {
    element.Set("tag", std::to_string(wme.tag));
    return;
  }
  element.Set("attr", std::string(wme.attribute)).Set("id", std::string(wme.id)).Set("tag", std::to_string(wme.tag));
  switch (wme.type) {
    case InputWme::Type::kString:
      element.Set("value", std::string(wme.text));
      break;
    case InputWme::Type::kInt:
      element.Set("valtype", "int").Set("value", std::to_string(wme.integer));
      break;
    case InputWme::Type::kDouble:
      element.Set("valtype", "double").Set("value", ShortDouble(wme.real));
      break;
    case InputWme::Type::kId:
      element.Set("valtype", "id").Set("value", std::string(wme.text));
      break;
  }
}

InputWme ReadWme(const Element& element) {
  const auto text = [&](std::string_view name) -> const std::string& {
    static const std::string kMissing;
    const std::string* value = element.Attribute(name);
    return value ? *value : kMissing;
  };
  InputWme wme;
  wme.add = text("action") != "remove";
  wme.tag = std::strtoll(text("tag").c_str(), nullptr, 10);
  wme.id = text("id");
  wme.attribute = text("attr");
  wme.text = text("value");
  const std::string& type = text("valtype");
  if (type == "int") {
    wme.type = InputWme::Type::kInt;
    wme.integer = std::strtoll(text("value").c_str(), nullptr, 10);
  } else if (type == "double") {
    wme.type = InputWme::Type::kDouble;
    wme.real = std::strtod(text("value").c_str(), nullptr);
  } else if (type == "id") {
    wme.type = InputWme::Type::kId;
  }
  return wme;
}

}  // namespace soarbox::wire
