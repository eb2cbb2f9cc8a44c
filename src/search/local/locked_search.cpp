#include "changeover/search/local_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"
#include "run/grace.hpp"
#include "run/threads.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/random_list.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t largest_locked_v = 4096;
constexpr std::uint64_t first_locked_moves = std::uint64_t{1} << 22;
// Few temperatures, where lists that miss one pair are entered most often: (16,5,29) and (20,5,46).
constexpr double hot = 0.28;
constexpr double cold = 0.24;
constexpr std::uint64_t most_doublings = 12;
constexpr int most_drawings = 200;  // of places, before an attempt has failed

bool has_twice(const Block& block) {
  const Block in_order = sorted(block);
  return std::ranges::adjacent_find(in_order) != in_order.end();
}

// All elements that must be in parts.
Block in_parts(const Parameters& p, const Wanted& wanted) {
  std::vector<bool> out(static_cast<std::size_t>(p.v));
  for (const Block* block : {&wanted.first, &wanted.last}) {
    for (const Element x : *block) {
      out[x] = true;
    }
  }
  Block rest;
  for (Element x = 0; x < p.v; ++x) {
    if (!out[x]) {
      rest.push_back(x);
    }
  }
  return rest;
}

/// A list to start from, and what is locked in it.
struct Draft {
  Design list;
  std::vector<LockedCell> locked;
  std::vector<LockedPart> parts;
};

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

  // A random block that contains `elements` and none of `without`.
  Block filled(Block elements, const Block& without) {
    while (elements.size() < p_.k) {
      const Element x = random_.below(static_cast<std::uint32_t>(p_.v));
      if (std::ranges::find(elements, x) == elements.end() &&
          std::ranges::find(without, x) == without.end()) {
        elements.push_back(x);
      }
    }
    return sorted(elements);
  }

  // The same after a block from which m elements change.
  Block filled_after(Block elements, const Block& before) {
    Block stays = difference(before, elements);
    std::size_t needed = part_size_ - std::min(part_size_, before.size() - stays.size());
    if (elements.size() + needed > p_.k) {
      return filled(std::move(elements), {});  // It cannot be.
    }
    for (std::size_t i = 0; needed > 0; ++i, --needed) {
      std::swap(stays[i], stays[i + below(stays.size() - i)]);
      elements.push_back(stays[i]);
    }
    return filled(std::move(elements), before);
  }

  void add(std::size_t block, Block whole, Block locked) {
    places_.push_back({block, std::move(whole), std::move(locked)});
    taken_[block] = true;
  }

  // A part and what is locked in a block that has its place; nullopt if that is too much.
  std::optional<Block> with_locked(std::size_t block, Block part) const {
    const Place& place = *std::ranges::find(places_, block, &Place::block);
    std::ranges::copy(place.locked, std::back_inserter(part));
    return part.size() <= p_.k ? std::optional(std::move(part)) : std::nullopt;
  }

  // Another start for a block that has its place, or a place for it.
  void put(std::size_t block, Block whole) {
    if (taken_[block]) {
      std::ranges::find(places_, block, &Place::block)->whole = std::move(whole);
    } else {
      add(block, std::move(whole), {});
    }
  }

  bool place_fixed() {
    taken_.assign(blocks_, false);
    if (!wanted_.first.empty()) {
      add(0, filled(wanted_.first, {}), wanted_.first);
    }
    if (!wanted_.last.empty()) {
      if (taken_[blocks_ - 1]) {
        return false;
      }
      add(blocks_ - 1, filled(wanted_.last, {}), wanted_.last);
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
    const std::size_t gap = std::max<std::size_t>(2, std::min(wanted_gap, steps / count));
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
    std::optional<std::size_t> previous;
    Block end;  // the second block of the previous part
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t step = (turned + places[j] + gap * j) % steps;
      const std::size_t next = (step + 1) % blocks_;
      const Block part = sorted(std::span(rest).subspan(j * part_size_, part_size_));
      const std::optional<Block> with_first = taken_[step] ? with_locked(step, part) : part;
      const std::optional<Block> with_last = taken_[next] ? with_locked(next, part) : part;
      if (!with_first || !with_last) {
        return false;
      }
      const Block before =
          previous == step ? filled_after(*with_first, end) : filled(*with_first, {});
      put(step, before);
      end = filled(*with_last, difference(before, part));
      put(next, end);
      parts_.push_back({part, static_cast<std::uint32_t>(step)});
      previous = next + 1;
    }
    return true;
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

class LockedSearch {
 public:
  LockedSearch(const Parameters& p, const Wanted& wanted, const LockedOptions& options,
               RunControl& control)
      : p_(p),
        wanted_(wanted),
        options_(options),
        control_(control),
        bound_(std::max<std::uint64_t>(lower_bound(p).blocks, wanted.contained.size())),
        goal_(std::max(bound_, options.blocks.value_or(0))),
        aim_(usual_aim()) {}

  LockedResult run() {
    run_together(control_, control_.threads(), [this](unsigned) { work(); });
    result_.lower_bound = bound_;
    result_.moves = moves_;
    result_.elapsed = control_.elapsed();
    result_.why_stopped = control_.why_stopped();
    return std::move(result_);
  }

 private:
  // Slightly above the bound, and at most the number that is enough.
  [[nodiscard]] std::uint64_t usual_aim() const {
    const std::uint64_t usual = bound_ + std::max<std::uint64_t>(2, bound_ / 8);
    return options_.blocks ? std::min(goal_, usual) : usual;
  }

  void work() {
    while (!control_.stop_wanted()) {
      std::uint64_t aim = 0;
      std::uint64_t moves = 0;
      std::uint64_t number = 0;
      {
        const std::scoped_lock lock(mutex_);
        aim = aim_;
        moves = budget_;
        number = result_.attempts++;
        if (options_.moves) {
          const std::uint64_t left = *options_.moves - std::min(*options_.moves, reserved_);
          if (left == 0) {
            control_.stop(WhyStopped::step_limit);
            return;
          }
          moves = std::min(moves, left);
          reserved_ += moves;
        }
      }
      try_once(aim, moves, number);
    }
  }

  void try_once(std::uint64_t aim, std::uint64_t moves, std::uint64_t number) {
    Random random(control_.seed(), 1 + number);
    control_.require_memory(annealing_bytes(p_, aim), "local search for the " + name(p_));
    std::optional<Draft> draft;
    for (int i = 0; i < most_drawings && !draft && !control_.stop_wanted(); ++i) {
      draft = Drawing(p_, wanted_, static_cast<std::size_t>(aim), random).drawn();
    }
    Annealed annealed;
    if (draft) {
      annealed = anneal_blocks(
          draft->list, 0, {.moves = moves, .hot = hot, .cold = cold}, random, control_,
          telling(control_, {.phase = fmt::format("annealing {} blocks with locked cells", aim),
                             .steps = moves_,
                             .best = best_blocks_ > 0 ? std::optional<std::uint64_t>(best_blocks_)
                                                      : std::nullopt,
                             .lower_bound = bound_}),
          {draft->locked, draft->parts});
      moves_ += annealed.outcome.moves;
    }
    const std::scoped_lock lock(mutex_);
    if (annealed.design) {
      take(*std::move(annealed.design), annealed.parts);
    } else if (aim == aim_ && !annealed.outcome.stopped) {
      failed();
    }
  }

  void take(Design design, const std::vector<LockedPart>& parts_of_it) {
    if (best_blocks_ > 0 && design.block_count() >= best_blocks_) {
      return;
    }
    const RunGrace to_the_end(control_);
    std::vector<std::size_t> positions;
    positions.reserve(parts_of_it.size());
    for (const LockedPart& part : parts_of_it) {
      positions.push_back(part.block + 1);
    }
    std::ranges::sort(positions);
    auto parts = parts_as_wanted(design, wanted_, positions);
    if (!parts) {
      throw InternalError("a search with locked cells lost what was wanted");
    }
    best_blocks_ = design.block_count();
    result_.design = surely_verified(std::move(design), fmt::format("a {}", name(p_)));
    result_.parts = *std::move(parts);
    if (best_blocks_ <= goal_) {
      control_.stop(WhyStopped::found);
      return;
    }
    step_ = std::max<std::uint64_t>(1, (best_blocks_ - goal_) / 2);
    aim_ = best_blocks_ - step_;
  }

  // Aims closer to the best design, or else runs longer.
  void failed() {
    if (best_blocks_ > 0 && step_ > 1) {
      step_ /= 2;
      aim_ = best_blocks_ - step_;
      return;
    }
    if (best_blocks_ == 0 && (!options_.blocks || aim_ < goal_)) {
      aim_ += std::max<std::uint64_t>(1, aim_ / 8);
      aim_ = options_.blocks ? std::min(goal_, aim_) : aim_;
      return;
    }
    if (doublings_ < most_doublings && ++fails_ % 4 == 0) {
      budget_ *= 2;
      ++doublings_;
    }
  }

  const Parameters& p_;
  const Wanted& wanted_;
  const LockedOptions& options_;
  RunControl& control_;
  const std::uint64_t bound_, goal_;
  std::uint64_t aim_;
  std::uint64_t step_ = 1;
  std::uint64_t budget_ = first_locked_moves;
  std::uint64_t doublings_ = 0;
  std::uint64_t fails_ = 0;
  std::uint64_t reserved_ = 0;  // moves of attempts that were started
  std::atomic<std::uint64_t> moves_ = 0;
  std::atomic<std::uint64_t> best_blocks_ = 0;  // 0 for none yet
  LockedResult result_;
  std::mutex mutex_;
};

}  // namespace

