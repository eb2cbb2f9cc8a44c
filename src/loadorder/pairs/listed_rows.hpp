// Internal: what the lines of a list say, pairs or groups of items, while it is read.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// The most pairs in all groups of a list together.
inline constexpr std::uint64_t most_pairs_in_groups = std::uint64_t{1} << 30;

/// Pairs in pieces, so that more of them move none. A piece is so large that the system has it back
/// at once; what is not used of it takes no memory. Groups are as long as a file has items.
class ListedRows {
 public:
  explicit ListedRows(bool groups) : groups_(groups) {}

  /// A row of two items, of a list of pairs.
  void add(Element x, Element y) {
    if (pieces_.empty() || pieces_.back().size() == piece) {
      pieces_.emplace_back().reserve(piece);
    }
    pieces_.back().emplace_back(x, y);
    ++pairs_;
  }

  /// A row of two items, or of a group; false if there are too many pairs in groups.
  bool add(std::span<const Element> row) {
    if (!groups_) {
      add(row[0], row[1]);
      return true;
    }
    members_.insert(members_.end(), row.begin(), row.end());
    ends_.push_back(members_.size());
    pairs_ += row.size() * (row.size() - 1) / 2;
    return pairs_ <= most_pairs_in_groups;
  }

  template <typename Visit>
  void each_item(Visit&& visit) {
    for (auto& of_piece : pieces_) {
      for (auto& [x, y] : of_piece) {
        visit(x);
        visit(y);
      }
    }
    for (Element& item : members_) {
      visit(item);
    }
  }

  /// In the sequence of the rows; of groups all pairs within each.
  template <typename Visit>
  void each_pair(Visit&& visit) const {
    for (const auto& of_piece : pieces_) {
      for (const auto& [x, y] : of_piece) {
        visit(x, y);
      }
    }
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = begin; j < i; ++j) {
          visit(members_[j], members_[i]);
        }
      }
      begin = end;
    }
  }

  /// How often each_pair() visits.
  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }
  [[nodiscard]] bool empty() const { return pieces_.empty() && ends_.empty(); }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 22;
  bool groups_;
  std::uint64_t pairs_ = 0;
  std::vector<std::vector<ItemPair>> pieces_;
  std::vector<Element> members_;  // of groups, one after the other
  std::vector<std::size_t> ends_;
};

}  // namespace changeover
