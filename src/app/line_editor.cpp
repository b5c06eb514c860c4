// SPDX-License-Identifier: BSD-2-Clause
#include "app/line_editor.h"

#include <histedit.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace soarbox::app {
namespace {

constexpr int kHistoryLength = 2000;
/// Marks escape sequences in a prompt for the library.
constexpr char kPromptEscape = '\1';

std::filesystem::path HistoryFile() {
  std::filesystem::path folder;
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0') {
    folder = state;
  } else if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    folder = std::filesystem::path(home) / ".local" / "state";
  } else {
    return {};
  }
  folder /= "soarbox";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? std::filesystem::path{} : folder / "history";
}

std::string CommonStart(const std::vector<std::string>& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto [end, ignored] = std::mismatch(common.begin(), common.end(), word.begin(), word.end());
    common.erase(end, common.end());
  }
  return common;
}

}  // namespace

struct LineEditor::Impl {
  Completer completer;
  std::string prompt;
  EditLine* editor = nullptr;
  History* history = nullptr;
  std::filesystem::path history_file = HistoryFile();

  static Impl& Of(EditLine* editor) {
    void* self = nullptr;
    el_get(editor, EL_CLIENTDATA, &self);
    return *static_cast<Impl*>(self);
  }

  static char* Prompt(EditLine* editor) { return Of(editor).prompt.data(); }

  static unsigned char Complete(EditLine* editor, int) {
    const LineInfo* info = el_line(editor);
    const std::string_view line(info->buffer, static_cast<std::size_t>(info->cursor - info->buffer));
    const std::vector<std::string> words = Of(editor).completer(line);
    if (words.empty()) return CC_ERROR;
    const std::size_t start = line.find_last_of(" \t{[\"") + 1;  // npos + 1 is 0.
    const std::string_view typed = line.substr(start);
    std::string more = CommonStart(words);
    more = more.size() > typed.size() ? more.substr(typed.size()) : std::string{};
    if (words.size() == 1) more += ' ';
    if (!more.empty()) {
      return el_insertstr(editor, more.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    }
    std::fputc('\n', stdout);
    for (const std::string& word : words) std::printf("%s  ", word.c_str());
    std::fputc('\n', stdout);
    return CC_REDISPLAY;
  }
};

LineEditor::LineEditor(Completer completer) : impl_(std::make_unique<Impl>()) {
  impl_->completer = std::move(completer);
  impl_->history = history_init();
  impl_->editor = el_init("soarbox", stdin, stdout, stderr);
  HistEvent event;
  history(impl_->history, &event, H_SETSIZE, kHistoryLength);
  history(impl_->history, &event, H_SETUNIQUE, 1);
  if (!impl_->history_file.empty()) history(impl_->history, &event, H_LOAD, impl_->history_file.c_str());
  el_set(impl_->editor, EL_CLIENTDATA, impl_.get());
  el_set(impl_->editor, EL_PROMPT_ESC, &Impl::Prompt, kPromptEscape);
  el_set(impl_->editor, EL_EDITOR, "emacs");
  el_set(impl_->editor, EL_HIST, ::history, impl_->history);
  el_set(impl_->editor, EL_ADDFN, "soarbox-complete", "Complete the word", &Impl::Complete);
  el_set(impl_->editor, EL_BIND, "^I", "soarbox-complete", nullptr);
  el_set(impl_->editor, EL_BIND, "^R", "em-inc-search-prev", nullptr);
  el_source(impl_->editor, nullptr);
}

LineEditor::~LineEditor() {
  HistEvent event;
  if (!impl_->history_file.empty()) history(impl_->history, &event, H_SAVE, impl_->history_file.c_str());
  el_end(impl_->editor);
  history_end(impl_->history);
}

std::optional<std::string> LineEditor::Read(std::string_view prompt) {
  impl_->prompt = prompt;
  int length = 0;
  const char* line = el_gets(impl_->editor, &length);
  if (line == nullptr || length <= 0) return std::nullopt;
  std::string text(line, static_cast<std::size_t>(length));
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void LineEditor::Remember(const std::string& line) {
  HistEvent event;
  history(impl_->history, &event, H_ENTER, line.c_str());
}

}  // namespace soarbox::app
