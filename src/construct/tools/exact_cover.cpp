#include "construct/tools/exact_cover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {
constexpr std::uint64_t max_links = std::numeric_limits<std::uint32_t>::max() - std::uint64_t{1};

/// Counts nodes and says when to end.
struct Meter {
  const SearchLimits& limits;
  std::uint64_t nodes = 0;
  SearchOutcome outcome = SearchOutcome::complete;

  /// Before a node: whether it may be entered. If not, the outcome says why.
  [[nodiscard]] bool enter() {
    if (nodes % 256 == 0) {
      stop_if_asked();
    }
    if (limits.nodes && nodes >= *limits.nodes) {
      outcome = SearchOutcome::limit;
    } else if (nodes % 256 == 0 && limits.stop && limits.stop()) {
      outcome = SearchOutcome::stopped;
    } else {
      ++nodes;
    }
    return outcome == SearchOutcome::complete;
  }
};

/// The links that dance. Columns are numbered from 1 here, 0 being the head of the list of primary
/// columns that are still to be covered. The nodes of a row are consecutive, with a spacer after it
/// that leads back to the first one and names the row; the spacer before it leads to the last one.
class Links {
 public:
  /// @param keep which rows to link, by number.
  template <class Keep>
  Links(const ExactCover& cover, Keep keep)
      : columns_(cover.column_count()),
        primary_(cover.primary_count()),
        active_(primary_),
        left_(std::size_t{columns_} + 1),
        right_(left_.size()),
        size_(left_.size()) {
    for (std::uint32_t c = 0; c <= columns_; ++c) {
      nodes_.push_back({c, c, c});
      left_[c] = right_[c] = c;  // secondary columns stay alone
    }
    for (std::uint32_t c = 1; c <= primary_; ++c) {
      left_[c] = c - 1;
      right_[c - 1] = c;
    }
    right_[primary_] = 0;
    left_[0] = primary_;
    nodes_.push_back({0, 0, columns_ + 1});
    for (std::size_t r = 0; r < cover.row_count(); ++r) {
      if (keep(r)) {
        append_row(cover.row(r), static_cast<std::uint32_t>(r));
      }
    }
    for (std::uint32_t c = 1; c <= primary_; ++c) {
      dead_ += size_[c] == 0 ? 1U : 0U;
    }
  }

  /// Primary columns neither covered nor left out, and those of them that no remaining row meets.
  [[nodiscard]] std::uint32_t active() const { return active_; }
  [[nodiscard]] std::uint32_t dead() const { return dead_; }

  /// The first of the active columns with the fewest rows, those without rows aside; 0 if none.
  [[nodiscard]] std::uint32_t smallest_column() const {
    std::uint32_t best = 0;
    std::uint32_t best_size = std::numeric_limits<std::uint32_t>::max();
    for (std::uint32_t c = right_[0]; c != 0; c = right_[c]) {
      if (size_[c] != 0 && size_[c] < best_size) {
        best = c;
        best_size = size_[c];
        if (best_size == 1) {
          break;
        }
      }
    }
    return best;
  }

  [[nodiscard]] std::uint32_t below(std::uint32_t node) const { return nodes_[node].down; }

  /// Takes a column out, and all its rows out of the other columns.
  void cover(std::uint32_t column) {
    if (column <= primary_) {
      --active_;
      dead_ -= size_[column] == 0 ? 1U : 0U;
    }
    right_[left_[column]] = right_[column];
    left_[right_[column]] = left_[column];
    for (std::uint32_t node = nodes_[column].down; node != column; node = nodes_[node].down) {
      hide(node);
    }
  }

  /// Undoes cover(), if it is the last that was not undone.
  void uncover(std::uint32_t column) {
    for (std::uint32_t node = nodes_[column].up; node != column; node = nodes_[node].up) {
      unhide(node);
    }
    right_[left_[column]] = column;
    left_[right_[column]] = column;
    if (column <= primary_) {
      ++active_;
      dead_ += size_[column] == 0 ? 1U : 0U;
    }
  }

