// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>
#include <vector>

namespace soarbox::cli {

namespace detail {

/// A quicksort with the median of three elements as pivot stops at ranges of up to 16 elements. A range that it has
/// partitioned too often is sorted by a heap sort instead. Finally, a stable sort sorts all elements.
template <typename T, typename Less>
class SoarSort {
 public:
  SoarSort(std::vector<T>& all, Less less) : all_(all), less_(less) {
    if (all.empty()) return;
    Split(0, all.size(), 2 * (std::bit_width(all.size()) - 1));
    std::stable_sort(all.begin(), all.end(), less_);
  }

 private:
  static constexpr std::size_t kShort = 16;

  bool IsLess(std::size_t a, std::size_t b) const { return less_(all_[a], all_[b]); }
  void Swap(std::size_t a, std::size_t b) { std::swap(all_[a], all_[b]); }

  void Split(std::size_t first, std::size_t last, int partitions) {
    while (last - first > kShort) {
      if (partitions-- == 0) return SortHeap(first, last - first);
      MedianToFirst(first, first + 1, first + (last - first) / 2, last - 1);
      const std::size_t middle = Partition(first, last);
      Split(middle, last, partitions);
      last = middle;
    }
  }

  void MedianToFirst(std::size_t first, std::size_t a, std::size_t b, std::size_t c) {
    if (IsLess(a, b))
      Swap(first, IsLess(b, c) ? b : IsLess(a, c) ? c : a);
    else
      Swap(first, IsLess(a, c) ? a : IsLess(b, c) ? c : b);
  }

  /// The pivot is the first element; returns where the second part begins.
  std::size_t Partition(std::size_t pivot, std::size_t right) {
    std::size_t left = pivot + 1;
    for (;;) {
      while (IsLess(left, pivot)) ++left;
      --right;
      while (IsLess(pivot, right)) --right;
      if (left >= right) return left;
      Swap(left, right);
      ++left;
    }
  }

  void SortHeap(std::size_t first, std::size_t count) {
    for (std::size_t parent = (count - 2) / 2 + 1; parent-- > 0;)
      Sift(first, parent, count, std::move(all_[first + parent]));
    while (count-- > 1) {
      T value = std::move(all_[first + count]);
      all_[first + count] = std::move(all_[first]);
      Sift(first, 0, count, std::move(value));
    }
  }

  /// Moves the hole of a heap down to a leaf, always towards the larger child, and the value up from there.
  void Sift(std::size_t first, std::size_t hole, std::size_t count, T value) {
    const std::size_t top = hole;
    while (2 * hole + 2 < count) {
      std::size_t child = 2 * hole + 2;
      if (IsLess(first + child, first + child - 1)) --child;
      all_[first + hole] = std::move(all_[first + child]);
      hole = child;
    }
    if (2 * hole + 2 == count) {
      all_[first + hole] = std::move(all_[first + count - 1]);
      hole = count - 1;
    }
    for (; hole > top && less_(all_[first + (hole - 1) / 2], value); hole = (hole - 1) / 2)
      all_[first + hole] = std::move(all_[first + (hole - 1) / 2]);
    all_[first + hole] = std::move(value);
  }

  std::vector<T>& all_;
  Less less_;
};

}  // namespace detail

/// Sorts like std::sort of the C++ library that Soar is built with (GCC's), also in the order of equal elements, which
/// Soar's output shows. Other C++ libraries put them into another order.
template <typename T, typename Less>
void SortLikeSoar(std::vector<T>& all, Less less) {
  detail::SoarSort<T, Less>(all, less);
}

}  // namespace soarbox::cli
