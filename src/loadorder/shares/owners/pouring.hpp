// Internal: amounts that several workers may share, poured so that the fullest worker has as little
// as can be.
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
  std::vector<std::uint64_t> begin;   ///< of the portions of an amount, and the end of the last
  std::vector<std::uint32_t> worker;  ///< of each portion
  std::vector<double> amount;

  std::vector<double> portion = {};
  std::vector<double> load = {};  ///< by worker

  /// Until a round moves less than this part of a worker's mean, or as far as 3 · 10⁷ changes of a
  /// portion lead.
  void pour(std::uint64_t workers, double part = 1e-5);
};

}  // namespace changeover
