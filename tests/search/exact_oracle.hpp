// Whether a change covering design exists, by plain depth-first search over lists of blocks. Shares
// nothing with the library but the parameters.
#pragma once

#include <bit>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover::test {

class ExistenceOracle {
 public:
  explicit ExistenceOracle(const Parameters& p) : p_(p) {
    for (unsigned set = 0; set < (1U << p.v); ++set) {
      const auto size = static_cast<std::uint64_t>(std::popcount(set));
      if (size == p.k) {
        blocks_.push_back(set);
      } else if (size == p.strength) {
        subsets_.push_back(set);
      }
    }
    if (p.k == p.strength) {
      subsets_ = blocks_;
    }
  }

  /// Nothing if the search takes more than `nodes` steps.
  std::optional<bool> exists(std::uint64_t b, std::uint64_t nodes) {
    b_ = b;
    left_ = nodes;
    list_.clear();
    // Elements can be renamed so that this is the first block.
    const bool found = extend((1U << p_.k) - 1, {});
    return left_ == 0 ? std::nullopt : std::optional(found);
  }

 private:
  using Covered = std::bitset<128>;

  bool extend(unsigned block, Covered covered) {
    if (left_ == 0 || --left_ == 0) {
      return false;
    }
    list_.push_back(block);
    std::size_t newly = 0;
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if ((subsets_[i] & ~block) == 0) {
        covered.set(i);
      }
      newly += (subsets_[i] & ~block) == 0 ? 1U : 0U;
    }
    bool found = false;
    if (list_.size() == b_) {
      found = covered.count() == subsets_.size() &&
              (p_.kind == Kind::linear || b_ == 1 || step(block, list_.front()));
    } else if (subsets_.size() - covered.count() <= newly * (b_ - list_.size())) {
      for (const unsigned next : blocks_) {
        if (step(block, next) && extend(next, covered)) {
          found = true;
          break;
        }
      }
    }
    list_.pop_back();
    return found;
  }

  [[nodiscard]] bool step(unsigned from, unsigned to) const {
    return static_cast<std::uint64_t>(std::popcount(to & ~from)) == p_.change;
  }

  Parameters p_;
  std::vector<unsigned> blocks_;
  std::vector<unsigned> subsets_;
  std::uint64_t b_ = 0;
  std::uint64_t left_ = 0;
  std::vector<unsigned> list_;
};

}  // namespace changeover::test
