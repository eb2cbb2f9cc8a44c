#include "construct/tools/concatenation/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "bounds/counting_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/short_blocks.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

// How large the bases are that pieces are put after; any larger one is such a base with pieces,
// or has no fewer blocks.
constexpr std::uint64_t largest_base = 48;
// How often a piece is taken that has waste.
constexpr std::uint64_t most_of_the_worse = 3;

[[noreturn]] void refuse(const std::string& why) {
  throw BadInput("the blocks and positions do not form a piece: " + why + "; correct the recipe");
}

Piece with_parts(std::vector<Block> blocks, const std::vector<Element>& positions) {
  constexpr std::size_t most_elements = std::size_t{1} << 20;
  if (blocks.empty() || positions.empty()) {
    refuse("one of them is missing");
  }
  Piece piece;
  std::vector<bool> there;
  for (Block& block : blocks) {
    std::ranges::sort(block);
    if (block.empty() || block.back() >= most_elements) {
      refuse(fmt::format("elements must be below {}", most_elements));
    }
    if (std::ranges::adjacent_find(block) != block.end()) {
      refuse("a block has an element twice");
    }
    there.resize(std::max<std::size_t>(there.size(), block.back() + 1U));
    for (const Element x : block) {
      there[x] = true;
    }
  }
  if (!std::ranges::all_of(there, [](bool is) { return is; })) {
    refuse("elements must be numbered from 0 without gaps");
  }
  for (const Element position : positions) {
    if (position < 1 || position >= blocks.size() ||
        (!piece.parts.empty() && piece.parts.back().position >= position)) {
      refuse(fmt::format("positions must increase, from 1 to {}", blocks.size() - 1));
    }
    Block part = intersection(blocks[position - 1], blocks[position]);
    if (part.size() + 1 != blocks.front().size()) {
      refuse(fmt::format("other than one element changes at position {}", position));
    }
    for (const Element x : part) {
      if (!there[x]) {
        refuse(fmt::format("element {} is in two parts", x));
      }
      there[x] = false;
      piece.fresh.push_back(x);
    }
    piece.parts.push_back({position, std::move(part)});
  }
  std::ranges::sort(piece.fresh);
  for (Element x = 0; x < there.size(); ++x) {
    if (there[x]) {
      piece.first.push_back(x);  // all anchors, for now
    }
  }
  piece.blocks = std::move(blocks);
  return piece;
}

void reverse(Piece& piece) {
  std::ranges::reverse(piece.blocks);
  std::ranges::reverse(piece.parts);
  for (UnchangedSubset& part : piece.parts) {
    part.position = piece.blocks.size() - part.position;
  }
}