  /// Covers the other columns of the node's row. @return the row's number.
  std::size_t cover_others(std::uint32_t node) {
    std::size_t row = 0;
    for (std::uint32_t other = node + 1; other != node;) {
      if (nodes_[other].column > columns_) {
        row = nodes_[other].column - columns_ - 1;
        other = nodes_[other].up;
      } else {
        cover(nodes_[other].column);
        ++other;
      }
    }
    return row;
  }

  /// Undoes cover_others().
  void uncover_others(std::uint32_t node) {
    for (std::uint32_t other = node - 1; other != node;) {
      if (nodes_[other].column > columns_) {
        other = nodes_[other].down;
      } else {
        uncover(nodes_[other].column);
        --other;
      }
    }
  }

 private:
  struct Node {
    std::uint32_t up, down, column;  // column > columns_ marks a spacer
  };

  void append_row(std::span<const std::uint32_t> columns, std::uint32_t number) {
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    for (const std::uint32_t zero_based : columns) {
      const std::uint32_t column = zero_based + 1;
      const auto node = static_cast<std::uint32_t>(nodes_.size());
      const std::uint32_t last = nodes_[column].up;
      nodes_.push_back({last, column, column});
      nodes_[last].down = node;
      nodes_[column].up = node;
      ++size_[column];
    }
    nodes_[first - 1].down = static_cast<std::uint32_t>(nodes_.size()) - 1;
    nodes_.push_back({first, 0, columns_ + 1 + number});
  }

  void hide(std::uint32_t node) {
    for (std::uint32_t other = node + 1; other != node;) {
      const Node& n = nodes_[other];
      if (n.column > columns_) {
        other = n.up;
        continue;
      }
      nodes_[n.up].down = n.down;
      nodes_[n.down].up = n.up;
      if (--size_[n.column] == 0 && n.column <= primary_) {
        ++dead_;
      }
      ++other;
    }
  }

  void unhide(std::uint32_t node) {
    for (std::uint32_t other = node - 1; other != node;) {
      const Node& n = nodes_[other];
      if (n.column > columns_) {
        other = n.down;
        continue;
      }
      nodes_[n.up].down = other;
      nodes_[n.down].up = other;
      if (size_[n.column]++ == 0 && n.column <= primary_) {
        --dead_;
      }
      --other;
    }
  }

  std::uint32_t columns_;
  std::uint32_t primary_;
  std::uint32_t active_;
  std::uint32_t dead_ = 0;
  std::vector<std::uint32_t> left_, right_, size_;
  std::vector<Node> nodes_;
};

constexpr auto all_rows = [](std::size_t) { return true; };

/// The search for exact covers: calls `leaf(rows)` for each, until it returns false.
template <class Leaf>
void search_covers(Links& links, Meter& meter, Leaf leaf) {
  struct Level {
    std::uint32_t column, node;  // node == column: no row of the column has been tried yet
  };
  std::vector<Level> levels;
  std::vector<std::size_t> rows;
  bool descend = true;
  for (;;) {
    if (descend) {
      if (links.active() == 0) {
        if (!leaf(std::span<const std::size_t>(rows))) {
          meter.outcome = SearchOutcome::stopped;
          return;
        }
      } else if (links.dead() == 0) {
        const std::uint32_t column = links.smallest_column();
        links.cover(column);
        levels.push_back({column, column});
      }
      descend = false;
    }
    if (levels.empty()) {
      return;
    }
    // Every level but the last has a row chosen.
    Level& level = levels.back();
    if (rows.size() == levels.size()) {
      links.uncover_others(level.node);
      rows.pop_back();
    }
    level.node = links.below(level.node);
    if (level.node == level.column) {
      links.uncover(level.column);
      levels.pop_back();
      continue;
    }
    if (!meter.enter()) {
      return;
    }
    rows.push_back(links.cover_others(level.node));
    descend = true;
  }
}

