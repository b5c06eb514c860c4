// SPDX-License-Identifier: BSD-2-Clause
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/base/characters.h"
#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// An element of an XML text: its children, or else its text. An attribute `value` replaces the text.
struct Element {
  std::string tag;
  std::string text;
  bool has_value = false;
  std::vector<Element> children;
};

/// Reads elements, attributes, text, character references, comments and CDATA sections; skips declarations.
class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  /// Parses a text that consists of one element. Returns false if it is anything else.
  bool Read(Element& root) { return SkipBetween() && ReadElement(root, 0) && SkipBetween() && at_ == text_.size(); }

 private:
  static constexpr int kDeepest = 200;

  bool Accept(std::string_view what) {
    if (text_.substr(at_, what.size()) != what) {
      return false;
    }
    at_ += what.size();
    return true;
  }

  void SkipBlanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || (text_[at_] >= '\t' && text_[at_] <= '\r'))) {
      ++at_;
    }
  }

  bool SkipPast(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    return found != std::string_view::npos;
  }

  /// Skips blanks, comments and declarations.
  bool SkipBetween() {
    for (SkipBlanks(); at_ < text_.size(); SkipBlanks()) {
      if (Accept("<!--")) {
        if (!SkipPast("-->")) return false;
      } else if (Accept("<?")) {
        if (!SkipPast("?>")) return false;
      } else if (Accept("<!")) {
        if (!SkipPast(">")) return false;
      } else {
        break;
      }
    }
    return true;
  }

  bool ReadName(std::string& name) {
    const std::size_t start = at_;
    while (at_ < text_.size() &&
           (IsLetter(text_[at_]) || IsDigit(text_[at_]) || text_[at_] == '-' || text_[at_] == '_' ||
            text_[at_] == '.' || text_[at_] == ':' || (text_[at_] & 0x80) != 0)) {
      ++at_;
    }
    name = text_.substr(start, at_ - start);
    return !name.empty();
  }

  /// Reads one character or character reference. Returns false if the reference is unknown.
  bool ReadCharacter(std::string& out) {
    constexpr std::pair<std::string_view, char> kReferences[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};
    if (text_[at_] != '&') {
      out += text_[at_++];
      return true;
    }
    for (const auto& [reference, character] : kReferences) {
      if (Accept(reference)) {
        out += character;
        return true;
      }
    }
    return false;
  }

  bool ReadAttributes(Element& element) {
    for (SkipBlanks(); at_ < text_.size() && text_[at_] != '/' && text_[at_] != '>'; SkipBlanks()) {
      std::string name, value;
      if (!ReadName(name)) return false;
      SkipBlanks();
      if (!Accept("=")) return false;
      SkipBlanks();
      const char quote = at_ < text_.size() ? text_[at_] : '\0';
      if (quote != '"' && quote != '\'') return false;
      ++at_;
      while (at_ < text_.size() && text_[at_] != quote) {
        if (!ReadCharacter(value)) return false;
      }
      if (at_++ >= text_.size()) return false;
      if (name == "value") {
        element.text = value;
        element.has_value = true;
      }
    }
    return true;
  }

  bool ReadElement(Element& element, int depth) {
    if (depth > kDeepest || !Accept("<") || !ReadName(element.tag) || !ReadAttributes(element)) {
      return false;
    }
    if (Accept("/>")) {
      return true;
    }
    if (!Accept(">")) {
      return false;
    }
    std::string text;
    while (at_ < text_.size()) {
      if (Accept("</")) {
        std::string name;
        if (!element.has_value) element.text = std::move(text);
        const bool closes = ReadName(name) && name == element.tag;
        SkipBlanks();
        return closes && Accept(">");
      }
      if (Accept("<![CDATA[")) {
        const std::size_t start = at_;
        if (!SkipPast("]]>")) return false;
        text += text_.substr(start, at_ - start - 3);
      } else if (Accept("<!--")) {
        if (!SkipPast("-->")) return false;
      } else if (text_[at_] == '<') {
        if (!ReadElement(element.children.emplace_back(), depth + 1)) return false;
      } else if (!ReadCharacter(text)) {
        return false;
      }
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Soar names an identifier after the first letter of its attribute, but reserves S for states.
char LetterFor(const std::string& tag) {
  const char letter = ToUpper(tag[0]);
  return !IsLetter(letter) || letter == 'S' ? 'I' : letter;
}

/// Creates the identifier of an element. Later children are created first, in the order of Soar's lists.
Symbol Build(FunctionContext& context, const Element& element) {
  const Symbol identifier = context.NewIdentifier(LetterFor(element.tag));
  std::vector<std::pair<Symbol, Symbol>> parts;
  for (const Element& child : element.children) {
    const Symbol attribute = context.symbols().String(child.tag);
    parts.emplace_back(attribute,
                       child.children.empty() ? context.symbols().String(child.text) : Build(context, child));
  }
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    context.MakePreference(identifier, part->first, part->second);
  }
  return identifier;
}

}  // namespace

Symbol FromXml(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsString()) {
    context.PrintError("Error: from-st-xml needs a text\n");
    return {};
  }
  const std::string text(context.symbols().Text(arguments[0]));
  Element root;
  if (!XmlReader(text).Read(root)) {
    context.PrintError("Error: the text passed to from-st-xml is not one XML element\n");
    return {};
  }
  return Build(context, root);
}

}  // namespace soarbox::kernel::function_bodies
