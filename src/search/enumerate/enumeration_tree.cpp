#include "search/enumerate/enumeration_tree.hpp"

#include <algorithm>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t nodes_between_questions = 1024;

// The same for masks of one or two elements.
std::size_t count_few(Mask mask) {
  std::size_t n = 0;
  for (; mask != 0; mask &= mask - 1) {
    ++n;
  }
  return n;
}

// Whether the mask holds `n` elements or more; cheap for small n.
bool holds(Mask mask, std::size_t n) {
  switch (n) {
    case 0:
      return true;
    case 1:
      return mask != 0;
    case 2:
      return (mask & (mask - 1)) != 0;
    default:
      return count(mask) >= n;
  }
}

EndRole end_role(const EnumerationCase& own, std::size_t x) {
  if (!own.circular || (own.first_block() & bit(x)) == 0) {
    return EndRole::anywhere;
  }
  return (own.first_introduced() & bit(x)) != 0 ? EndRole::out : EndRole::in;
}

}  // namespace

EnumerationTree::EnumerationTree(const EnumerationCase& own, const DegreeTable& degrees)
    : own_(own), degrees_(degrees), levels_(own.b), path_(own.b) {
  Level& first = levels_.front();
  first.block = path_.front() = own.first_block();
  first.first_run = first.block;
  first.excess = own.excess;
  // The elements of the first block are twins, and so are those not introduced yet. In a circular
  // design, elements introduced in the first block differ from those that stay there.
  first.twins = own.all() & ~bit(0) & ~(own.k < 64 ? bit(own.k) : 0);
  if (own.circular && own.change < own.k) {
    first.twins &= ~bit(own.change);
  }
  for (std::size_t x = 0; x < own.v; ++x) {
    role_offset_[x] = DegreeTable::offset(end_role(own, x), false);
    Mask met = bit(x);
    if ((first.block & bit(x)) != 0) {
      const bool introduced = !own.circular || (own.first_introduced() & bit(x)) != 0;
      met |= introduced ? first.block : own.first_introduced();
      first.run_begin[x] = introduced ? std::int16_t{0} : std::int16_t{-1};
    }
    first.missing[x] = own.all() & ~met;
    first.still[x] = static_cast<std::uint8_t>(count(first.missing[x]));
  }
}

bool EnumerationTree::explore(std::span<const Mask> blocks, std::size_t depth,
                              EnumerationVisitor& visitor) {
  visitor_ = &visitor;
  target_ = depth;
  nodes_ = 0;
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    const Level& above = levels_[i - 1];
    std::size_t repeated = 0;
    Mask met = above.block & blocks[i];
    for (Mask rest = blocks[i] & ~above.block; rest != 0; rest &= rest - 1) {
      repeated += count(met & ~above.missing[lowest(rest)]);
      met |= bit(lowest(rest));
    }
    descend(i - 1, blocks[i], above.excess - static_cast<std::int64_t>(repeated));
  }
  return expand(blocks.size() - 1) && (nodes_ == 0 || visitor.go_on(nodes_));
}

