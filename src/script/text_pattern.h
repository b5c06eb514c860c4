// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace soarbox::script {

/// A matcher for Lua 5.1's patterns (reference manual, 5.4.1) that can be stopped. Some patterns take exponential time,
/// and the library's own matcher cannot be interrupted.
///
/// Characters are classified as ASCII, independent of the locale. A matcher is for one subject and one pattern.
class TextPattern {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr int kMaxCaptures = 32;

  struct Capture {
    std::size_t start = 0;
    std::size_t length = 0;
    bool is_position = false;  ///< "()": start counts from 0.
    bool open = false;
  };

  /// `max_steps` limits the work of all matches together.
  TextPattern(std::string_view subject, std::string_view pattern, std::uint64_t max_steps)
      : subject_(subject), pattern_(pattern), max_steps_(max_steps) {}

  /// Matches the entire pattern exactly at `start`. Returns the end of the match, or kNone; then see error().
  std::size_t MatchAt(std::size_t start);

  int capture_count() const { return count_; }
  const Capture& capture(int index) const { return captures_[static_cast<std::size_t>(index)]; }
  /// The error in the pattern; null if there is none.
  const char* error() const { return error_; }
  bool out_of_steps() const { return steps_ > max_steps_; }
  std::uint64_t steps() const { return steps_; }

 private:
  std::size_t Match(std::size_t at, std::size_t item);
  std::size_t MatchItems(std::size_t at, std::size_t item);
  std::size_t MatchLongest(std::size_t at, std::size_t item, std::size_t item_end);
  std::size_t MatchShortest(std::size_t at, std::size_t item, std::size_t item_end);
  std::size_t OpenCapture(std::size_t at, std::size_t item);
  std::size_t CloseCapture(std::size_t at, std::size_t item);
  std::size_t MatchBalanced(std::size_t at, std::size_t item);
  std::size_t MatchAgain(std::size_t at, char digit);
  bool IsFrontier(std::size_t at, std::size_t set);
  bool MatchesSingle(std::size_t at, std::size_t item, std::size_t item_end) const;
  bool IsInSet(unsigned char c, std::size_t set, std::size_t set_end) const;
  std::size_t EndOfItem(std::size_t item);
  std::size_t Fail(const char* error);

  std::string_view subject_, pattern_;
  std::uint64_t max_steps_;
  std::uint64_t steps_ = 0;
  int depth_ = 0;
  const char* error_ = nullptr;
  int count_ = 0;
  std::array<Capture, kMaxCaptures> captures_{};
};

}  // namespace soarbox::script
