// A parts list without the parts that broke. Lists may be older, so they are read with all names
// and then reduced to the remaining parts.
//
//     const PartsLeft left(4, {1});         // of parts 0 to 3 without part 1
//     left(Block{0, 1, 3});                 // 0 and 2, the current numbers of 0 and 3
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

class PartsLeft {
 public:
  PartsLeft() = default;
  PartsLeft(std::size_t parts, const Block& without);

  /// Adds `more` parts at the end of the list; none of them broke.
  void add(std::uint64_t more);

  /// The number of remaining parts.
  [[nodiscard]] std::size_t size() const { return left_; }
  [[nodiscard]] bool all() const { return left_ == number_.size(); }

  [[nodiscard]] Block operator()(const Block& parts) const;
  [[nodiscard]] PairSet operator()(const PairSet& pairs) const;
  [[nodiscard]] PairWeights operator()(const PairWeights& weights) const;
  [[nodiscard]] PairReasons operator()(const PairReasons& reasons) const;
  /// Reduces a list with one entry per part, or an empty one.
  template <typename T>
  [[nodiscard]] std::vector<T> operator()(std::vector<T> by_part) const {
    std::size_t next = 0;
    std::erase_if(by_part, [&](const T&) { return !number_[next++]; });
    return by_part;
  }
  /// Reduces a square table, row by row.
  template <typename T>
  [[nodiscard]] std::vector<T> square(std::vector<T> by_pair) const {
    std::size_t next = 0;
    std::erase_if(by_pair, [&](const T&) {
      const std::size_t at = next++;
      return !number_[at / number_.size()] || !number_[at % number_.size()];
    });
    return by_pair;
  }

  /// By part of the list, the slot in the job of those that are left; each other one has a
  /// separate number. Empty if the job has no slots.
  [[nodiscard]] std::vector<std::uint32_t> slots(const Job& job) const;

 private:
  std::vector<std::optional<Element>> number_;  // by part of the list: its current number
  std::size_t left_ = 0;
};

/// What is wrong with a name that was taken for that of a removed part, if none can be: "never.csv:
/// 2:3: there is no part 'X71'; did you mean 'X710'?". It may have its place in brackets behind it.
[[nodiscard]] std::string unknown_part_defect(const std::string& list, const std::string& gone,
                                              const std::vector<std::string>& names);

enum class GoneFrom { parts_list, model };

/// A note on removed parts (at least one): "sheet.csv: no longer in the parts list, and left out:
/// A, B".
[[nodiscard]] std::string gone_note(const std::string& name, const std::vector<std::string>& gone,
                                    GoneFrom from = GoneFrom::parts_list);

}  // namespace changeover