std::string wanted_defect(const Parameters& p, const Wanted& wanted) {
  if (p.strength != 2) {
    return "cells are locked for strength 2 only";
  }
  if (p.kind == Kind::circular && !(wanted.first.empty() && wanted.last.empty())) {
    return "a circular design has no first and no last block";
  }
  for (const auto& [what, block] : {std::pair("first", &wanted.first), {"last", &wanted.last}}) {
    if (block->size() > p.k) {
      return fmt::format("{} elements are wanted in the {} block of {}", block->size(), what, p.k);
    }
  }
  std::vector<const Block*> all{&wanted.first, &wanted.last};
  for (const Block& block : wanted.contained) {
    all.push_back(&block);
    if (block.size() != p.k) {
      return fmt::format("a block has {} elements, not {}; give whole blocks", p.k, block.size());
    }
  }
  for (const Block* block : all) {
    if (has_twice(*block)) {
      return "an element is named twice";
    }
    if (!block->empty() && *std::ranges::max_element(*block) >= p.v) {
      return fmt::format("element {} is not below {}", *std::ranges::max_element(*block), p.v);
    }
  }
  for (std::size_t i = 1; i < wanted.contained.size(); ++i) {
    if (difference(wanted.contained[i], wanted.contained[i - 1]).size() != p.change) {
      return fmt::format("blocks {} and {} of those wanted do not differ in {}", i, i + 1,
                         count_of(p.change, "element"));
    }
  }
  if (wanted.expansion_set) {
    const std::uint64_t n = p.k - std::min(p.k, p.change);
    const std::size_t rest = in_parts(p, wanted).size();
    if (n == 0 || rest % n != 0) {
      return fmt::format("{} cannot be parted into unchanged subsets of {}",
                         count_of(rest, "element"), n);
    }
  }
  return "";
}

