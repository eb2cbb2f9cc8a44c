// Ring of copies: a list of blocks whose ends lack each other's pairs, copies of one linear
// single-change design after it, and the last copy closes the ring.
//
// The recipe's input is the copied design W; its first list names positions of unchanged subsets
// of W that hold all but 2(k−1) elements, k−1 in the first block and k−1 in the last. The blocks
// of the list V follow. `times` says how often W comes.
// See construct/tools/concatenation/pieces.hpp.
#include <fmt/format.h>

#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/pieces.hpp"
#include "construct/tools/short_blocks.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"

namespace changeover::ring_of_copies_entry {
namespace {

constexpr Description description{
    .name = "ring-of-copies",
    .summary = "copies of a linear single-change design that close a list with open ends",
    .preconditions = "circular, m = 1; a design split into unchanged subsets and k-1 at each end",
    .guarantee = "the blocks over the counting bound, before rounding, are those of all parts",
    .place = "docs/theorems.md, Theorem 13",
};

// The last copy brings the pairs of the first block with its own end: before others come, those
// with the list's end need blocks.
void pair_ends(std::vector<Block>& blocks, const Parameters& list) {
  for (Element x = 0; x + 1 < list.k; ++x) {
    Block block{x};
    for (std::uint64_t y = list.v - list.k + 1; y < list.v; ++y) {
      block.push_back(static_cast<Element>(y));
    }
    blocks.push_back(std::move(block));
  }
}

std::uint64_t blocks_of_ring(const Parameters& list, std::uint64_t b, const Piece& copy,
                             std::uint64_t times) {
  const Piece open = opened(copy);
  const std::uint64_t paired = times > 1 ? b + list.k - 1 : b;
  const std::uint64_t before = count_with_pieces(list.v, paired, open, times - 1, Ends::open);
  const std::uint64_t v =
      checked_add(list.v, checked_multiply(times - 1, std::uint64_t{open.fresh.size()}));
  return count_with_pieces(v, before, copy, 1, Ends::open);
}

class RingOfCopies final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry& /*registry*/) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular) {
      return std::nullopt;
    }
    std::optional<Offer> best;
    for (const WrittenPiece& written : copied_pieces()) {
      if (written.k != p.k) {
        continue;
      }
      const std::uint64_t step = written.fresh + p.k - 1;
      for (const WrittenPiece& list : open_lists()) {
        if (list.k != p.k || p.v < list.w + written.fresh ||
            (p.v - list.w - written.fresh) % step != 0) {
          continue;
        }
        const std::uint64_t times = 1 + (p.v - list.w - written.fresh) / step;
        const Piece copy = closing_piece(short_blocks(written.blocks), written.positions);
        const std::uint64_t b = blocks_of_ring(p.as(Kind::linear).on(list.w), list.b, copy, times);
        if (!best || b < best->b) {
          std::vector<Block> blocks = short_blocks(list.blocks);
          blocks.insert(blocks.begin(), written.positions);
          best = Offer{{std::string(name()),
                        p,
                        {{"times", static_cast<std::int64_t>(times)}},
                        {written_recipe(written)},
                        std::move(blocks)},
                       b,
                       false,
                       b == counting_bound(p),
                       false};
        }
      }
    }
    return best;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    return blocks_of(fans(recipe, registry));
  }

  std::unique_ptr<FanSource> fans(const Recipe& recipe, const Registry& registry) const override {
    Read read = read_recipe(recipe, registry);
    const Parameters list = recipe.parameters.as(Kind::linear).on(read.list_v);
    std::unique_ptr<FanSource> chain =
        fans_of(std::make_unique<BlockListSource>(list, std::move(read.list)));
    if (read.times > 1) {
      chain = with_pieces(std::move(chain), opened(read.copy), read.times - 1,
                          list.on(recipe.parameters.v - read.closes), Ends::open);
    }
    return with_pieces(std::move(chain), std::move(read.copy), 1, recipe.parameters, Ends::open);
  }

  std::string explain(const Recipe& recipe) const override {
    const Parameters& copied = recipe.inputs.at(0).parameters;
    const std::int64_t times = recipe.arguments.at("times");
    const std::string how_often = times == 1 ? "" : fmt::format(" {} times", times);
    const std::string ends =
        times == 1 ? ""
                   : fmt::format(
                         "Between the list and the first copy these {} come beside the "
                         "list's end. At the end of each copy but the last, and beside",
                         copied.k - 1);
    return fmt::format(
        "After a list of {} put the {}{}: {} at the end of what is there are the new one's too; "
        "the last one ends with {} of the first block. {} {} unchanged subsets{}, the old elements "
        "that are not in the copy are inserted{}.",
        count_of(recipe.blocks.size() - 1, "block"), changeover::name(copied), how_often,
        count_of(copied.k - 1, "element"), copied.k - 1, times == 1 ? "Beside" : ends,
        recipe.blocks.front().size(), times == 1 ? "" : " of each",
        times == 1 ? ""
                   : fmt::format(", but the {} at the end of the last copy but one", copied.k - 1));
  }

 private:
  struct Read {
    Piece copy;
    std::vector<Block> list;
    std::uint64_t list_v = 0;
    std::uint64_t times = 0;
    std::uint64_t closes = 0;  // elements that the last copy brings
  };

  /// @throws BadInput if the recipe is none.
  Read read_recipe(const Recipe& recipe, const Registry& registry) const {
    const Parameters& p = recipe.parameters;
    const auto given = recipe.arguments.find("times");
    if (recipe.inputs.size() == 1 && recipe.arguments.size() == 1 && recipe.blocks.size() > 2 &&
        given != recipe.arguments.end() && given->second > 0 && asks_for_pairs(p, 1) &&
        p.kind == Kind::circular && recipe.provenance.empty()) {
      const Parameters& copied = recipe.inputs.front().parameters;
      Read read;
      read.times = static_cast<std::uint64_t>(given->second);
      read.closes = recipe.blocks.front().size() * (p.k - 1);
      const std::uint64_t step = read.closes + p.k - 1;
      const std::uint64_t added = checked_add(checked_multiply(read.times - 1, step), read.closes);
      if (p.v > added && copied == p.as(Kind::linear).on(read.closes + 2 * p.k - 2)) {
        read.list_v = p.v - added;
        read.list.assign(recipe.blocks.begin() + 1, recipe.blocks.end());
        require_open_ends(read.list, read.list_v, p.k);
        if (read.times > 1) {
          pair_ends(read.list, p.on(read.list_v));
        }
        const std::unique_ptr<BlockSource> design = registry.build(recipe.inputs.front());
        read.copy = closing_piece(read_within_memory(*design).blocks(), recipe.blocks.front());
        return read;
      }
    }
    throw BadInput(fmt::format(
        "ring-of-copies to {} takes a linear single-change design with the same k, positions of it "
        "that leave 2(k-1) elements out, the blocks of a list, and how many times the design "
        "comes; correct the recipe",
        changeover::name(p)));
  }

  static void require_open_ends(const std::vector<Block>& list, std::uint64_t v, std::uint64_t k) {
    const Block begin = sorted(list.front());
    const Block end = sorted(list.back());
    bool fits = v >= 2 * k && begin.size() == k && end.size() == k && begin.back() + k <= v &&
                end.front() + 1 >= k;
    for (std::uint64_t i = 0; fits && i + 1 < k; ++i) {
      fits = begin[i] == i && end[i + 1] == v - k + 1 + i;
    }
    if (!fits) {
      throw BadInput(fmt::format(
          "ring-of-copies: of the first {} and the last {} of {} elements the list's first block "
          "must have the former and none of the latter, its last block the reverse; correct the "
          "list",
          k - 1, k - 1, v));
    }
  }
};

}  // namespace

const Construction& construction() { return only<RingOfCopies>(); }

}  // namespace changeover::ring_of_copies_entry
