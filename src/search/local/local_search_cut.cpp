// What can be had from designs that are known: recipes, cuts, parts.
#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/planner.hpp"
#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/scope.hpp"
#include "changeover/search/local_search.hpp"
#include "search/listening.hpp"
#include "search/local/local_search_known.hpp"

namespace changeover {
namespace {

// How often each pair is in the consecutive blocks from `begin` on; blocks come and go at the ends.
class Window {
 public:
  explicit Window(const Design& design) : design_(design) {
    const std::uint64_t pairs = binomial(design.v(), 2);
    require_memory(pairs * sizeof(std::uint32_t), "counting the pairs of a part of a design");
    times_.assign(static_cast<std::size_t>(pairs), 0);
  }

  [[nodiscard]] std::uint64_t covered() const { return covered_; }

  void add(std::size_t i) {
    for_each_pair(i, [&](std::uint32_t& times) { covered_ += times++ == 0 ? 1U : 0U; });
  }
  void remove(std::size_t i) {
    for_each_pair(i, [&](std::uint32_t& times) { covered_ -= --times == 0 ? 1U : 0U; });
  }

 private:
  template <typename Visit>
  void for_each_pair(std::size_t i, Visit&& visit) {
    stop_if_asked();
    const auto block = design_.block(i % design_.block_count());
    for (std::size_t a = 0; a < block.size(); ++a) {
      for (std::size_t c = 0; c < a; ++c) {
        visit(times_[static_cast<std::size_t>(PairSet::rank(block[a], block[c]))]);
      }
    }
  }

  const Design& design_;
  std::vector<std::uint32_t> times_;
  std::uint64_t covered_ = 0;
};

Design part(const Design& design, std::size_t begin, std::size_t length) {
  Parameters p = design.parameters();
  p.kind = Kind::linear;
  Design linear(p);
  for (std::size_t i = begin; i < begin + length; ++i) {
    linear.append(design.block(i % design.block_count()));
  }
  linear.set_labels(design.labels());
  return linear;
}

// Where windows may begin: anywhere in a circular design.
std::size_t last_block_of_windows(const Design& design) {
  const std::size_t b = design.block_count();
  return design.parameters().kind == Kind::circular ? 2 * b - 1 : b;
}

}  // namespace

Design without_needless_blocks(const Design& design) {
  if (design.parameters().strength != 2 || needed_block_count(design) == design.block_count()) {
    return design;
  }
  Design fewer = Registry::standard().build_design(drop_recipe(literal_recipe(design)));
  fewer.recipe.reset();
  return fewer;
}

std::optional<Design> truncated(const Design& design, std::uint64_t elements) {
  Design result = design;
  for (std::uint64_t i = 0; i < elements; ++i) {
    const auto recipe = truncate_recipe(literal_recipe(result), result);
    if (!recipe) {
      return std::nullopt;
    }
    result = Registry::standard().build_design(*recipe);
    result.recipe.reset();
  }
  return result;
}

Design shortest_cut(const Design& design) {
  const std::size_t b = design.block_count();
  if (design.parameters().strength != 2) {
    return part(design, 0, b);
  }
  Window window(design);
  std::size_t best = 0;
  std::size_t shortest = b;
  std::size_t end = 0;
  const std::uint64_t all = binomial(design.v(), 2);
  const std::size_t last = last_block_of_windows(design);
  for (std::size_t begin = 0; begin < b; ++begin) {
    while (window.covered() < all && end < last) {
      window.add(end++);
    }
    if (window.covered() < all) {
      break;
    }
    if (end - begin < shortest) {
      shortest = end - begin;
      best = begin;
    }
    window.remove(begin);
  }
  return without_needless_blocks(part(design, best, shortest));
}

Design best_part(const Design& design, std::size_t blocks) {
  const std::size_t b = design.block_count();
  const std::size_t length = std::clamp<std::size_t>(blocks, 1, b);
  if (design.parameters().strength != 2) {
    return part(design, 0, length);
  }
  Window window(design);
  for (std::size_t i = 0; i < length; ++i) {
    window.add(i);
  }
  std::size_t best = 0;
  std::uint64_t most = window.covered();
  for (std::size_t begin = 1; begin < b && begin + length <= last_block_of_windows(design);
       ++begin) {
    window.remove(begin - 1);
    window.add(begin + length - 1);
    if (window.covered() > most) {
      most = window.covered();
      best = begin;
    }
  }
  return part(design, best, length);
}

std::optional<Design> best_known_design(const Parameters& p) {
  const Registry& registry = Registry::standard();
  const auto best = best_known(
      registry, p, [](const Design& design) { return verify_listening(design).valid(); });
  if (!best) {
    return std::nullopt;
  }
  require_memory(checked_multiply(checked_multiply(best->b, p.k), sizeof(Element)),
                 "the best design that is known, the " + name(p) + ",");
  const std::unique_ptr<BlockSource> blocks = registry.build(best->recipe);
  ListeningSource listening(*blocks);
  Design design = read_all(listening);
  design.set_labels(registry.construction_of(best->recipe).labels(best->recipe, registry));
  design.recipe = best->recipe;
  if (!verify_listening(design).valid()) {
    throw InternalError("the best recipe for the " + name(p) + " does not give a design");
  }
  return design;
}

}  // namespace changeover
