// Drop: leave out blocks that are not needed.
//
// A block may go if each of its pairs is in some other block and its neighbours differ in exactly m
// elements, or if it is the first or the last of a linear design. Blocks are tried from the ends
// inwards (linear) or in order (circular), again and again until none can go: deterministic, not
// always the most that could be dropped.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/control.hpp"
#include "construct/entry.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"

namespace changeover::drop_entry {
namespace {

/// Which blocks stay. The pairs are counted once; only blocks all of whose pairs are elsewhere can
/// ever go, for what goes makes the others rarer. So a design without such blocks costs one pass,
/// wherever it is cut open.
class Dropping {
 public:
  explicit Dropping(const Design& design)
      : design_(design), b_(design.block_count()), next_(b_), previous_(b_), stays_(b_, true) {
    find_candidates();
    if (candidates_.empty()) {
      return;
    }
    times_.resize(static_cast<std::size_t>(binomial(design.v(), 2)), 0);
    for (std::size_t i = 0; i < b_; ++i) {
      next_[i] = (i + 1) % b_;
      previous_[i] = (i + b_ - 1) % b_;
      for_each_pair(i, [&](std::size_t pair) {
        ++times_[pair];
        return true;
      });
    }
  }

  /// How many blocks are left when as many go as can, the list read as one of that kind that begins
  /// with block `start`. What went is back before the next run.
  std::size_t run(Kind kind, std::size_t start = 0) {
    undo();
    std::vector<std::size_t> tried(candidates_);
    std::rotate(tried.begin(), std::ranges::lower_bound(tried, start), tried.end());
    std::size_t left = b_;
    std::size_t first = start;
    std::size_t last = (start + b_ - 1) % b_;
    for (bool more = !tried.empty(); more && left > 3;) {
      more = false;
      for (const std::size_t i : tried) {
        stop_if_asked();
        if (left <= 3) {
          break;
        }
        const bool end = kind == Kind::linear && (i == first || i == last);
        if (!stays_[i] || !redundant(i) ||
            !(end || differ(previous_[i], next_[i]) == design_.parameters().change)) {
          continue;
        }
        more = true;
        --left;
        leave_out(i);
        first = i == first ? next_[i] : first;
        last = i == last ? previous_[i] : last;
      }
    }
    return left;
  }

  /// Whether a run can leave out any block at all.
  [[nodiscard]] bool can_drop() const { return !candidates_.empty(); }

  /// Those that the last run left.
  [[nodiscard]] std::vector<Block> blocks() const {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < b_; ++i) {
      if (stays_[i]) {
        const auto block = design_.block(i);
        blocks.emplace_back(block.begin(), block.end());
      }
    }
    return blocks;
  }

 private:
  void leave_out(std::size_t i) {
    stays_[i] = false;
    gone_.push_back(i);
    for_each_pair(i, [this](std::size_t pair) {
      --times_[pair];
      return true;
    });
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
  }

  void undo() {
    for (; !gone_.empty(); gone_.pop_back()) {
      const std::size_t i = gone_.back();
      stays_[i] = true;
      for_each_pair(i, [this](std::size_t pair) {
        ++times_[pair];
        return true;
      });
      next_[previous_[i]] = i;
      previous_[next_[i]] = i;
    }
  }

  // Two bits a pair tell whether it is in two blocks; most designs need no more.
  void find_candidates() {
    const auto words = static_cast<std::size_t>(ceil_div(binomial(design_.v(), 2), 64));
    std::vector<std::uint64_t> once(words, 0);
    std::vector<std::uint64_t> twice(words, 0);
    for (std::size_t i = 0; i < b_; ++i) {
      stop_if_asked();
      for_each_pair(i, [&](std::size_t pair) {
        const std::uint64_t bit = std::uint64_t{1} << (pair % 64);
        twice[pair / 64] |= once[pair / 64] & bit;
        once[pair / 64] |= bit;
        return true;
      });
    }
    for (std::size_t i = 0; i < b_; ++i) {
      if (for_each_pair(
              i, [&](std::size_t pair) { return (twice[pair / 64] >> (pair % 64) & 1) != 0; })) {
        candidates_.push_back(i);
      }
    }
  }

  // Until `visit` is false for the number of a pair; whether it never was.
  template <typename Visit>
  bool for_each_pair(std::size_t i, Visit&& visit) const {
    const auto block = design_.block(i);
    for (std::size_t a = 0; a < block.size(); ++a) {
      for (std::size_t c = 0; c < a; ++c) {
        if (!visit(static_cast<std::size_t>(PairSet::rank(block[a], block[c])))) {
          return false;
        }
      }
    }
    return true;
  }

  [[nodiscard]] bool redundant(std::size_t i) const {
    return for_each_pair(i, [this](std::size_t pair) { return times_[pair] > 1; });
  }

  [[nodiscard]] std::uint64_t differ(std::size_t i, std::size_t j) const {
    return difference(design_.block(i), design_.block(j)).size();
  }

  const Design& design_;
  std::size_t b_;
  std::vector<std::uint32_t> times_;  // in how many blocks each pair is, if there are candidates
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<bool> stays_;
  std::vector<std::size_t> candidates_;  // in order: all their pairs are in other blocks too
  std::vector<std::size_t> gone_;        // in the order in which they went
};

// Which blocks can go is known only when they are there; see construct/best_known.hpp.
constexpr Description description{
    .name = "drop",
    .summary = "leave out blocks that are not needed",
    .preconditions = "a block whose pairs are elsewhere and whose neighbours differ in m elements",
    .guarantee = "fewer blocks",
};

class Drop final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_input(recipe, recipe.parameters, {});
    const std::unique_ptr<BlockSource> source = registry.build(recipe.inputs.front());
    const Design design = read_within_memory(*source);
    Dropping dropping(design);
    (void)dropping.run(design.parameters().kind);
    return std::make_unique<BlockListSource>(recipe.parameters, dropping.blocks());
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format("Leave out the blocks of the {} that are not needed.",
                       changeover::name(recipe.inputs.front().parameters));
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    return labels_of_input(recipe, registry);
  }
};

}  // namespace

const Construction& construction() { return only<Drop>(); }

}  // namespace changeover::drop_entry

namespace changeover {

std::uint64_t needed_block_count(const Design& design) {
  return drop_entry::Dropping(design).run(design.parameters().kind);
}

Design without_needless_blocks(const Design& design) {
  if (design.parameters().strength != 2) {
    return design;
  }
  drop_entry::Dropping dropping(design);
  if (dropping.run(design.parameters().kind) == design.block_count()) {
    return design;
  }
  Design fewer(design.parameters(), dropping.blocks());
  fewer.set_labels(design.labels());
  return fewer;
}

BestCut best_cut(const Design& design, std::size_t most_cuts, std::uint64_t enough) {
  drop_entry::Dropping dropping(design);
  BestCut best{0, design.block_count()};
  for (std::size_t at = 0; at < design.block_count() && at < most_cuts; ++at) {
    const std::uint64_t needed = dropping.run(Kind::linear, at);
    if (needed < best.needed) {
      best = {at, needed};
    }
    if (best.needed <= enough || !dropping.can_drop()) {
      break;
    }
  }
  return best;
}

Recipe drop_recipe(const Recipe& input) { return {"drop", input.parameters, {}, {input}, {}}; }

}  // namespace changeover
