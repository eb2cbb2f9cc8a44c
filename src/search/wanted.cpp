#include "changeover/search/wanted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "core/each.hpp"
#include "core/sorted.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

bool has_twice(const Block& block) {
  const Block in_order = sorted(block);
  return std::ranges::adjacent_find(in_order) != in_order.end();
}

std::size_t different(const std::vector<Block>& blocks) {
  std::set<Block> all;
  for (const Block& block : blocks) {
    all.insert(sorted(block));
  }
  return all.size();
}

std::string set_of(const Block& block) { return fmt::format("{{{}}}", fmt::join(block, ",")); }

}  // namespace

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

std::string wanted_defect(const Parameters& p, const Wanted& wanted) {
  if (p.kind == Kind::circular && !(wanted.first.empty() && wanted.last.empty())) {
    return "a circular design has no first and no last block; ask for a linear one";
  }
  for (const auto& [what, block] : {std::pair("first", &wanted.first), {"last", &wanted.last}}) {
    if (block->size() > p.k) {
      return fmt::format("the {} block has {} elements, not {}; name at most {}", what, p.k,
                         block->size(), p.k);
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
      return "an element is named twice; name it once";
    }
    if (!block->empty() && *std::ranges::max_element(*block) >= p.v) {
      return fmt::format("element {} does not exist; elements are 0 to {}",
                         *std::ranges::max_element(*block), p.v - 1);
    }
  }
  for (std::size_t i = 1; i < wanted.contained.size(); ++i) {
    if (difference(wanted.contained[i], wanted.contained[i - 1]).size() != p.change) {
      return fmt::format("blocks {} and {} of those given must differ in {}; correct one", i, i + 1,
                         count_of(p.change, "element"));
    }
  }
  if (wanted.expansion_set) {
    const std::uint64_t n = p.k - std::min(p.k, p.change);
    const std::size_t rest = in_parts(p, wanted).size();
    if (n == 0 || rest % n != 0) {
      return fmt::format(
          "{} cannot be divided into unchanged subsets of {}; name others in the first or last "
          "block",
          count_of(rest, "element"), n);
    }
  }
  return "";
}

Bound wanted_bound(const Parameters& p, const Wanted& wanted) {
  return wanted_bound(p, wanted, lower_bound(p));
}

Bound wanted_bound(const Parameters& p, const Wanted& wanted, Bound known) {
  Bound bound = std::move(known);
  const auto at_least = [&bound](std::uint64_t blocks, std::string reason) {
    if (blocks > bound.blocks) {
      bound = {.blocks = blocks, .name = "required", .reason = std::move(reason)};
    }
  };
  // A circular list may come round to the blocks that it began with.
  const std::uint64_t given =
      p.kind == Kind::linear ? wanted.contained.size() : different(wanted.contained);
  at_least(given,
           fmt::format("{} given", given == 1 ? "1 block is" : count_of(given, "block") + " are"));
  if (wanted.expansion_set && p.k > p.change) {
    const std::uint64_t parts = in_parts(p, wanted).size() / (p.k - p.change);
    const std::uint64_t needed = p.kind == Kind::circular ? parts : parts + 1;
    at_least(needed, fmt::format("{} of {} in a partition take as many steps, so {}",
                                 count_of(parts, "unchanged subset"), p.k - p.change,
                                 count_of(needed, "block")));
  }
  return bound;
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

std::string wanted_words(const Wanted& wanted, std::size_t shown) {
  std::vector<std::string> says;
  if (!wanted.first.empty()) {
    says.push_back("begins with " + set_of(wanted.first));
  }
  if (!wanted.last.empty()) {
    says.push_back("ends with " + set_of(wanted.last));
  }
  if (!wanted.contained.empty()) {
    const std::size_t count = wanted.contained.size();
    const auto sets =
        each_of<std::string>(std::span(wanted.contained).first(std::min(count, shown)), set_of);
    says.push_back(fmt::format("contains {}{}{}", fmt::join(sets, ", "),
                               count > shown ? fmt::format(" and {} more", count - shown) : "",
                               count == 1 ? "" : " one after another"));
  }
  if (wanted.expansion_set) {
    const bool all = wanted.first.empty() && wanted.last.empty();
    says.push_back(fmt::format("has disjoint unchanged subsets that hold all {}elements",
                               all ? "" : "other "));
  }
  std::string words;
  for (std::size_t i = 0; i < says.size(); ++i) {
    words += (i == 0 ? " that " : i + 1 < says.size() ? ", " : " and ") + says[i];
  }
  return words;
}

}  // namespace changeover