std::optional<std::vector<UnchangedSubset>> parts_as_wanted(
    const Design& design, const Wanted& wanted, const std::vector<std::size_t>& positions) {
  const std::size_t b = design.block_count();
  if (b == 0 || !holds_all(design.block(0), wanted.first) ||
      !holds_all(design.block(b - 1), wanted.last)) {
    return std::nullopt;
  }
  const auto contains_from = [&](std::size_t start) {
    for (std::size_t i = 0; i < wanted.contained.size(); ++i) {
      if (!holds_all(design.block((start + i) % b), wanted.contained[i])) {
        return false;
      }
    }
    return true;
  };
  const bool circular = design.parameters().kind == Kind::circular;
  bool contained = wanted.contained.empty();
  for (std::size_t start = 0; start < b && !contained; ++start) {
    contained = (circular || start + wanted.contained.size() <= b) && contains_from(start);
  }
  if (!contained) {
    return std::nullopt;
  }
  std::vector<UnchangedSubset> parts;
  if (!wanted.expansion_set) {
    return parts;
  }
  Block held;
  for (const std::size_t position : positions) {
    if (position < 1 || position > (circular ? b : b - 1)) {
      return std::nullopt;
    }
    parts.push_back(
        {position, sorted(intersection(design.block(position - 1), design.block(position % b)))});
    held.insert(held.end(), parts.back().elements.begin(), parts.back().elements.end());
  }
  std::ranges::sort(held);
  return held == in_parts(design.parameters(), wanted) ? std::optional(std::move(parts))
                                                       : std::nullopt;
}

LockedResult search_locked(const Parameters& p, const Wanted& wanted, const LockedOptions& options,
                           RunControl& control) {
  check(p);
  if (const auto why = impossibility(p)) {
    throw ImpossibleParameters(fmt::format("there is no {}: {}", name(p), *why));
  }
  if (p.v > largest_locked_v || p.v == p.k) {
    throw BadInput(
        fmt::format("the search with locked cells supports v from k+1 = {} to {}, not {}", p.k + 1,
                    largest_locked_v, p.v));
  }
  if (const std::string defect = wanted_defect(p, wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  return LockedSearch(p, wanted, options, control).run();
}

}  // namespace changeover