/// Branch and bound for a packing that covers the most primary columns.
class PackingSearch {
 public:
  PackingSearch(const ExactCover& cover, const SearchLimits& limits)
      : links_(cover, all_rows), meter_{limits}, primary_(cover.primary_count()) {
    std::uint32_t gcd = 0;
    for (std::size_t r = 0; r < cover.row_count(); ++r) {
      const auto columns = cover.row(r);
      const auto primary = std::ranges::lower_bound(columns, primary_);
      gcd = std::gcd(gcd, static_cast<std::uint32_t>(primary - columns.begin()));
    }
    granule_ = std::max(gcd, std::uint32_t{1});
  }

  LargestPacking run() {
    LargestPacking best;
    best.upper_bound = bound();
    search(best);
    best.nodes = meter_.nodes;
    best.outcome = meter_.outcome;
    if (best.outcome == SearchOutcome::complete) {
      best.upper_bound = best.covered;
    }
    best.optimal = best.covered == best.upper_bound;
    std::ranges::sort(best.rows);
    return best;
  }

 private:
  struct Level {
    std::uint32_t column, node;  // node == column: none of its rows is taken
    bool left_out;               // all were tried, now the column stays uncovered
  };

  [[nodiscard]] std::uint64_t covered() const { return primary_ - links_.active() - left_out_; }

  [[nodiscard]] std::uint64_t bound() const {
    const std::uint64_t count = covered() + links_.active() - links_.dead();
    return count - count % granule_;
  }

  void search(LargestPacking& best) {
    bool descend = true;
    for (;;) {
      if (descend) {
        if (bound() > std::max(best.covered, covered())) {  // so a column can still be covered
          const std::uint32_t column = links_.smallest_column();
          links_.cover(column);
          levels_.push_back({column, column, false});
          ++left_out_;  // until one of its rows is taken
        } else {
          record(best);
        }
      }
      if (levels_.empty() || best.covered == best.upper_bound) {
        return;
      }
      descend = advance();
      if (meter_.outcome != SearchOutcome::complete) {
        record(best);
        return;
      }
    }
  }

  /// Called at leaves and at the end only: a copy at every level would take quadratic time.
  void record(LargestPacking& best) const {
    if (covered() > best.covered) {
      best.covered = covered();
      best.rows = rows_;
    }
  }

  /// Takes the last level's next branch; false, having gone up one level, if there is none.
  bool advance() {
    Level& level = levels_.back();
    if (level.node != level.column) {
      links_.uncover_others(level.node);
      rows_.pop_back();
      ++left_out_;
    }
    if (level.left_out) {
      links_.uncover(level.column);
      --left_out_;
      levels_.pop_back();
      return false;
    }
    level.node = links_.below(level.node);
    level.left_out = level.node == level.column;
    if (!meter_.enter()) {
      return false;
    }
    if (!level.left_out) {
      rows_.push_back(links_.cover_others(level.node));
      --left_out_;
    }
    return true;
  }

  Links links_;
  Meter meter_;
  std::uint32_t primary_;
  std::uint32_t granule_ = 1;
  std::uint64_t left_out_ = 0;
  std::vector<Level> levels_;
  std::vector<std::size_t> rows_;
};

/// Maximal packings are the maximal cliques of the graph of compatible rows.
class MaximalPackingSearch {
 public:
  MaximalPackingSearch(const ExactCover& cover, const SearchLimits& limits)
      : rows_(cover.row_count()),
        words_((rows_ + 63) / 64),
        conflicts_(rows_ * words_),
        meter_{limits} {
    std::vector<std::vector<std::size_t>> meeting(cover.column_count());
    for (std::size_t r = 0; r < rows_; ++r) {
      for (const std::uint32_t column : cover.row(r)) {
        meeting[column].push_back(r);
      }
    }
    for (const auto& rows : meeting) {
      for (const std::size_t r : rows) {
        for (const std::size_t s : rows) {
          conflicts_[r * words_ + s / 64] |= bit(s);  // r = s too: a row is taken only once
        }
      }
    }
  }

