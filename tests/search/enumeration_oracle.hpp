// Every list of blocks with the change property, one after another, and what is left of them up to
// names: easy to check and very slow. Shares nothing with the search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "naive_verdict.hpp"

namespace changeover::test {

/// What a list is up to names: for each element the blocks that hold it, as a word of 0 and 1;
/// sorted.
using Columns = std::vector<std::string>;

inline Columns columns_of(const std::vector<Subset>& blocks, std::uint64_t v) {
  Columns columns(v);
  for (const Subset& block : blocks) {
    for (Element x = 0; x < v; ++x) {
      columns[x] += block.count(x) != 0 ? '1' : '0';
    }
  }
  std::sort(columns.begin(), columns.end());
  return columns;
}

inline Columns columns_of(const Design& design) {
  std::vector<Subset> blocks;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    const auto block = design.block(i);
    blocks.emplace_back(block.begin(), block.end());
  }
  return columns_of(blocks, design.v());
}

/// The least columns over all rotations, if circular, and reversals, if asked for.
inline Columns class_of(const Columns& columns, bool circular, bool reversal) {
  Columns least = columns;
  const std::size_t b = columns.front().size();
  for (std::size_t shift = 0; shift < (circular ? b : 1); ++shift) {
    Columns turned = columns;
    for (std::string& column : turned) {
      std::rotate(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(shift),
                  column.end());
    }
    for (int direction = 0; direction < (reversal ? 2 : 1); ++direction) {
      std::sort(turned.begin(), turned.end());
      least = std::min(least, turned);
      for (std::string& column : turned) {
        std::reverse(column.begin(), column.end());
      }
    }
  }
  return least;
}

class EnumerationOracle {
 public:
  EnumerationOracle(const Parameters& p, std::size_t b) : p_(p), b_(b) {
    Subset all;
    for (Element x = 0; x < p.v; ++x) {
      all.insert(x);
    }
    blocks_ = subsets_of(all, p.k);
    pairs_ = subsets_of(all, 2);
    list_.push_back(*blocks_.begin());  // {0, …, k−1}: no loss up to names
    extend();
  }

  [[nodiscard]] const std::set<Columns>& forms() const { return forms_; }

  [[nodiscard]] std::set<Columns> classes(bool reversal) const {
    std::set<Columns> classes;
    for (const Columns& form : forms_) {
      classes.insert(class_of(form, p_.kind == Kind::circular, reversal));
    }
    return classes;
  }

 private:
  void extend() {
    if (list_.size() == b_) {
      const bool closes =
          p_.kind == Kind::linear || b_ == 1 || consecutive(list_.back(), list_.front());
      if (closes && covers()) {
        forms_.insert(columns_of(list_, p_.v));
      }
      return;
    }
    for (const Subset& block : blocks_) {
      if (consecutive(list_.back(), block)) {
        list_.push_back(block);
        extend();
        list_.pop_back();
      }
    }
  }

  [[nodiscard]] bool consecutive(const Subset& one, const Subset& other) const {
    std::uint64_t kept = 0;
    for (const Element x : one) {
      kept += other.count(x);
    }
    return kept + p_.change == p_.k;
  }

  [[nodiscard]] bool covers() const {
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const Subset& pair) {
      return std::any_of(list_.begin(), list_.end(),
                         [&](const Subset& block) { return contains(block, pair); });
    });
  }

  Parameters p_;
  std::size_t b_;
  std::set<Subset> blocks_, pairs_;
  std::vector<Subset> list_;
  std::set<Columns> forms_;
};

}  // namespace changeover::test
