// Internal: distributes amounts that several workers can share so that the fullest worker has as
// little as possible.
//
//     Pouring pouring;
//     pouring.begin = {0, 2, 3};   // two workers share the first amount, one has the second
//     pouring.worker = {0, 1, 0};
//     pouring.amount = {6, 2};
//     pouring.pour(2);                       // portions 2, 4 and 2: four for each of two workers
#pragma once

#include <cstdint>
#include <vector>

namespace changeover {

struct Pouring {
  std::vector<std::uint64_t> begin;   ///< first portion of each amount, and the end of the last
  std::vector<std::uint32_t> worker;  ///< of each portion
  std::vector<double> amount;

  std::vector<double> portion = {};
  std::vector<double> load = {};  ///< by worker

  /// Repeats until a round moves less than this part of a worker's mean, or after 3 · 10⁷ changes
  /// of a portion.
  void pour(std::uint64_t workers, double part = 1e-5);
};

}  // namespace changeover