  SearchReport run(const ExactCover::Visit& visit) {
    levels_.push_back(Level{Bits(words_), Bits(words_), Bits(words_), 0});
    for (std::size_t r = 0; r < rows_; ++r) {
      levels_[0].open[r / 64] |= bit(r);
    }
    std::uint64_t found = 0;
    std::size_t depth = 1;  // levels in use; the others keep their memory
    bool descend = true;
    while (depth > 0) {
      if (descend) {
        if (!choose_branches(levels_[depth - 1])) {
          ++found;
          if (!visit(chosen_)) {
            meter_.outcome = SearchOutcome::stopped;
            break;
          }
        }
      }
      const std::size_t row = next_branch(levels_[depth - 1]);
      descend = row < rows_;
      if (descend && !meter_.enter()) {
        break;
      }
      depth = descend ? take(row, depth) : depth - 1;
    }
    return {found, meter_.nodes, meter_.outcome};
  }

 private:
  using Bits = std::vector<std::uint64_t>;
  struct Level {
    Bits open;      // rows compatible with those chosen, still to be considered
    Bits closed;    // compatible too, but all packings with them have been listed
    Bits branches;  // the open rows to try here
    std::size_t chosen;
  };

  static std::uint64_t bit(std::size_t r) { return std::uint64_t{1} << (r % 64); }
  /// Any maximal packing holds the pivot or an open row in conflict with it: only these are tried.
  /// The pivot is the first with the fewest. @return whether any row, open or closed, is left.
  bool choose_branches(Level& level) const {
    std::size_t pivot = rows_;
    std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t w = 0; w < words_ && fewest > 1; ++w) {
      for (std::uint64_t rest = level.open[w] | level.closed[w]; rest != 0; rest &= rest - 1) {
        const std::size_t r = w * 64 + static_cast<std::size_t>(std::countr_zero(rest));
        std::uint64_t count = 0;
        for (std::size_t i = 0; i < words_ && count < fewest; ++i) {
          const std::uint64_t common = level.open[i] & conflicts_[r * words_ + i];
          count += static_cast<std::uint64_t>(std::popcount(common));
        }
        if (count < fewest) {
          fewest = count;
          pivot = r;
        }
      }
    }
    for (std::size_t i = 0; i < words_; ++i) {
      level.branches[i] = pivot < rows_ ? level.open[i] & conflicts_[pivot * words_ + i] : 0;
    }
    return pivot < rows_;
  }

  /// The first row of the branches; rows_ if there is none.
  [[nodiscard]] std::size_t next_branch(const Level& level) const {
    for (std::size_t w = 0; w < words_; ++w) {
      if (level.branches[w] != 0) {
        return w * 64 + static_cast<std::size_t>(std::countr_zero(level.branches[w]));
      }
    }
    return rows_;
  }

  /// Chooses a row. The last branch of a level takes the level's place, which keeps the levels few
  /// where choices are forced. @return the number of levels then in use.
  std::size_t take(std::size_t row, std::size_t depth) {
    levels_[depth - 1].branches[row / 64] &= ~bit(row);
    const bool last = next_branch(levels_[depth - 1]) == rows_;
    if (!last && levels_.size() == depth) {
      levels_.push_back(Level{Bits(words_), Bits(words_), Bits(words_), 0});
    }
    Level& from = levels_[depth - 1];
    Level& to = last ? from : levels_[depth];
    chosen_.resize(from.chosen);
    chosen_.push_back(row);
    for (std::size_t i = 0; i < words_; ++i) {
      const std::uint64_t compatible = ~conflicts_[row * words_ + i];
      to.open[i] = from.open[i] & compatible;
      to.closed[i] = from.closed[i] & compatible;
    }
    to.chosen = chosen_.size();
    if (!last) {
      from.open[row / 64] &= ~bit(row);
      from.closed[row / 64] |= bit(row);
    }
    return last ? depth : depth + 1;
  }

  std::size_t rows_;
  std::size_t words_;
  Bits conflicts_;
  Meter meter_;
  std::vector<Level> levels_;
  std::vector<std::size_t> chosen_;
};

}  // namespace

ExactCover::ExactCover(std::uint32_t primary_count, std::uint32_t secondary_count)
    : primary_count_(primary_count), column_count_(primary_count + secondary_count) {
  if (std::uint64_t{primary_count} + secondary_count > max_links - 1) {
    throw ImpossibleParameters(fmt::format("{} primary and {} secondary columns are too many",
                                           primary_count, secondary_count));
  }
}

