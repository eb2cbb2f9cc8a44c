#include "search/local/locked_draft.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "core/checked.hpp"
#include "core/sorted.hpp"
#include "search/local/random_list.hpp"

namespace changeover {
namespace {

/// Draws places for the required properties, and blocks that have them.
class Drawing {
 public:
  Drawing(const Parameters& p, const Wanted& wanted, std::size_t blocks, Random& random)
      : p_(p),
        wanted_(wanted),
        blocks_(blocks),
        part_size_(static_cast<std::size_t>(p.k - p.change)),
        random_(random) {}

  // nullopt if these places do not fit.
  std::optional<Draft> drawn() {
    if (!place_fixed() || !place_parts()) {
      return std::nullopt;
    }
    if (places_.empty()) {
      return free_list();
    }
    std::ranges::sort(places_, {}, &Place::block);
    return joined();
  }

 private:
  struct Place {
    std::size_t block;
    Block whole;   // the block at this place at the start
    Block locked;  // the elements of it that stay for ever
  };

  std::optional<Draft> free_list() {
    auto list = random_list(p_, blocks_, random_);
    return list ? std::optional(Draft{*std::move(list), {}, {}}) : std::nullopt;
  }

  // A random block that contains `elements` and else none of `without`; nullopt if there is none.
  std::optional<Block> filled(Block elements, const Block& without) {
    const std::size_t excluded = difference(without, elements).size();
    if (elements.size() > p_.k || p_.v - excluded < p_.k) {
      return std::nullopt;
    }
    while (elements.size() < p_.k) {
      const Element x = random_.below(static_cast<std::uint32_t>(p_.v));
      if (!holds_all(elements, std::span(&x, 1)) && !holds_all(without, std::span(&x, 1))) {
        elements.push_back(x);
      }
    }
    return sorted(elements);
  }

  // The same after a block from which m elements change.
  std::optional<Block> filled_after(Block elements, const Block& before, Block without) {
    Block stays = difference(difference(before, elements), without);
    const std::size_t kept = intersection(before, elements).size();
    std::size_t needed = part_size_ - std::min(part_size_, kept);
    if (elements.size() + needed > p_.k || stays.size() < needed) {
      return std::nullopt;
    }
    for (std::size_t i = 0; needed > 0; ++i, --needed) {
      std::swap(stays[i], stays[i + below(stays.size() - i)]);
      elements.push_back(stays[i]);
    }
    const Block leaving = difference(before, without);
    std::ranges::copy(leaving, std::back_inserter(without));
    return filled(std::move(elements), without);
  }

  void add(std::size_t block, Block whole, Block locked) {
    places_.push_back({block, std::move(whole), std::move(locked)});
    taken_[block] = true;
  }

  bool place_fixed() {
    taken_.assign(blocks_, false);
    if (!wanted_.first.empty()) {
      add(0, *filled(wanted_.first, {}), wanted_.first);
    }
    if (!wanted_.last.empty()) {
      if (taken_[blocks_ - 1]) {
        return false;
      }
      add(blocks_ - 1, *filled(wanted_.last, {}), wanted_.last);
    }
    const std::size_t size = wanted_.contained.size();
    if (size == 0) {
      return true;
    }
    if (size > blocks_) {
      return false;
    }
    const std::size_t from = below(blocks_ - size + 1);
    for (std::size_t i = 0; i < size; ++i) {
      if (taken_[from + i]) {
        return false;
      }
      add(from + i, wanted_.contained[i], wanted_.contained[i]);
    }
    return true;
  }

  std::size_t below(std::size_t limit) { return random_.below(static_cast<std::uint32_t>(limit)); }

  // The fewest steps from one part to the next. Parts of neighbouring steps share a block.
  [[nodiscard]] std::size_t least_gap() const { return 2 * part_size_ <= p_.k ? 1 : 2; }

  // Parts at random places, with room between them to change all elements where possible.
  bool place_parts() {
    if (!wanted_.expansion_set) {
      return true;
    }
    Block rest = in_parts(p_, wanted_);
    shuffle(rest, random_);
    const std::size_t count = rest.size() / part_size_;
    if (count == 0) {
      return true;
    }
    // Any places with room between them to change all elements, if there is that much room.
    const bool circular = p_.kind == Kind::circular;
    const std::size_t steps = circular ? blocks_ : blocks_ - 1;
    const std::size_t wanted_gap = ceil_div(p_.k, p_.change) + 1;
    const std::size_t usual = std::min(wanted_gap, steps / count);
    const std::size_t gap =
        least_gap() == 1 && (usual <= 1 || below(4) == 0) ? 1 : std::max<std::size_t>(2, usual);
    std::size_t at_start = wanted_.first.empty() ? 0 : gap - 1;
    std::size_t at_end = wanted_.last.empty() ? 0 : gap - 1;
    const std::size_t for_parts = gap * count - (circular ? 0 : gap - 1);
    if (at_start + at_end + for_parts > steps) {
      at_start = at_end = 0;  // Parts may be in the first and the last block.
    }
    const std::size_t room = at_start + at_end + for_parts;
    if (room > steps) {
      return false;
    }
    const std::size_t turned = circular ? below(steps) : at_start;
    std::vector<std::size_t> places;
    for (std::size_t j = 0; j < count; ++j) {
      places.push_back(below(steps - room + 1));
    }
    std::ranges::sort(places);
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t step = (turned + places[j] + gap * j) % steps;
      parts_.push_back({sorted(std::span(rest).subspan(j * part_size_, part_size_)),
                        static_cast<std::uint32_t>(step)});
    }
    return fill_beside_parts();
  }

