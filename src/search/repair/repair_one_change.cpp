#include "search/repair/repair_one_change.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "search/repair/repair_cover.hpp"
#include "search/repair/repair_other_block.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_blocks = 2000;

class OneChange {
 public:
  OneChange(const Design& list, const Verdict& verdict)
      : list_(list),
        p_(list.parameters()),
        covers_(verdict.uncovered == 0),
        wrong_(verdict.bad_steps) {
    for (std::size_t i = 0; i < list.block_count(); ++i) {
      blocks_.push_back(block_of(list, i));
    }
    for (std::size_t i = 0; i < steps() && wrong_ > 0; ++i) {
      if (!fit(blocks_[i], blocks_[next(i)])) {
        first_ = i;
        break;
      }
    }
  }

  std::optional<Design> found() {
    if (auto order = another_order()) {
      return order;
    }
    if (auto block = with_another_block(list_); block && verify(*block).valid()) {
      return block;
    }
    return one_less();
  }

 private:
  using Blocks = std::vector<Block>;

  [[nodiscard]] std::size_t steps() const {
    return p_.kind == Kind::circular ? blocks_.size() : blocks_.size() - 1;
  }
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % blocks_.size(); }
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return (i + blocks_.size() - 1) % blocks_.size();
  }
  [[nodiscard]] bool fit(const Block& one, const Block& other) const {
    return difference(one, other).size() == p_.change;
  }

  // The wrong steps that begin or end at a block.
  [[nodiscard]] std::uint64_t wrong_at(std::size_t i) const {
    const bool is_circular = p_.kind == Kind::circular;
    const bool after =
        (is_circular || i + 1 < blocks_.size()) && !fit(blocks_[i], blocks_[next(i)]);
    const bool to_here = (is_circular || i > 0) && !fit(blocks_[before(i)], blocks_[i]);
    return (after ? 1U : 0U) + (to_here ? 1U : 0U);
  }

  [[nodiscard]] std::optional<Design> design_of(const Blocks& blocks) const {
    Design design(p_, blocks);
    return verify(design).valid() ? std::optional(std::move(design)) : std::nullopt;
  }

  [[nodiscard]] bool has_right_steps(const Blocks& blocks) const {
    for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
      if (!fit(blocks[i], blocks[i + 1])) {
        return false;
      }
    }
    return p_.kind == Kind::linear || fit(blocks.back(), blocks.front());
  }

  // The same blocks, two of them exchanged or one elsewhere. Either touches the first wrong step.
  std::optional<Design> another_order() {
    constexpr std::uint64_t most_steps_of_two_blocks = 4;
    if (!covers_ || wrong_ == 0 || wrong_ > most_steps_of_two_blocks) {
      return std::nullopt;
    }
    const std::size_t here[] = {first_, next(first_)};
    Blocks blocks = blocks_;
    for (const std::size_t i : here) {
      for (std::size_t j = 0; j < blocks.size(); ++j) {
        stop_if_asked();
        std::swap(blocks[i], blocks[j]);
        if (i != j && has_right_steps(blocks)) {
          return design_of(blocks);
        }
        std::swap(blocks[i], blocks[j]);
      }
    }
    for (std::size_t j = 0; j < blocks_.size(); ++j) {
      stop_if_asked();
      for (const std::size_t i : here) {
        for (const auto& [from, to] : {std::pair(i, j), std::pair(j, here[1])}) {
          blocks = blocks_;
          move(blocks, from, to);
          if (has_right_steps(blocks)) {
            return design_of(blocks);
          }
        }
      }
    }
    return std::nullopt;
  }

  // The block at `from` comes to `to`; those between close up.
  static void move(Blocks& blocks, std::size_t from, std::size_t to) {
    const auto at = [&](std::size_t i) { return blocks.begin() + static_cast<std::ptrdiff_t>(i); };
    from < to ? std::rotate(at(from), at(from) + 1, at(to) + 1)
              : std::rotate(at(to), at(from), at(from) + 1);
  }

  std::optional<Design> one_less() const {
    for (std::size_t i = 0; covers_ && i < blocks_.size(); ++i) {
      stop_if_asked();
      if (wrong_at(i) == wrong_) {
        Blocks blocks = blocks_;
        blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(i));
        if (auto design = has_right_steps(blocks) ? design_of(blocks) : std::nullopt) {
          return design;
        }
      }
    }
    return std::nullopt;
  }

  const Design& list_;
  Parameters p_;
  Blocks blocks_;
  bool covers_;              // each subset is in some block
  std::uint64_t wrong_ = 0;  // steps
  std::size_t first_ = 0;    // of them, if there are any
};

}  // namespace

std::optional<Design> repaired_by_one_change(const Design& list, const Verdict& verdict) {
  return list.block_count() > most_blocks ? std::nullopt : OneChange(list, verdict).found();
}

}  // namespace changeover
