// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "diagnostics/number_from_chars.h"
#include "diagnostics/plain_text.h"
#include "sim/input_names.h"

namespace soarbox::sim {
namespace {

constexpr const char* kForms =
    "there are: key NAME down|up|press, button NAME down|up|click X Y, pointer X Y, wheel NOTCHES, screen WIDTH "
    "HEIGHT, "
    "panel BUTTON, pad NUMBER BUTTON down|up|press, pad NUMBER AXIS VALUE, "
    "camera X Y Z, command AGENT TEXT, script AGENT TEXT, order AGENT TEXT, "
    "foreign ID NAME TEAM BODY HEALTH STANCE and 14 numbers, foreign-gone ID, foreign-shot ID TARGET and 8 numbers, "
    "foreign-message ID TEAM ABOUT TEXT";

/// Reads the words of a line one after another. Keeps the first error.
class LineReader {
 public:
  LineReader(std::string_view line, std::string& problem, std::string& hint)
      : line_(line), problem_(problem), hint_(hint) {
    Skip();
  }

  bool AtEnd() const { return rest_at_ >= line_.size() || line_[rest_at_] == '#'; }
  bool ok() const { return problem_.empty(); }
  int column() const { return static_cast<int>(word_at_) + 1; }
  void Fail(std::string problem, std::string hint = {}) {
    if (!ok()) return;
    problem_ = std::move(problem);
    hint_ = std::move(hint);
  }

  /// A word or a quoted text; `what` is used in the error if there is none.
  std::string Word(const char* what) {
    if (!ok()) return {};
    word_at_ = rest_at_;
    if (AtEnd()) {
      Fail(std::string("the line ends where ") + what + " is expected");
      return {};
    }
    if (line_[rest_at_] == '"') return Quoted();
    const std::size_t end = std::min(line_.find_first_of(" \t", rest_at_), line_.size());
    std::string word(line_.substr(rest_at_, end - rest_at_));
    rest_at_ = end;
    Skip();
    return word;
  }

  /// A quoted text, or the rest of the line.
  std::string Text(const char* what) {
    if (!ok()) return {};
    word_at_ = rest_at_;
    if (rest_at_ >= line_.size() || line_[rest_at_] == '"') return Word(what);
    std::string text(line_.substr(rest_at_));
    text.erase(text.find_last_not_of(" \t") + 1);
    rest_at_ = line_.size();
    return text;
  }

  template <class Number>
  Number Value(const char* what) {
    const std::string word = Word(what);
    Number value{};
    const auto [end, error] = NumberFromChars(word, value);
    const bool is_number = error == std::errc{} && end == word.data() + word.size() && !word.empty();
    if (ok() && (!is_number || !std::isfinite(static_cast<double>(value))))
      Fail("'" + word + "' is not " + what + (is_number ? ": it must be finite" : ""));
    return value;
  }

  world::Vec3 Vector(const char* what) {
    world::Vec3 v;
    for (float* at : {&v.x, &v.y, &v.z}) *at = Value<float>(what);
    return v;
  }

  std::string Name(const char* what, const std::vector<std::string>& names) {
    const std::string word = Word(what);
    if (ok() && !std::binary_search(names.begin(), names.end(), word)) {
      const std::string_view near = Suggest(word, {names.begin(), names.end()});
      Fail("'" + word + "' is not " + what, near.empty() ? "" : "did you mean '" + std::string(near) + "'?");
    }
    return word;
  }

  void End() {
    if (!ok()) return;
    word_at_ = rest_at_;
    if (!AtEnd()) Fail("unexpected text at the end of the line: '" + std::string(line_.substr(rest_at_)) + "'");
  }

 private:
  void Skip() {
    while (rest_at_ < line_.size() && (line_[rest_at_] == ' ' || line_[rest_at_] == '\t')) ++rest_at_;
  }

  std::string Quoted() {
    std::string text;
    for (++rest_at_; rest_at_ < line_.size() && line_[rest_at_] != '"'; ++rest_at_) {
      char c = line_[rest_at_];
      if (c == '\\' && rest_at_ + 1 < line_.size()) {
        c = line_[++rest_at_];
        if (c == 'n') c = '\n';
        if (c == 't') c = '\t';
        if (c == 'r') c = '\r';
      }
      text += c;
    }
    if (rest_at_ >= line_.size()) {
      Fail("a quote is not closed");
      return {};
    }
    ++rest_at_;
    Skip();
    return text;
  }