  [[nodiscard]] std::size_t after(std::size_t block) const { return (block + 1) % blocks_; }
  [[nodiscard]] std::size_t before(std::size_t block) const {
    return (block + blocks_ - 1) % blocks_;
  }

  // The part that a block has in common with the next one; empty if there is none.
  [[nodiscard]] Block part_at(std::size_t step) const {
    const auto part = std::ranges::find(parts_, step, &LockedPart::block);
    return part == parts_.end() ? Block{} : part->elements;
  }

  [[nodiscard]] const Place* place_of(std::size_t block) const {
    const auto place = std::ranges::find(places_, block, &Place::block);
    return place == places_.end() ? nullptr : &*place;
  }

  // What a block must hold: the parts of the steps to it and from it, and what is locked in it.
  [[nodiscard]] Block required(std::size_t block) const {
    Block all = part_at(before(block));
    std::ranges::copy(part_at(block), std::back_inserter(all));
    if (const Place* place = place_of(block)) {
      std::ranges::copy(difference(place->locked, all), std::back_inserter(all));
    }
    return all;
  }

  // What a block must not hold since a neighbour does, with which it has only a part in common.
  [[nodiscard]] Block excluded(std::size_t block, const std::vector<bool>& filled_yet) const {
    Block all;
    for (const auto& [step, other] :
         {std::pair(before(block), before(block)), std::pair(block, after(block))}) {
      const Block part = part_at(step);
      if (!part.empty()) {
        const Block there = filled_yet[other] ? place_of(other)->whole : required(other);
        std::ranges::copy(difference(difference(there, part), all), std::back_inserter(all));
      }
    }
    return all;
  }

  // Draws the blocks beside the parts, one after another.
  bool fill_beside_parts() {
    std::vector<bool> filled_yet(blocks_, false);
    for (const LockedPart& part : parts_) {
      for (const std::size_t block : {std::size_t{part.block}, after(part.block)}) {
        if (filled_yet[block]) {
          continue;
        }
        const Block needed = required(block);
        const Block without = excluded(block, filled_yet);
        if (!intersection(needed, without).empty()) {
          return false;
        }
        const std::size_t previous = before(block);
        const bool steps_on = filled_yet[previous] && part_at(previous).empty();
        std::optional<Block> whole = steps_on
                                         ? filled_after(needed, place_of(previous)->whole, without)
                                         : filled(needed, without);
        if (!whole) {
          return false;
        }
        put(block, *std::move(whole));
        filled_yet[block] = true;
      }
    }
    return true;
  }

  // Another start for a block that has its place, or a place for it.
  void put(std::size_t block, Block whole) {
    if (taken_[block]) {
      std::ranges::find(places_, block, &Place::block)->whole = std::move(whole);
    } else {
      add(block, std::move(whole), {});
    }
  }

  std::optional<Draft> joined() {
    Draft draft{Design(p_), {}, parts_};
    std::vector<Block> list(blocks_);
    for (const Place& place : places_) {
      list[place.block] = place.whole;
      for (const Element x : place.locked) {
        draft.locked.push_back({static_cast<std::uint32_t>(place.block), x});
      }
    }
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      if (!walk(list, places_[i].block, places_[i + 1].block)) {
        return std::nullopt;
      }
    }
    const std::size_t first = places_.front().block;
    const std::size_t last = places_.back().block;
    if (p_.kind == Kind::circular) {
      if (!walk(list, last, first + blocks_)) {
        return std::nullopt;
      }
    } else {
      for (std::size_t i = last; i + 1 < blocks_; ++i) {
        list[i + 1] = random_step(list[i], p_, random_);
      }
      for (std::size_t i = first; i > 0; --i) {
        list[i - 1] = random_step(list[i], p_, random_);
      }
    }
    for (const Block& block : list) {
      draft.list.append(block);
    }
    return draft;
  }

  bool walk(std::vector<Block>& list, std::size_t from, std::size_t to) {
    const Block& end = list[to % blocks_];
    if (to == from + 1) {
      return difference(end, list[from]).size() == p_.change;
    }
    const auto way = random_walk(list[from], end, to - from, p_, random_);
    if (!way) {
      return false;
    }
    for (std::size_t i = 0; i < way->size(); ++i) {
      list[(from + 1 + i) % blocks_] = (*way)[i];
    }
    return true;
  }

  const Parameters& p_;
  const Wanted& wanted_;
  std::size_t blocks_, part_size_;
  Random& random_;
  std::vector<bool> taken_;  // by block
  std::vector<Place> places_;
  std::vector<LockedPart> parts_;
};

}  // namespace

std::optional<Draft> draw_draft(const Parameters& p, const Wanted& wanted, std::size_t blocks,
                                Random& random) {
  return Drawing(p, wanted, blocks, random).drawn();
}

}  // namespace changeover