// Fans of a design, and then those of pieces.
class PieceSource final : public FanSource {
 public:
  PieceSource(std::unique_ptr<FanSource> design, Piece piece, std::uint64_t times,
              const Parameters& larger, Ends ends)
      : parameters_(larger),
        design_(std::move(design)),
        piece_(std::move(piece)),
        times_(times),
        open_(ends == Ends::open),
        begins_with_(static_cast<std::size_t>(larger.k)),
        now_(static_cast<std::size_t>(larger.k)),
        name_(piece_.anchors() + piece_.fresh.size()) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    const auto b = design_->block_count();
    return b ? std::optional(count_with_pieces(design_->parameters().v, *b, piece_, times_,
                                               open_ ? Ends::open : Ends::paired))
             : std::nullopt;
  }

  std::optional<Fan> next() override {
    if (ended_ && round_ == times_) {
      return std::nullopt;
    }
    if (!ended_) {
      if (const std::optional<Fan> fan = design_->next()) {
        std::ranges::copy(fan->kept, now_.begin());
        now_.back() = fan->last;
        if (!std::exchange(started_, true)) {
          begins_with_ = now_;
          begins_with_.back() = fan->first;
        }
        return fan;
      }
      ended_ = true;
      v_ = design_->parameters().v;
      begin_piece();
    }
    while (beside_ < piece_.parts.size() && piece_.parts[beside_].position == given_) {
      if (const std::optional<Fan> fan = insert()) {
        return fan;
      }
      next_ = 0;
      ++beside_;
    }
    if (given_ == piece_.blocks.size()) {
      v_ += piece_.fresh.size();
      if (++round_ == times_) {
        return std::nullopt;
      }
      begin_piece();
    }
    name_block(piece_.blocks[given_++]);
    return fan_to(now_.back());
  }

  bool rewind() override {
    started_ = ended_ = false;
    round_ = 0;
    return design_->rewind();
  }

 private:
  // The next elements that are no anchors, beside a part; nullopt if all have been inserted.
  std::optional<Fan> insert() {
    if (next_ == 0 && leaves_ends_out()) {
      next_ = piece_.first.size();
    }
    auto anchor = std::ranges::lower_bound(anchors_, next_);
    for (; anchor != anchors_.end() && *anchor == next_; ++anchor) {
      ++next_;
    }
    if (next_ >= v_) {
      return std::nullopt;
    }
    const auto first = static_cast<Element>(next_);
    next_ = anchor == anchors_.end() ? v_ : *anchor;
    name_block(piece_.parts[beside_].elements);
    now_.back() = static_cast<Element>(next_ - 1);
    return fan_to(first);
  }

  // The fan from this element to the last one of the block `now_`.
  [[nodiscard]] Fan fan_to(Element first) const {
    const std::span<const Element> all(now_);
    return {all.first(all.size() - 1), first, all.back()};
  }

  // Elements of the piece, as they are called in the design.
  void name_block(const Block& elements) {
    std::ranges::transform(elements, now_.begin(), [this](Element x) { return name_[x]; });
  }

  // Whether the elements of the first block are not inserted beside this part.
  bool leaves_ends_out() const {
    return open_ && round_ + 1 == times_ && given_ == piece_.blocks.size();
  }

  // After the block `now_`, whose elements with the largest numbers give the anchors.
  void begin_piece() {
    given_ = beside_ = 0;
    next_ = 0;
    Block end = now_;
    std::ranges::sort(end);
    anchors_.assign(end.end() - static_cast<std::ptrdiff_t>(piece_.first.size()), end.end());
    if (!piece_.last.empty() && open_) {
      for (std::size_t i = 0; i < piece_.last.size(); ++i) {
        anchors_.push_back(static_cast<Element>(i));
      }
    } else if (!piece_.last.empty()) {
      choose_both_anchors(end);
    }
    for (std::size_t i = 0; i < piece_.first.size(); ++i) {
      name_[piece_.first[i]] = anchors_[i];
    }
    for (std::size_t i = 0; i < piece_.last.size(); ++i) {
      name_[piece_.last[i]] = anchors_[piece_.first.size() + i];
    }
    for (std::size_t i = 0; i < piece_.fresh.size(); ++i) {
      name_[piece_.fresh[i]] = static_cast<Element>(v_ + i);
    }
    std::ranges::sort(anchors_);
  }

  // Those in the last block, rather without the first one's elements, then those in the first.
  void choose_both_anchors(const Block& end) {
    Block begin = begins_with_;
    std::ranges::sort(begin);
    const std::size_t n = piece_.first.size();
    Block at_end = difference(end, begin);
    for (const Element x : intersection(end, begin)) {
      at_end.push_back(x);
    }
    at_end.resize(n);
    Block at_begin = difference(begin, at_end);
    if (at_begin.size() < n) {
      throw BadInput(fmt::format("the ends of the {} have too many elements in common for a ring",
                                 name(design_->parameters())));
    }
    at_begin.resize(n);
    anchors_ = std::move(at_end);
    anchors_.insert(anchors_.end(), at_begin.begin(), at_begin.end());
  }

  Parameters parameters_;
  std::unique_ptr<FanSource> design_;
  Piece piece_;
  std::uint64_t times_;
  bool open_;                // the design's ends
  Block begins_with_;        // the design's first block
  Block now_;                // the last block of the fan before
  Block name_;               // by element of the piece: which element it is
  Block anchors_;            // those elements, sorted
  bool started_ = false;     // the design
  bool ended_ = false;       // the design
  std::uint64_t v_ = 0;      // elements before this piece
  std::uint64_t round_ = 0;  // pieces that are complete
  std::size_t given_ = 0;    // blocks of this piece
  std::size_t beside_ = 0;   // parts that are done
  std::uint64_t next_ = 0;   // the next to be inserted beside a part
};

