#include "plan/request/parts_left.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/each.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {

PartsLeft::PartsLeft(std::size_t parts, const Block& without) : number_(parts) {
  for (std::size_t x = 0; x < parts; ++x) {
    if (std::ranges::find(without, static_cast<Element>(x)) == without.end()) {
      number_[x] = static_cast<Element>(left_++);
    }
  }
}

void PartsLeft::add(std::uint64_t more) {
  for (std::uint64_t i = 0; i < more; ++i) {
    number_.emplace_back(static_cast<Element>(left_++));
  }
}

Block PartsLeft::operator()(const Block& parts) const {
  Block left;
  for (const Element x : parts) {
    if (number_[x]) {
      left.push_back(*number_[x]);
    }
  }
  return left;
}

PairSet PartsLeft::operator()(const PairSet& pairs) const {
  PairSet left(left_);
  pairs.for_each(all_of_them, [&](Element x, Element y) {
    if (number_[x] && number_[y]) {
      left.insert(*number_[x], *number_[y]);
    }
  });
  return left;
}

PairWeights PartsLeft::operator()(const PairWeights& weights) const {
  if (all()) {
    return weights;
  }
  PairWeights left;
  for (Element y = 1; y < number_.size(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (number_[x] && number_[y] && weights.weighs(x, y)) {
        left.set(*number_[x], *number_[y], weights(x, y));
      }
    }
  }
  return left;
}

PairReasons PartsLeft::operator()(const PairReasons& reasons) const {
  if (all()) {
    return reasons;
  }
  PairReasons left;
  for (Element y = 1; y < number_.size(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (number_[x] && number_[y]) {
        left.set(*number_[x], *number_[y], reasons(x, y));
      }
    }
  }
  return left;
}

std::vector<std::uint32_t> PartsLeft::slots(const Job& job) const {
  std::vector<std::uint32_t> slots;
  for (std::size_t x = 0; x < number_.size() && !job.slots.empty(); ++x) {
    slots.push_back(number_[x] ? job.slot_of[*number_[x]]
                               : no_slot - 1 - static_cast<std::uint32_t>(x));
  }
  return slots;
}

std::string unknown_part_defect(const std::string& list, const std::string& gone,
                                const std::vector<std::string>& names) {
  const std::size_t place = gone.rfind(" (" + list);
  const bool has_place = place != std::string::npos && gone.ends_with(')');
  return fmt::format("{}: {}", has_place ? gone.substr(place + 2, gone.size() - place - 3) : list,
                     PartFinder(names).complaint(has_place ? gone.substr(0, place) : gone));
}

std::string gone_note(const std::string& name, const std::vector<std::string>& gone,
                      GoneFrom from) {
  constexpr std::size_t few = 10;
  std::string names = joined(gone | std::views::take(few));
  if (gone.size() > few) {
    names += fmt::format(" and {} more", gone.size() - few);
  }
  return fmt::format("{}: no longer in the {}, and left out: {}", name,
                     from == GoneFrom::model ? "model" : "parts list", names);
}

}  // namespace changeover
