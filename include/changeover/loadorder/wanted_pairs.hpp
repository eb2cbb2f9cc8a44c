// Which pairs must be in memory together: all, or only some.
//
//     WantedPairs edges = WantedPairs::listed(read_pairs("edges.txt"));  // pairs that a file lists
//     WantedPairs matching = WantedPairs::between(12, 20);  // items 0, …, 11 with items 12, …, 31
//     WantedPairs grown = WantedPairs::beyond(1000, 1024);  // pairs of the last 24 with all others
//
//     matching.contains(3, 12)                 // true
//     matching.count()                         // 240
//
// A file of pairs has two items per line, separated by a comma, a semicolon, a tab or blanks. An
// item in double quotes may contain any of these, with quotes doubled ("cam 0/x.JPG","b"); without
// quotes, an item between commas, semicolons or tabs may contain blanks. Empty lines and lines that
// begin with # or % are skipped, and so is a first line of two words above lines of numbers, which
// are then names of columns. A workbook (.xlsx) is read, too: its first sheet, or the one that
// open_list() (io/input.hpp) names.
//
// A file of groups has the items of a group in each line, any number of them, written in the same
// way, and wants all pairs within each group. A group of one item wants none: it is not loaded for
// it. At most 2³⁰ pairs.
//
// Memory: 8 bytes a pair and 8 an item, and 16 a pair while a file of pairs is read.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/io/input.hpp"

namespace changeover {

using ItemPair = std::pair<Element, Element>;  ///< smaller first

/// The limit for the number of items.
inline constexpr std::uint64_t most_items = 10'000'000;

/// Items and pairs of them.
class PairGraph {
 public:
  /// A pair may occur twice and in either direction; an item paired with itself is only marked as
  /// needed. `names` is empty or has a name for each item. @throws BadInput if a pair has an item ≥
  /// `items`, or the number of names is not `items`; ImpossibleParameters above most_items.
  PairGraph(std::uint64_t items, std::span<const ItemPair> pairs,
            std::vector<std::string> names = {});

  /// A graph of the pairs that `each` passes to its argument; each call must pass the same pairs.
  using Visit = std::function<void(Element, Element)>;
  PairGraph(std::uint64_t items, const std::function<void(const Visit&)>& each,
            std::vector<std::string> names);

  [[nodiscard]] std::uint64_t items() const { return begin_.size() - 1; }
  [[nodiscard]] std::uint64_t pairs() const { return partners_.size() / 2; }

  /// The items that x must meet, in increasing order.
  [[nodiscard]] std::span<const Element> partners(Element x) const {
    return std::span(partners_).subspan(begin_[x], begin_[x + 1] - begin_[x]);
  }

  /// Whether the item occurs.
  [[nodiscard]] bool is_needed(Element x) const { return needed_[x]; }

  /// A number below 2·pairs() for each pair, different for each; nullopt for two items that are no
  /// pair. O(log of the number of partners)
  [[nodiscard]] std::optional<std::uint64_t> place(Element x, Element y) const;

  /// The names of the items; empty if they have only numbers.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::uint64_t> begin_;  // first partner of each item
  std::vector<Element> partners_;
  std::vector<bool> needed_;
  std::vector<std::string> names_;
};

struct PairFileOptions {
  std::optional<std::uint64_t> items = {};  ///< their number; they are numbered from 0 or named
  bool groups = false;  ///< a line is a group of items, of which all pairs are wanted
  /// Receives the costs in the third column of a list of pairs; unchanged if there is no such
  /// column. If null, a third column is refused with a message that ends in `no_costs`.
  std::function<double(Element, Element)>* costs = nullptr;
  std::string no_costs = {};
  std::vector<std::string>* notes = nullptr;  ///< receives what the reader took the first row for
};

/// Reads a file as described above, or standard input for "-". @throws BadInput with line and
/// column, what is wrong and how to mend it; MissingResource if it cannot be read.
[[nodiscard]] std::shared_ptr<const PairGraph> read_pairs(const std::string& path,
                                                          const PairFileOptions& options = {});
[[nodiscard]] std::shared_ptr<const PairGraph> read_pairs(Input& input,
                                                          const PairFileOptions& options = {});

/// The pairs that a load order must bring together.
class WantedPairs {
 public:
  /// All pairs; the number of items is given elsewhere.
  WantedPairs() = default;

  /// All pairs of `items` items: where pairs are asked for a number of items will do.
  WantedPairs(std::uint64_t items) : items_(items) {}  // NOLINT(google-explicit-constructor)

  /// Items 0, …, a−1 with items a, …, a+b−1. @throws BadInput if one of them is 0.
  [[nodiscard]] static WantedPairs between(std::uint64_t a, std::uint64_t b);

  /// All pairs of `items` items except those within the first `done`. @throws BadInput if done ≥
  /// items.
  [[nodiscard]] static WantedPairs beyond(std::uint64_t done, std::uint64_t items);

  /// The pairs of a graph. @throws BadInput if no item occurs.
  [[nodiscard]] static WantedPairs listed(std::shared_ptr<const PairGraph> graph);

  /// All pairs of named items: of a graph that has them all, although they were not listed.
  [[nodiscard]] static WantedPairs whole(std::shared_ptr<const PairGraph> graph);

  [[nodiscard]] bool are_all() const { return kind_ == Kind::all; }

  /// 0 if it is not said of how many items all pairs are.
  [[nodiscard]] std::uint64_t items() const { return items_; }

  /// These pairs if they are listed; if they are all pairs, all pairs of `items` items.
  [[nodiscard]] WantedPairs among(std::uint64_t items) const {
    return are_all() ? WantedPairs(items) : *this;
  }

  /// How many are wanted.
  [[nodiscard]] std::uint64_t count() const;

  /// Whether the pair is wanted, for x ≠ y, both below items().
  [[nodiscard]] bool contains(Element x, Element y) const {
    switch (kind_) {
      case Kind::all:
        return true;
      case Kind::between:
        return (x < first_) != (y < first_);
      case Kind::beyond:
        return x >= first_ || y >= first_;
      default:
        return graph_->place(x, y).has_value();
    }
  }

  /// Whether the item must be loaded.
  [[nodiscard]] bool needs(Element x) const { return !graph_ || graph_->is_needed(x); }

  /// The graph of listed pairs; otherwise nullptr.
  [[nodiscard]] const PairGraph* graph() const { return graph_.get(); }

  /// A description: "all pairs", "12 items with 20 others", …
  [[nodiscard]] std::string describe() const;

  /// A hash of the wanted pairs.
  [[nodiscard]] std::uint64_t hash() const;

  /// The size of the first set of between(), or `done` of beyond().
  [[nodiscard]] std::uint64_t first() const { return first_; }

  enum class Kind : std::uint8_t { all, between, beyond, listed };
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Kind kind_ = Kind::all;
  std::uint64_t items_ = 0;
  std::uint64_t first_ = 0;
  bool whole_ = false;
  std::shared_ptr<const PairGraph> graph_;
};

}  // namespace changeover