// The best design for p that is no concatenation, no ring, and not cut from one.
std::optional<Offer> best_base(const Parameters& p, const Registry& registry) {
  std::optional<Offer> best;
  const auto consider = [&](const Parameters& asked) {
    if (impossibility(asked)) {
      return;
    }
    for (const Construction* construction : registry.constructions()) {
      const std::string_view name = construction->name();
      if (name == "concatenate" || name == "ring" || name == "ring-of-copies" || name == "cut") {
        continue;
      }
      std::optional<Offer> offer = construction->offer(asked, registry);
      if (offer && (!best || offer->b < best->b)) {
        best = std::move(offer);
      }
    }
  };
  consider(p);
  consider(p.as(Kind::circular));
  if (const Catalog* catalog = registry.catalog()) {
    for (auto known = catalog->fewest(p); known && (!best || known->b < best->b);
         known = catalog->fewest(p)) {
      if (auto entry = trusted_entry(*catalog, known->label)) {
        return Offer{std::move(entry->recipe), entry->b, false, false, false};
      }
    }
  }
  if (best && best->recipe.parameters.kind == Kind::circular) {
    best->recipe = cut_recipe(std::move(best->recipe));
  }
  return best;
}

// Whether k−1 elements of the first block are not among k−1 of the last.
bool has_ends_apart(const Recipe& recipe, const Registry& registry) {
  const auto source = registry.build(recipe);
  Block now(static_cast<std::size_t>(recipe.parameters.k));
  Block first;
  while (source->next(now)) {
    if (first.empty()) {
      first = sorted(now);
    }
  }
  return intersection(first, sorted(now)).size() <= 2;
}

std::uint64_t count_with_written(std::uint64_t v, std::uint64_t b, const WrittenPiece& piece,
                                 std::uint64_t times) {
  Piece same;
  same.blocks.resize(static_cast<std::size_t>(piece.b));
  same.parts.resize(piece.positions.size());
  same.first.resize(static_cast<std::size_t>(piece.w - piece.fresh));
  same.fresh.resize(static_cast<std::size_t>(piece.fresh));
  return count_with_pieces(v, b, same, times);
}

}  // namespace

Recipe written_recipe(const WrittenPiece& piece) {
  return literal_recipe(Design({piece.w, piece.k, 1, Kind::linear, 2}, short_blocks(piece.blocks)),
                        "annealing with the cells of a partition locked");
}

Piece open_piece(std::vector<Block> blocks, const std::vector<Element>& positions) {
  Piece piece = with_parts(std::move(blocks), positions);
  if (piece.first.size() + 1 != piece.blocks.front().size()) {
    refuse(fmt::format("{} {} in no part, not k-1", count_of(piece.first.size(), "element"),
                       piece.first.size() == 1 ? "is" : "are"));
  }
  if (!std::ranges::includes(piece.blocks.front(), piece.first)) {
    reverse(piece);
  }
  if (!std::ranges::includes(piece.blocks.front(), piece.first)) {
    refuse("the elements in no part are together in neither the first block nor the last");
  }
  return piece;
}

