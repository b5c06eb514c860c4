// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/xml_reader.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

namespace soarbox::wire {

namespace {

bool IsSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool IsNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<unsigned char>(c) >= 0x80;
}

constexpr auto kNameCharacters = [] {
  std::array<bool, 256> in_names{};
  for (std::size_t c = 0; c < in_names.size(); ++c) {
    in_names[c] = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == ':' ||
                  c == '-' || c == '.' || c >= 0x80;
  }
  return in_names;
}();

bool IsNameCharacter(char c) {
  return kNameCharacters[static_cast<unsigned char>(c)];
}

bool IsOnlySpace(std::string_view text) {
  for (char c : text) {
    if (!IsSpace(c)) return false;
  }
  return true;
}

void AppendUtf8(std::string& out, std::uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xF0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

/// Parses without recursion: open elements are on an explicit stack, so that deep nesting cannot overflow the call
/// stack.
class Reader {
 public:
  Reader(std::string_view document, const ReadLimits& limits) : text_(document), limits_(limits) {}

  Result<Element> Read() {
    if (!SkipMisc()) return Error();
    if (AtEnd() || text_[at_] != '<') return Fail("a document must begin with an element");
    if (!ReadElement()) return Error();
    if (!SkipMisc()) return Error();
    if (!AtEnd()) return Fail("there is text after the end of the document's element");
    return std::move(root_);
  }

 private:
  bool AtEnd() const { return at_ >= text_.size(); }
  bool StartsWith(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
  void SkipSpace() {
    while (!AtEnd() && IsSpace(text_[at_])) ++at_;
  }

  Diagnostic Error() const {
    Diagnostic diagnostic;
    diagnostic.message = message_;
    diagnostic.line = 1;
    diagnostic.column = 1;
    for (std::size_t i = 0; i < at_ && i < text_.size(); ++i) {
      ++diagnostic.column;
      if (text_[i] == '\n') {
        ++diagnostic.line;
        diagnostic.column = 1;
      }
    }
    return diagnostic;
  }

  bool Bad(std::string_view message) {
    message_ = message;
    return false;
  }

  Diagnostic Fail(std::string_view message) {
    message_ = message;
    return Error();
  }

  /// Skips everything up to and including `end`. Returns false if it is missing.
  bool SkipTo(std::string_view end, std::string_view what) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) return Bad(what);
    at_ = found + end.size();
    return true;
  }

  /// Skips white space, comments and processing instructions.
  bool SkipMisc() {
    while (true) {
      SkipSpace();
      if (StartsWith("<!--")) {
        if (!SkipTo("-->", "a comment is not closed")) return false;
      } else if (StartsWith("<?")) {
        if (!SkipTo("?>", "a header is not closed")) return false;
      } else if (StartsWith("<!")) {
        return Bad("document types are not accepted");
      } else {
        return true;
      }
    }
  }

  std::optional<std::string_view> ReadName() {
    const std::size_t begin = at_;
    if (AtEnd() || !IsNameStart(text_[at_])) return std::nullopt;
    while (!AtEnd() && IsNameCharacter(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  bool AppendEntity(std::string& out) {
    const std::size_t end = text_.find(';', at_);
    if (end == std::string_view::npos || end - at_ > 12) return Bad("an '&' is not followed by an entity");
    const std::string_view name = text_.substr(at_ + 1, end - at_ - 1);
    if (name == "lt") {
      out += '<';
    } else if (name == "gt") {
      out += '>';
    } else if (name == "amp") {
      out += '&';
    } else if (name == "quot") {
      out += '"';
    } else if (name == "apos") {
      out += '\'';
    } else if (name.size() > 1 && name[0] == '#') {
      const bool hexadecimal = name[1] == 'x' || name[1] == 'X';
      const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
      std::uint32_t code = 0;
      const auto [stop, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
      const bool legal = error == std::errc() && stop == digits.data() + digits.size() && code != 0 &&
                         code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
      if (!legal) return Bad("a character reference is not a valid character");
      AppendUtf8(out, code);
    } else {
      return Bad("an entity is unknown");
    }
    at_ = end + 1;
    return true;
  }

  /// Reads text with entities up to `stop`, which is not consumed.
  bool ReadText(char stop, std::string& out) {
    while (!AtEnd() && text_[at_] != stop) {
      if (text_[at_] == '&') {
        if (!AppendEntity(out)) return false;
        continue;
      }
      if (text_[at_] == '\0') return Bad("a document must not contain zero bytes");
      const std::size_t begin = at_;
      while (!AtEnd() && text_[at_] != stop && text_[at_] != '&' && text_[at_] != '\0') ++at_;
      out.append(text_, begin, at_ - begin);
    }
    return true;
  }

  bool ReadAttributes(Element& element) {
    while (true) {
      SkipSpace();
      if (AtEnd()) return Bad("a tag is not closed");
      if (text_[at_] == '>' || text_[at_] == '/') return true;
      const auto name = ReadName();
      if (!name) return Bad("an attribute's name is expected here");
      SkipSpace();
      if (AtEnd() || text_[at_] != '=') return Bad("an attribute has no value");
      ++at_;
      SkipSpace();
      if (AtEnd() || (text_[at_] != '"' && text_[at_] != '\'')) return Bad("an attribute's value must be in quotes");
      const char quote = text_[at_++];
      std::string value;
      if (!ReadText(quote, value)) return false;
      if (AtEnd()) return Bad("an attribute's value is not closed");
      ++at_;
      if (element.attributes.size() >= limits_.max_attributes) return Bad("an element has too many attributes");
      if (!element.Attribute(*name)) element.Set(std::string(*name), std::move(value));
    }
  }

  /// Reads "<tag attributes>" or "<tag attributes/>" into the element; `closed` is set for the latter form.
  bool ReadStartTag(Element& element, bool& closed) {
    ++at_;
    const auto name = ReadName();
    if (!name) return Bad("a tag's name is expected here");
    element.tag = *name;
    if (++elements_ > limits_.max_elements) return Bad("the document has too many elements");
    if (!ReadAttributes(element)) return false;
    closed = text_[at_] == '/';
    if (closed) ++at_;
    if (AtEnd() || text_[at_] != '>') return Bad("a tag is not closed");
    ++at_;
    return true;
  }

  bool ReadEndTag(const Element& element) {
    at_ += 2;
    const auto name = ReadName();
    if (!name || *name != element.tag) return Bad("an end tag does not match its start tag");
    SkipSpace();
    if (AtEnd() || text_[at_] != '>') return Bad("an end tag is not closed");
    ++at_;
    return true;
  }

  bool ReadElement() {
    bool closed = false;
    if (!ReadStartTag(root_, closed)) return false;
    if (closed) return true;
    std::vector<Element*> open{&root_};
    std::string block;
    while (!open.empty()) {
      Element& element = *open.back();
      if (AtEnd()) return Bad("an element is not closed");
      if (text_[at_] != '<') {
        block.clear();
        if (!ReadText('<', block)) return false;
        if (!IsOnlySpace(block) || (element.children.empty() && StartsWith("</"))) element.text = block;
      } else if (StartsWith("<!--")) {
        if (!SkipTo("-->", "a comment is not closed")) return false;
      } else if (StartsWith("<![CDATA[")) {
        const std::size_t begin = at_ + 9;
        if (!SkipTo("]]>", "a character data section is not closed")) return false;
        element.text = text_.substr(begin, at_ - 3 - begin);
        if (element.text.find('\0') != std::string::npos) return Bad("a document must not contain zero bytes");
      } else if (StartsWith("<?")) {
        if (!SkipTo("?>", "a processing instruction is not closed")) return false;
      } else if (StartsWith("</")) {
        if (!ReadEndTag(element)) return false;
        open.pop_back();
      } else {
        if (static_cast<int>(open.size()) >= limits_.max_depth) return Bad("elements are nested too deeply");
        Element& child = element.Add({});
        if (!ReadStartTag(child, closed)) return false;
        if (!closed) open.push_back(&child);
      }
    }
    return true;
  }

  std::string_view text_;
  ReadLimits limits_;
  std::size_t at_ = 0;
  std::size_t elements_ = 0;
  std::string message_;
  Element root_;
};

}  // namespace

Result<Element> ReadXml(std::string_view document, const ReadLimits& limits) {
  return Reader(document, limits).Read();
}

}  // namespace soarbox::wire
