// SPDX-License-Identifier: BSD-2-Clause
#include "serve/page_message.h"

#include <cstddef>
#include <nlohmann/json.hpp>

namespace soarbox::serve {
namespace {

using PlainJson = nlohmann::json;

constexpr std::size_t kMostDepth = 64, kMostFields = 256, kMostValues = 20'000;
constexpr std::size_t kMostPanels = 64, kMostPanelBytes = 40;

/// Receives the values of a message from the parser. A function that returns false ends the parse.
class Fields {
 public:
  bool null() { return Value(); }
  bool boolean(bool value) { return Id(value) && Value(); }
  bool number_integer(PlainJson::number_integer_t value) { return Id(value) && Value(); }
  bool number_unsigned(PlainJson::number_unsigned_t value) { return Id(value) && Value(); }
  bool number_float(PlainJson::number_float_t, const PlainJson::string_t& text) {
    if (IsTop() && key_ == "id") message_.id = text;
    return Value();
  }
  bool string(PlainJson::string_t& value) {
    if (IsTop() && key_ == "request") message_.request = value;
    if (IsTop() && key_ == "what") message_.what = value;
    if (IsPanel()) {
      has_panels_ = has_panels_ && value.size() <= kMostPanelBytes && panels_.size() < kMostPanels;
      if (has_panels_) panels_.push_back(value);
    }
    constexpr std::size_t kMostIdBytes = 100;
    return (value.size() > kMostIdBytes || Id(value)) && Value();
  }
  bool binary(PlainJson::binary_t&) { return Value(); }
  bool start_object(std::size_t) { return Open(false); }
  bool key(PlainJson::string_t& name) {
    if (IsTop()) key_ = name;
    return ++fields_.back() <= kMostFields;
  }
  bool end_object() { return Close(); }
  bool start_array(std::size_t) { return Open(true); }
  bool end_array() { return Close(); }
  bool parse_error(std::size_t, const std::string&, const PlainJson::exception&) { return false; }

  std::optional<PageMessage> Take() {
    if (!is_object_ || message_.request.empty()) return std::nullopt;
    if (has_panels_) message_.panels = std::move(panels_);
    return std::move(message_);
  }

 private:
  bool IsTop() const { return fields_.size() == 1; }
  bool IsPanel() const { return fields_.size() == 2 && is_in_panels_; }
  template <typename T>
  bool Id(const T& value) {
    if (IsTop() && key_ == "id")
      message_.id = PlainJson(value).dump(-1, ' ', true, PlainJson::error_handler_t::replace);
    return true;
  }
  bool Value() {
    if (IsPanel() && ++panel_values_ != panels_.size()) has_panels_ = false;
    return ++values_ <= kMostValues;
  }
  bool Open(bool is_array) {
    if (fields_.empty()) is_object_ = !is_array;
    if (IsPanel()) has_panels_ = false;
    if (IsTop() && key_ == "panels") has_panels_ = is_in_panels_ = is_array;
    fields_.push_back(0);
    return fields_.size() <= kMostDepth && ++values_ <= kMostValues;
  }
  bool Close() {
    fields_.pop_back();
    if (IsTop()) is_in_panels_ = false;
    return true;
  }

  PageMessage message_;
  std::string key_;                  ///< Of the outermost object.
  std::vector<std::size_t> fields_;  ///< For each open object.
  std::vector<std::string> panels_;
  std::size_t values_ = 0, panel_values_ = 0;
  bool is_object_ = false, is_in_panels_ = false, has_panels_ = false;
};

}  // namespace

std::optional<PageMessage> ReadPageMessage(std::string_view text) {
  Fields fields;
  if (!PlainJson::sax_parse(text.begin(), text.end(), &fields)) return std::nullopt;
  return fields.Take();
}

}  // namespace soarbox::serve