Piece closing_piece(std::vector<Block> blocks, const std::vector<Element>& positions) {
  Piece piece = with_parts(std::move(blocks), positions);
  const std::size_t n = piece.blocks.front().size() - 1;
  const Block all = std::move(piece.first);
  piece.first = intersection(all, piece.blocks.front());
  piece.last = difference(all, piece.first);
  if (piece.first.size() != n || piece.last.size() != n ||
      !std::ranges::includes(piece.blocks.back(), piece.last)) {
    refuse("of the elements in no part k-1 must be in the first block, and k-1 others in the last");
  }
  return piece;
}

Piece opened(Piece closing) {
  closing.parts.push_back({closing.blocks.size(), closing.last});
  std::ranges::copy(closing.last, std::back_inserter(closing.fresh));
  closing.last.clear();
  return closing;
}

std::uint64_t count_with_pieces(std::uint64_t v, std::uint64_t b, const Piece& piece,
                                std::uint64_t times, Ends ends) {
  // Round i = 0, 1, … adds the piece's blocks and, beside each part, v + i·fresh − anchors.
  const std::uint64_t parts = piece.parts.size();
  const std::uint64_t even =
      checked_add(piece.blocks.size(), checked_multiply(parts, v - std::min(v, piece.anchors())));
  const std::uint64_t pairs = times == 0 ? 0 : checked_multiply(times, times - 1) / 2;
  const std::uint64_t all =
      checked_add(b, checked_add(checked_multiply(times, even),
                                 checked_multiply(parts * piece.fresh.size(), pairs)));
  const bool leaves_ends_out = ends == Ends::open && piece.last.empty() && times > 0;
  return leaves_ends_out ? all - piece.first.size() : all;
}

std::unique_ptr<FanSource> with_pieces(std::unique_ptr<FanSource> design, Piece piece,
                                       std::uint64_t times, const Parameters& larger, Ends ends) {
  return std::make_unique<PieceSource>(std::move(design), std::move(piece), times, larger, ends);
}

std::optional<Offer> best_concatenation(const Parameters& p, const Registry& registry,
                                        bool for_a_ring) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::linear) {
    return std::nullopt;
  }
  std::vector<const WrittenPiece*> pieces;
  for (const WrittenPiece& piece : open_pieces()) {
    if (piece.k == p.k) {
      pieces.push_back(&piece);
    }
  }
  std::optional<Offer> best;
  const auto consider = [&](Recipe recipe, std::uint64_t b) {
    if (!best || b < best->b) {
      best = Offer{std::move(recipe), b, false, b == counting_bound(p), false};
    }
  };
  if (for_a_ring) {
    for (const WrittenPiece* piece : pieces) {
      if (piece->w == p.v) {
        consider(written_recipe(*piece), piece->b);
      }
    }
  }
  if (pieces.empty()) {
    return best;
  }
  const WrittenPiece& main = *pieces.front();
  const auto with = [](Offer base, const WrittenPiece& piece, std::uint64_t times) {
    if (times > 0) {
      base.b = count_with_written(base.recipe.parameters.v, base.b, piece, times);
      base.recipe =
          concatenate_recipe(std::move(base.recipe), written_recipe(piece), piece.positions, times);
    }
    return base;
  };
  for (std::uint64_t other = 0; other <= most_of_the_worse; ++other) {
    const WrittenPiece& second = *pieces.back();
    if ((other > 0 && pieces.size() == 1) || p.v < p.k + other * second.fresh) {
      break;
    }
    const std::uint64_t reached = p.v - other * second.fresh;
    for (std::uint64_t v = p.k + (reached - p.k) % main.fresh; v <= std::min(reached, largest_base);
         v += main.fresh) {
      const std::uint64_t times = (reached - v) / main.fresh;
      const bool base_alone = times + other == 0;
      if (base_alone && !for_a_ring) {
        continue;
      }
      auto base = best_base(p.on(v), registry);
      if (base && (!base_alone || has_ends_apart(base->recipe, registry))) {
        Offer offer = with(with(*std::move(base), second, other), main, times);
        consider(std::move(offer.recipe), offer.b);
      }
    }
  }
  return best;
}

}  // namespace changeover