  std::string_view line_;
  std::size_t rest_at_ = 0;
  std::size_t word_at_ = 0;
  std::string& problem_;
  std::string& hint_;
};

struct Place {
  float x = 0, y = 0;
};

/// "down", "up", or the word for both.
std::string ReadHow(LineReader& line, const std::string& both) {
  const std::string how = line.Word("'down' or 'up'");
  if (line.ok() && how != "down" && how != "up" && how != both) line.Fail("'" + how + "' is not down, up or " + both);
  return how;
}

template <class KeyOrButton>
void AddPresses(KeyOrButton input, std::string_view how, std::vector<InputValue>& values) {
  for (const bool pressed : {true, false}) {
    if (how == (pressed ? "up" : "down")) continue;
    input.pressed = pressed;
    values.push_back(input);
  }
}

void ReadPad(LineReader& line, std::vector<InputValue>& values) {
  PadInput input;
  input.pad = line.Value<int>("the number of a gamepad");
  if (line.ok() && (input.pad < 1 || input.pad > kMostPads)) line.Fail("gamepads have numbers from 1 to 8");
  input.part = line.Name("a button or an axis of a gamepad", PadNames());
  if (!IsPadButton(input.part)) {
    input.value = line.Value<float>("a number from -1 to 1");
    if (line.ok() && std::abs(input.value) > 1) line.Fail("an axis has a value from -1 to 1");
    values.push_back(std::move(input));
    return;
  }
  const std::string how = ReadHow(line, "press");
  for (const bool pressed : {true, false}) {
    if (how == (pressed ? "up" : "down")) continue;
    input.value = pressed ? 1.0f : 0.0f;
    values.push_back(input);
  }
}

ForeignBodyInput ReadForeignBody(LineReader& line) {
  ForeignBodyInput input;
  input.id = line.Word("the number of a foreign body");
  input.name = line.Word("a name");
  input.team = line.Word("a team");
  input.body = line.Word("a kind of body");
  input.health = line.Value<float>("a number");
  input.stance = line.Word("a stance");
  input.position = line.Vector("a coordinate");
  input.velocity = line.Vector("a speed");
  input.acceleration = line.Vector("an acceleration");
  input.heading_deg = line.Value<float>("an angle");
  input.turn_dps = line.Value<float>("degrees per second");
  return input;
}

/// The inputs of a line; several for "press" and "click". Empty after an error.
std::vector<InputValue> ReadLine(LineReader& line, Place& pointer) {
  const std::string kind = line.Word("what comes in");
  std::vector<InputValue> values;
  if (kind == "key") {
    KeyInput input{line.Name("a key", KeyNames())};
    const std::string how = ReadHow(line, "press");
    AddPresses(input, how, values);
  } else if (kind == "button") {
    ButtonInput input{line.Name("a button", ButtonNames())};
    const std::string how = ReadHow(line, "click");
    input.x_px = pointer.x = line.Value<float>("a number of pixels");
    input.y_px = pointer.y = line.Value<float>("a number of pixels");
    AddPresses(input, how, values);
  } else if (kind == "pointer") {
    PointerInput input;
    input.x_px = line.Value<float>("a number of pixels");
    input.y_px = line.Value<float>("a number of pixels");
    input.dx_px = input.x_px - pointer.x;
    input.dy_px = input.y_px - pointer.y;
    if (line.ok() && !line.AtEnd()) {
      input.dx_px = line.Value<float>("a number of pixels");
      input.dy_px = line.Value<float>("a number of pixels");
    }
    pointer = {input.x_px, input.y_px};
    values.push_back(input);
  } else if (kind == "wheel") {
    WheelInput input{line.Value<float>("a number of notches"), pointer.x, pointer.y};
    if (line.ok() && !line.AtEnd()) {
      input.x_px = line.Value<float>("a number of pixels");
      input.y_px = line.Value<float>("a number of pixels");
    }
    values.push_back(input);
  } else if (kind == "panel") {
    values.push_back(PanelInput{line.Word("the name of a button of a script")});
  } else if (kind == "pad") {
    ReadPad(line, values);
  } else if (kind == "screen") {
    ScreenInput input;
    input.width_px = line.Value<int>("a number of pixels");
    input.height_px = line.Value<int>("a number of pixels");
    if (line.ok() && (input.width_px < 1 || input.height_px < 1)) line.Fail("a window has a pixel at least");
    values.push_back(input);
  } else if (kind == "camera") {
    CameraInput input;
    for (float* at : {&input.position.x, &input.position.y, &input.position.z}) *at = line.Value<float>("a coordinate");
    if (line.ok() && !line.AtEnd()) {
      world::Quat& turn = input.orientation;
      for (float* at : {&turn.w, &turn.x, &turn.y, &turn.z}) *at = line.Value<float>("a part of a quaternion");
    }
    values.push_back(input);
  } else if (kind == "command") {
    CommandInput input{line.Word("an agent"), {}};
    input.line = line.Text("a command");
    values.push_back(std::move(input));
  } else if (kind == "script") {
    ScriptInput input{line.Word("an agent, or sandbox"), {}};
    if (input.agent == "sandbox") input.agent.clear();
    input.text = line.Text("Lua text");
    values.push_back(std::move(input));
  } else if (kind == "order") {
    OrderInput input{line.Word("an agent"), {}};
    input.order = line.Text("an order");
    values.push_back(std::move(input));
  } else if (kind == "foreign") {
    values.push_back(ReadForeignBody(line));
  } else if (kind == "foreign-gone") {
    values.push_back(ForeignGoneInput{line.Word("the number of a foreign body")});
  } else if (kind == "foreign-shot") {
    ForeignShotInput input;
    input.id = line.Word("the number of a foreign body");
    input.target = line.Word("an agent, or \"\"");
    input.damage = line.Value<float>("a number");
    input.radius_m = line.Value<float>("a number of metres");
    input.from = line.Vector("a coordinate");
    input.to = line.Vector("a coordinate");
    values.push_back(std::move(input));
  } else if (kind == "foreign-message") {
    ForeignMessageInput input;
    input.id = line.Word("the number of a foreign body");
    input.team = line.Word("a team, or \"\"");
    input.about = line.Word("what the message is about");
    input.text = line.Text("names and values");
    values.push_back(std::move(input));
  } else if (line.ok()) {
    line.Fail("'" + kind + "' is not a kind of input", kForms);
  }
  line.End();
  if (!line.ok()) values.clear();
  return values;
}

std::string Quote(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n' || c == '\t' || c == '\r') {
      quoted += c == '\n' ? "\\n" : c == '\t' ? "\\t" : "\\r";
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// The shortest text that is parsed as the same number.
std::string Number(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string Numbers(std::initializer_list<world::Vec3> vectors) {
  std::string text;
  for (const world::Vec3& v : vectors)
    for (const float part : {v.x, v.y, v.z}) text += " " + Number(part);
  return text;
}

struct Writer {
  std::string operator()(const KeyInput& in) const { return "key " + in.key + (in.pressed ? " down" : " up"); }
  std::string operator()(const ButtonInput& in) const {
    return "button " + in.button + (in.pressed ? " down " : " up ") + Number(in.x_px) + " " + Number(in.y_px);
  }
  std::string operator()(const PointerInput& in) const {
    return "pointer " + Number(in.x_px) + " " + Number(in.y_px) + " " + Number(in.dx_px) + " " + Number(in.dy_px);
  }
  std::string operator()(const WheelInput& in) const {
    return "wheel " + Number(in.notches) + " " + Number(in.x_px) + " " + Number(in.y_px);
  }
  std::string operator()(const PanelInput& in) const { return "panel " + Quote(in.button); }
  std::string operator()(const PadInput& in) const {
    const std::string value = IsPadButton(in.part) ? (in.value != 0 ? "down" : "up") : Number(in.value);
    return "pad " + std::to_string(in.pad) + " " + in.part + " " + value;
  }
  std::string operator()(const ScreenInput& in) const {
    return "screen " + std::to_string(in.width_px) + " " + std::to_string(in.height_px);
  }
  std::string operator()(const CameraInput& in) const {
    std::string text = "camera";
    for (const float part : {in.position.x, in.position.y, in.position.z, in.orientation.w, in.orientation.x,
                             in.orientation.y, in.orientation.z})
      text += " " + Number(part);
    return text;
  }
  std::string operator()(const CommandInput& in) const { return "command " + Quote(in.agent) + " " + Quote(in.line); }
  std::string operator()(const ScriptInput& in) const {
    return "script " + (in.agent.empty() ? "sandbox" : Quote(in.agent)) + " " + Quote(in.text);
  }
  std::string operator()(const OrderInput& in) const { return "order " + Quote(in.agent) + " " + Quote(in.order); }
  std::string operator()(const ForeignBodyInput& in) const {
    return "foreign " + Quote(in.id) + " " + Quote(in.name) + " " + Quote(in.team) + " " + Quote(in.body) + " " +
           Number(in.health) + " " + Quote(in.stance) + Numbers({in.position, in.velocity, in.acceleration}) + " " +
           Number(in.heading_deg) + " " + Number(in.turn_dps);
  }
  std::string operator()(const ForeignGoneInput& in) const { return "foreign-gone " + Quote(in.id); }
  std::string operator()(const ForeignShotInput& in) const {
    return "foreign-shot " + Quote(in.id) + " " + Quote(in.target) + " " + Number(in.damage) + " " +
           Number(in.radius_m) + Numbers({in.from, in.to});
  }
  std::string operator()(const ForeignMessageInput& in) const {
    return "foreign-message " + Quote(in.id) + " " + Quote(in.team) + " " + Quote(in.about) + " " + Quote(in.text);
  }
};

}  // namespace

InputText ReadInputs(std::string_view text, const std::string& file) {
  InputText read;
  text = WithoutByteOrderMark(text);
  Place pointer;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    std::string problem, hint;
    LineReader reader(line, problem, hint);
    if (reader.AtEnd()) continue;
    const auto tick = reader.Value<std::uint64_t>("a tick: a whole number from 1");
    if (reader.ok() && tick == 0) reader.Fail("ticks begin at 1");
    const std::vector<InputValue> values = ReadLine(reader, pointer);
    for (const InputValue& value : values) read.inputs.push_back({tick, value, false});
    if (reader.ok()) continue;
    Diagnostic diagnostic;
    diagnostic.file = file;
    diagnostic.line = number;
    diagnostic.column = reader.column();
    diagnostic.message = problem;
    diagnostic.hint = hint;
    diagnostic.excerpt = std::string(line);
    read.problems.push_back(std::move(diagnostic));
  }
  std::stable_sort(read.inputs.begin(), read.inputs.end(),
                   [](const Input& a, const Input& b) { return a.tick < b.tick; });
  return read;
}

std::string WriteInput(const Input& input) {
  return std::to_string(input.tick) + " " + std::visit(Writer{}, input.value);
}

std::string ShownInput(const std::string& line) {
  constexpr std::string_view kOfClient = " command \"\" ";
  const std::size_t number_end = line.find_first_not_of("0123456789");
  if (number_end == std::string::npos || line.compare(number_end, kOfClient.size(), kOfClient) != 0) return line;
  const InputText read = ReadInputs(line, {});
  const auto* const acts = read.inputs.size() == 1 ? std::get_if<CommandInput>(&read.inputs.front().value) : nullptr;
  if (acts == nullptr) return line;
  std::string shown;
  const auto add = [&shown](const std::string& text) { shown += (shown.empty() ? "" : ", ") + text; };
  std::size_t lines = 0, changes = 0, answers = 0;
  for (std::size_t begin = 0, end = 0; (end = acts->line.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string_view act = std::string_view(acts->line).substr(begin, end - begin);
    const std::string_view kind = act.substr(0, act.find('\t'));
    if (kind == "agent" || kind == "attach") add("agent " + std::string(act.substr(kind.size() + 1)));
    if (kind == "gone") add("end of agent " + std::string(act.substr(kind.size() + 1)));
    lines += kind == "line" ? 1 : 0;
    answers += kind == "answer" ? 1 : 0;
    changes += kind == "add" || kind == "set" || kind == "remove" || kind == "drop" || kind == "scene" ? 1 : 0;
  }
  const auto count = [&add](std::size_t number, const char* what) {
    if (number > 0) add(std::to_string(number) + " " + what + (number == 1 ? "" : "s"));
  };
  count(lines, "command line");
  count(answers, "answer");
  if (changes > 0) add(std::to_string(changes) + (changes == 1 ? " change of input" : " changes of input"));
  return line.substr(0, number_end) + " client: " + (shown.empty() ? "runs the agents" : shown);
}

}  // namespace soarbox::sim