bool EnumerationTree::expand(std::size_t depth) {
  if (depth == target_) {
    return visitor_->reached(std::span(path_).first(depth + 1));
  }
  const Level& here = levels_[depth];
  const std::size_t blocks_left = own_.b - 2 - depth;  // after the block that is chosen now
  Choice choice{.depth = depth, .row = &degrees_.row(blocks_left)};
  choice.allowance = degrees_.allowance(here.excess, blocks_left);
  choice.lanes_full = !DegreeTable::within(choice.allowance, 0x7ffe'7ffe'7ffe'7ffeU);
  for (Mask rest = own_.all() & ~here.block; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    choice.all_out += cost(choice, x, false, here.still[x]);
  }
  if (own_.longest_run > 0) {
    limit_runs(choice);
    if (count(choice.must_leave) > own_.change) {
      return true;
    }
  }
  const Mask free = here.block & ~choice.must_leave & ~choice.must_stay;
  return choose_leaving(choice, free, choice.must_leave, own_.change - count(choice.must_leave));
}

// Where many choices lead to no node, the visitor is called, too.
bool EnumerationTree::may_go_on() {
  constexpr unsigned choices_between_questions = 1U << 16;
  return ++choices_ % choices_between_questions != 0 || visitor_->go_on(0);
}

bool EnumerationTree::choose_leaving(Choice& choice, Mask from, Mask leaving, std::size_t more) {
  if (!may_go_on()) {
    return false;
  }
  const Level& here = levels_[choice.depth];
  if (more > 0) {
    for (Mask rest = from; holds(rest, more); rest &= rest - 1) {
      const Mask next = bit(lowest(rest));
      if (!choose_leaving(choice, rest & ~next, leaving | next, more - 1)) {
        return false;
      }
    }
    return true;
  }
  choice.stay = here.block & ~leaving;
  if ((((choice.stay & here.twins) >> 1) & ~choice.stay) != 0) {
    return true;  // Of twins, the lowest stay.
  }
  choice.base = choice.all_out;
  for (Mask rest = leaving; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    choice.base += cost(choice, x, false, here.still[x]);
  }
  Mask candidates = own_.all() & ~here.block;
  if (here.excess == 0) {
    for (Mask rest = choice.stay; rest != 0; rest &= rest - 1) {
      candidates &= here.missing[lowest(rest)];
    }
  }
  return introduce(choice, candidates, 0, own_.change, here.excess);
}

bool EnumerationTree::introduce(const Choice& choice, Mask from, Mask introduced, std::size_t more,
                                std::int64_t excess) {
  if (!may_go_on()) {
    return false;
  }
  if (more == 0) {
    return enter(choice, introduced, excess);
  }
  const Level& here = levels_[choice.depth];
  const Mask with = choice.stay | introduced;
  for (Mask rest = from; holds(rest, more); rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    if ((here.twins & bit(x)) != 0 && (introduced & (bit(x) >> 1)) == 0) {
      continue;  // Of twins, the lowest come first.
    }
    // Without excess, candidates must not miss any element that stays.
    const auto repeated =
        static_cast<std::int64_t>(here.excess == 0 ? count_few(introduced & ~here.missing[x])
                                                   : count(with & ~here.missing[x]));
    if (repeated <= excess &&
        !introduce(choice, rest & (rest - 1), introduced | bit(x), more - 1, excess - repeated)) {
      return false;
    }
  }
  return true;
}

bool EnumerationTree::enter(const Choice& choice, Mask introduced, std::int64_t excess) {
  const Level& here = levels_[choice.depth];
  const Mask block = choice.stay | introduced;
  std::uint64_t sum = choice.base;
  for (Mask rest = introduced; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    sum -= cost(choice, x, false, here.still[x]);
    sum += cost(choice, x, true, count(here.missing[x] & ~block));
  }
  for (Mask rest = choice.stay; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    sum += cost(choice, x, true, here.still[x] - count_few(here.missing[x] & introduced));
  }
  std::uint64_t allowance = choice.allowance;
  if (!choice.lanes_full) {
    constexpr std::uint64_t each_lane = 0x0001'0001'0001'0001U;
    allowance -= 2 * static_cast<std::uint64_t>(here.excess - excess) * each_lane;
  }
  if (!DegreeTable::within(sum, allowance)) {
    return true;
  }
  const std::size_t depth = choice.depth + 1;
  descend(choice.depth, block, excess);
  if (own_.longest_run > 0 && !runs_begin_well(depth)) {
    return true;
  }
  if (depth + 1 == own_.b) {
    if (!is_design()) {
      return true;
    }
  } else if (excess <= reach_excess &&
             !all_within_reach(own_,
                               {.block = block,
                                .excess = excess,
                                .missing = std::span(levels_[depth].missing).first(own_.v)})) {
    return true;
  }
  if (++nodes_ == nodes_between_questions) {
    nodes_ = 0;
    if (!visitor_->go_on(nodes_between_questions)) {
      return false;
    }
  }
  return expand(depth);
}

void EnumerationTree::descend(std::size_t depth, Mask block, std::int64_t excess) {
  const Level& above = levels_[depth];
  Level& here = levels_[depth + 1];
  here.block = path_[depth + 1] = block;
  here.first_run = above.first_run & block;
  here.excess = excess;
  here.twins = above.twins & ~((block << 1) & ~block);
  std::copy_n(above.missing.begin(), own_.v, here.missing.begin());
  std::copy_n(above.still.begin(), own_.v, here.still.begin());
  const Mask introduced = block & ~above.block;
  for (Mask rest = introduced; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    here.missing[x] &= ~block;
    here.still[x] = static_cast<std::uint8_t>(count(here.missing[x]));
  }
  for (Mask rest = block & above.block; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    const std::size_t covered = count_few(here.missing[x] & introduced);
    here.still[x] = static_cast<std::uint8_t>(here.still[x] - covered);
    here.missing[x] &= ~introduced;
  }
  if (own_.longest_run > 0) {
    follow_runs(depth + 1);
  }
}

void EnumerationTree::follow_runs(std::size_t depth) {
  const Level& above = levels_[depth - 1];
  Level& here = levels_[depth];
  const auto now = static_cast<std::int16_t>(depth);
  here.run_begin = above.run_begin;
  here.first_end = above.first_end;
  for (Mask rest = here.block & ~above.block; rest != 0; rest &= rest - 1) {
    here.run_begin[lowest(rest)] = now;
  }
  for (Mask rest = above.first_run & ~here.block & own_.last_unchanged(); rest != 0;
       rest &= rest - 1) {
    here.first_end[lowest(rest)] = now;
  }
}

// A run of full length ends now. A longer one that began before the first block never ends.
void EnumerationTree::limit_runs(Choice& choice) const {
  const Level& here = levels_[choice.depth];
  for (Mask rest = here.block; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    const auto length =
        static_cast<std::size_t>(static_cast<std::int64_t>(choice.depth) - here.run_begin[x] + 1);
    if (here.run_begin[x] >= 0) {
      choice.must_leave |= length >= own_.longest_run ? bit(x) : 0;
    } else {
      choice.must_stay |= length > own_.longest_run ? bit(x) : 0;
    }
  }
}

// Whether the run that begins the design has full length, at most one element is in every block,
// and no run across the end of the list is longer.
bool EnumerationTree::runs_begin_well(std::size_t depth) const {
  const Level& here = levels_[depth];
  if (depth < own_.longest_run && (here.first_run & own_.first_introduced()) == 0) {
    return false;
  }
  const Mask for_ever = here.first_run & own_.last_unchanged();
  if (depth + 2 > own_.longest_run && count(for_ever) > (own_.fixed == 0 ? 1U : 0U)) {
    return false;
  }
  if (depth + 1 < own_.b) {
    return true;
  }
  for (Mask rest = here.block & own_.last_unchanged() & ~for_ever; rest != 0; rest &= rest - 1) {
    const std::size_t x = lowest(rest);
    const std::int64_t length =
        static_cast<std::int64_t>(own_.b) - here.run_begin[x] + here.first_end[x];
    if (length > static_cast<std::int64_t>(own_.longest_run)) {
      return false;
    }
  }
  return true;
}

// Everything is covered and the cycle closes; this does not use the tables.
bool EnumerationTree::is_design() const {
  const Level& last = levels_.back();
  for (std::size_t x = 0; x < own_.v; ++x) {
    if (last.missing[x] != 0) {
      return false;
    }
  }
  if (own_.circular && (last.block & own_.first_block()) != own_.last_unchanged()) {
    return false;
  }
  return own_.fixed == 0 || last.first_run == 0;
}

std::uint64_t EnumerationTree::cost(const Choice& choice, std::size_t x, bool in,
                                    std::size_t missing) const {
  constexpr std::size_t to_in = 64;  // DegreeTable::offset: rows of one role are neighbours
  return (*choice.row)[role_offset_[x] + (in ? to_in : 0) + missing];
}

}  // namespace changeover