std::size_t ExactCover::add_row(std::span<const std::uint32_t> columns) {
  const std::size_t number = row_count();
  std::vector<std::uint32_t> sorted(columns.begin(), columns.end());
  std::ranges::sort(sorted);
  if (sorted.empty() || sorted.front() >= primary_count_) {
    throw BadInput(fmt::format("row {} has no primary column (they are numbered below {})", number,
                               primary_count_));
  }
  if (sorted.back() >= column_count_) {
    throw BadInput(fmt::format("row {} has column {}, but there are only {}", number, sorted.back(),
                               column_count_));
  }
  const auto repeated = std::ranges::adjacent_find(sorted);
  if (repeated != sorted.end()) {
    throw BadInput(fmt::format("row {} has column {} twice", number, *repeated));
  }
  // One node per entry, one spacer per row and one more, one head per column and one more.
  const std::uint64_t links = entries_.size() + sorted.size() + number + column_count_ + 3;
  if (links > max_links) {
    throw ImpossibleParameters(fmt::format("row {} is too much: {} links in all", number, links));
  }
  entries_.insert(entries_.end(), sorted.begin(), sorted.end());
  row_begin_.push_back(entries_.size());
  return number;
}

std::span<const std::uint32_t> ExactCover::row(std::size_t index) const {
  const std::size_t begin = row_begin_.at(index);
  return std::span<const std::uint32_t>(entries_).subspan(begin, row_begin_.at(index + 1) - begin);
}

SearchReport ExactCover::for_each_solution(const Visit& visit, const SearchLimits& limits) const {
  Links links(*this, all_rows);
  Meter meter{limits};
  std::uint64_t found = 0;
  search_covers(links, meter, [&](std::span<const std::size_t> rows) {
    ++found;
    return visit(rows);
  });
  return {found, meter.nodes, meter.outcome};
}

FirstSolution ExactCover::first_solution(const SearchLimits& limits) const {
  FirstSolution first;
  const SearchReport report = for_each_solution(
      [&first](std::span<const std::size_t> rows) {
        first.rows.emplace(rows.begin(), rows.end());
        std::ranges::sort(*first.rows);
        return false;
      },
      limits);
  first.nodes = report.nodes;
  first.outcome = first.rows ? SearchOutcome::complete : report.outcome;
  return first;
}

SolutionCount ExactCover::count_solutions(std::span<const std::uint64_t> multiplicities,
                                          const SearchLimits& limits) const {
  if (!multiplicities.empty() && multiplicities.size() != row_count()) {
    throw BadInput(fmt::format("{} for {}",
                               count_of(multiplicities.size(), "multiplicity", "multiplicities"),
                               count_of(row_count(), "row")));
  }
  const auto keep = [=](std::size_t r) { return multiplicities.empty() || multiplicities[r] > 0; };
  Links links(*this, keep);
  Meter meter{limits};
  SolutionCount count;
  search_covers(links, meter, [&](std::span<const std::size_t> rows) {
    std::uint64_t product = 1;
    if (!multiplicities.empty()) {
      for (const std::size_t r : rows) {
        // All factors are positive: once a product is too large, so is the sum.
        count.saturated |= __builtin_mul_overflow(product, multiplicities[r], &product);
      }
    }
    count.saturated |= __builtin_add_overflow(count.value, product, &count.value);
    return !count.saturated;
  });
  count.nodes = meter.nodes;
  count.outcome = count.saturated ? SearchOutcome::limit : meter.outcome;
  if (count.saturated) {
    count.value = std::numeric_limits<std::uint64_t>::max();
  }
  return count;
}

LargestPacking ExactCover::largest_packing(const SearchLimits& limits) const {
  return PackingSearch(*this, limits).run();
}

SearchReport ExactCover::for_each_maximal_packing(const Visit& visit,
                                                  const SearchLimits& limits) const {
  return MaximalPackingSearch(*this, limits).run(visit);
}

}  // namespace changeover
