// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::cli {

/// One word of a command without its quotes or braces, and its position in the text.
struct Word {
  std::string text;
  int line = 1;    ///< From 1, of the first character of `text` (after an opening quote or brace).
  int column = 1;  ///< From 1.
};

/// Splits text into commands that consist of Tcl-like words, without any substitution.
///
/// A command ends at a newline or a semicolon. A word is bare, "quoted" or {braced}. A bare word that begins with a bar
/// ends at the next bar; only backslashes are special between them. A quoted word can span lines. Braces can be nested;
/// text between |bars| in them is literal. The content of braces is kept as written, without comments, and with joined
/// lines. A `#` begins a comment to the end of the line, except in quoted words and between bars. Outside braces, a
/// backslash escapes the next character; before a newline it joins two lines.
///
/// Accepts any text: the result is words, the end, or an error with its position. After an error, Recover() skips to
/// the next line that begins a command, so that the rest of a file can be read.
class CommandReader {
 public:
  enum class Status { kCommand, kEnd, kError };

  explicit CommandReader(std::string_view text, int first_line = 1) : text_(text), line_(first_line) {}

  /// Reads the next command that has words. Replaces the contents of `words` and reuses their memory.
  Status Next(std::vector<Word>& words);

  /// After kError: the message, and the line and column of the quote, brace or word without an end.
  const std::string& error() const { return error_; }
  int error_line() const { return error_line_; }
  int error_column() const { return error_column_; }

  /// After kError: continues at the first line that begins with a letter, after the line in which the unfinished word
  /// begins.
  void Recover();

  /// Offset of the first character that was not read.
  std::size_t offset() const { return position_; }

 private:
  bool AtEnd() const { return position_ >= text_.size(); }
  char Peek() const { return text_[position_]; }
  void Advance();
  void SkipBlanksAndComments();
  void SkipComment();
  void AppendEscape(std::string& out);
  bool ReadBare(Word& word);
  bool ReadQuoted(Word& word);
  bool ReadBraced(Word& word);
  bool Fail(std::string message, const Word& word, std::size_t start);

  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 1;
  int column_ = 1;
  std::string error_;
  int error_line_ = 0;
  int error_column_ = 0;
  std::size_t error_start_ = 0;
};

/// Quotes a word so that CommandReader reads it back as one word.
std::string QuoteWord(std::string_view word);

}  // namespace soarbox::cli
