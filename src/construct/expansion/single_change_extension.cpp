#include "construct/expansion/single_change_extension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/expansion/inserter.hpp"
#include "construct/tools/exact_cover.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

// Which of the 4(k−1) elements of a script: 0 is e, 1, …, k−2 the p_i, k−1, …, 2k−3 the x_i, and
// then the new ones follow.
using Role = std::uint32_t;

// Scripts as they are written, without the block S: old roles as digits, new ones as letters from a
// on. "*abc" stands for {a,b,c} with each further old element in turn.
constexpr std::string_view script_3 = "02a 12a 1ab *ab 3ab abd abc 0bc 2bc 2cd *cd 3cd 1cd 01d";
constexpr std::string_view script_4 =
    "345a 45ab 5abc *abc 0abc 0abd 1abd 13bd 13cd 14cd 14de 4def 5def *def 2def 23ef 2aef 2bef "
    "2cef 02ef 012f";

constexpr std::string_view script_text(std::uint64_t k) {
  switch (k) {
    case 3:
      return script_3;
    case 4:
      return script_4;
    default:
      return {};
  }
}

std::uint64_t old_roles(std::uint64_t k) { return 2 * (k - 1); }

struct Script {
  struct Step {
    std::vector<Role> roles;  // k of them, or k − 1 that are held beside every further element
    bool all_further = false;
  };
  std::vector<Step> steps;
  std::vector<Role> next;  // by old role: the role of this round that has it in the next
};

// e, p_i and x_i by the last k − 1 blocks of a list; `common` holds e. nullopt if it ends in
// another way.
template <typename Blocks>
std::optional<Block> roles_at_end(const Blocks& last, std::uint64_t k, const Block& common) {
  Block roles(static_cast<std::size_t>(old_roles(k)));
  Block introduced;
  std::size_t x = roles.size();
  for (std::size_t i = 1; i < last.size(); ++i) {
    const Block in = difference(last[i], last[i - 1]);
    const Block out = difference(last[i - 1], last[i]);
    if (in.size() != 1 || out.size() != 1) {
      return std::nullopt;
    }
    introduced.push_back(in.front());
    roles[i] = in.front();
    roles[--x] = out.front();
  }
  const Block& start = last.front();
  const Block remaining = intersection(last.back(), start);
  const Block candidates = difference(intersection(remaining, common), introduced);
  if (!intersection(start, introduced).empty() || remaining.size() != 2 || candidates.empty() ||
      intersection(last.back(), introduced).size() != introduced.size() ||
      intersection(common, introduced).size() != introduced.size()) {
    return std::nullopt;
  }
  roles[0] = *std::ranges::min_element(candidates);
  roles[static_cast<std::size_t>(k - 1)] = remaining[remaining.front() == roles[0] ? 1 : 0];
  return roles;
}

Script parse(std::string_view text, std::uint64_t k) {
  Script script;
  script.steps.emplace_back();
  for (const char c : text) {
    if (c == ' ') {
      script.steps.emplace_back();
    } else if (c == '*') {
      script.steps.back().all_further = true;
    } else {
      const auto letter = static_cast<Role>(old_roles(k)) + static_cast<Role>(c - 'a');
      script.steps.back().roles.push_back(c <= '9' ? static_cast<Role>(c - '0') : letter);
    }
  }
  std::vector<Block> last;
  for (auto step = script.steps.end() - static_cast<std::ptrdiff_t>(k - 1);
       step != script.steps.end(); ++step) {
    last.push_back(step->roles);
  }
  Block common;
  for (Role role = 0; role + 1 < k; ++role) {
    common.push_back(role);
  }
  script.next = roles_at_end(last, k, common).value();
  return script;
}

const Script& script(std::uint64_t k) {
  static const std::array<Script, 2> scripts{parse(script_3, 3), parse(script_4, 4)};
  return scripts.at(static_cast<std::size_t>(k - 3));
}

std::optional<Block> end_of(const Design& design) {
  const std::uint64_t k = design.k();
  std::vector<Block> last = design.blocks();
  last.erase(last.begin(), last.end() - static_cast<std::ptrdiff_t>(k - 1));
  const bool circular = design.parameters().kind == Kind::circular;
  const Block common = circular ? intersection(last.back(), design.block(0)) : last.back();
  if (circular && common.size() != k - 1) {
    return std::nullopt;
  }
  return roles_at_end(last, k, common);
}

// How many elements and blocks there are after some rounds.
struct Size {
  std::uint64_t v = 0;
  std::uint64_t b = 0;
};

Size size_after(const Design& design, std::uint64_t rounds) {
  const std::uint64_t k = design.k();
  const std::uint64_t added = checked_multiply(rounds, 2 * (k - 1));
  const std::uint64_t v = checked_add(design.v(), added);
  // Round r = 0, 1, … adds 2(v + 2(k−1)r) + 2k − 3 blocks.
  const std::uint64_t linear = checked_multiply(rounds, 2 * (design.v() + k) - 3);
  const std::uint64_t quadratic = checked_multiply(added, rounds == 0 ? 0 : rounds - 1);
  return {v, checked_add(design.block_count(), checked_add(linear, quadratic))};
}

Parameters extended_parameters(const Design& design, std::uint64_t rounds) {
  if (const auto defect = single_change_extension_defect(design)) {
    throw BadInput(fmt::format("cannot be extended: {}", *defect));
  }
  const Parameters p = design.parameters().on(size_after(design, rounds).v);
  check(p);
  return p;
}

// The last k − 2 blocks, of the design and of each round, are taken away before a further round.
std::size_t lasting_blocks(const Design& design, std::uint64_t rounds) {
  return design.block_count() - (rounds > 0 ? static_cast<std::size_t>(design.k() - 2) : 0);
}

std::unique_ptr<BlockSource> start_of(const Design& design, std::uint64_t rounds) {
  std::vector<Block> blocks = design.blocks();
  blocks.resize(lasting_blocks(design, rounds));
  return std::make_unique<BlockListSource>(design.parameters(), std::move(blocks));
}

// All rounds follow the start of the design; an insertion is a step of the script.
class ExtendedSource final : public InsertingSource {
 public:
  ExtendedSource(const Design& design, std::uint64_t rounds, const Parameters& larger)
      : InsertingSource(start_of(design, rounds), larger,
                        {rounds * lasting_steps(design.k()) + (rounds > 0 ? design.k() - 2 : 0),
                         size_after(design, rounds).b - lasting_blocks(design, rounds)}),
        rounds_(rounds),
        script_(script(design.k())),
        end_(*end_of(design)),
        small_v_(design.v()),
        start_(lasting_blocks(design, rounds)) {}

 private:
  // The number of further elements that are named at once.
  static constexpr std::size_t most_at_once = 1024;

  static std::uint64_t lasting_steps(std::uint64_t k) { return script(k).steps.size() - (k - 2); }

  [[nodiscard]] std::uint64_t position(std::uint64_t) const override { return start_; }

  [[nodiscard]] Insertion insertion(std::uint64_t i, const Place&) override {
    const std::uint64_t lasting = lasting_steps(parameters().k);
    const std::uint64_t round = std::min(i / lasting, rounds_ - 1);
    const auto index = static_cast<std::size_t>(i - round * lasting);
    if (index == 0) {  // which is one block
      begin_round(round);
    }
    const Script::Step& step = script_.steps[index];
    Block block(step.roles.size());
    std::ranges::transform(step.roles, block.begin(),
                           [this](Role role) { return elements_[role]; });
    if (!step.all_further) {
      return {{}, std::move(block)};
    }
    kept_ = std::move(block);
    Insertion result{kept_, {}};
    const auto old = elements_.begin() + static_cast<std::ptrdiff_t>(end_.size());
    for (; further_ < v_ && result.others.size() < most_at_once; ++further_) {
      if (std::find(elements_.begin(), old, static_cast<Element>(further_)) == old) {
        result.others.push_back(static_cast<Element>(further_));
      }
    }
    result.unfinished = further_ < v_;
    further_ = result.unfinished ? further_ : 0;
    return result;
  }

  void begin_round(std::uint64_t round) {
    Block old = end_;
    if (round > 0) {
      std::ranges::transform(script_.next, old.begin(),
                             [this](Role role) { return elements_[role]; });
    }
    v_ = small_v_ + round * old.size();
    further_ = 0;
    elements_ = std::move(old);
    for (std::size_t i = 0; i < end_.size(); ++i) {
      elements_.push_back(static_cast<Element>(v_ + i));
    }
  }

  std::uint64_t rounds_;
  const Script& script_;
  Block end_;  // the elements by their roles at the end of the design
  std::uint64_t small_v_;
  std::uint64_t start_;        // blocks that stay of the design
  std::uint64_t v_ = 0;        // elements before this round
  Block elements_;             // by role
  Block kept_;                 // beside further elements
  std::uint64_t further_ = 0;  // where to look for the next of them
};

// The expansion set of a design whose end may be removed; see the header.
std::optional<ExpansionSet> lasting_expansion_set(const Design& design) {
  const std::size_t b = design.block_count();
  const bool circular = design.parameters().kind == Kind::circular;
  std::vector<UnchangedSubset> subsets;
  if (!circular) {
    for (const Element left_out : design.block(0)) {
      subsets.push_back({0, difference(design.block(0), std::array{left_out})});
    }
  }
  for (UnchangedSubset& subset : unchanged_subsets(design)) {
    if (subset.position + design.k() <= b + 1 || subset.position == b) {
      subsets.push_back(std::move(subset));
    }
  }
  const auto v = static_cast<std::uint32_t>(design.v());
  ExactCover cover(v, 1);
  for (const UnchangedSubset& subset : subsets) {
    std::vector<std::uint32_t> columns(subset.elements.begin(), subset.elements.end());
    if (subset.position == 0) {
      columns.push_back(v);  // at most one of them
    }
    cover.add_row(columns);
  }
  const auto rows = cover.first_solution(SearchLimits{.nodes = 1'000'000, .stop = {}}).rows;
  if (!rows) {
    return std::nullopt;
  }
  ExpansionSet set;
  for (const std::size_t row : *rows) {
    set.push_back(std::move(subsets[row]));
    std::ranges::sort(set.back().elements);
  }
  return set;
}

}  // namespace

bool has_single_change_extension(std::uint64_t k) { return !script_text(k).empty(); }

std::optional<std::string> single_change_extension_defect(const Design& design) {
  const Parameters& p = design.parameters();
  if (p.change != 1 || p.strength != 2) {
    return fmt::format("a {} is not a single-change design of strength 2", name(p));
  }
  if (!has_single_change_extension(p.k)) {
    return fmt::format("no extension is known for blocks of {}", count_of(p.k, "element"));
  }
  if (p.v < old_roles(p.k) || design.block_count() < p.k) {
    return fmt::format("it needs v >= 2k - 2 = {} and at least k = {} blocks", old_roles(p.k), p.k);
  }
  if (!end_of(design)) {
    return fmt::format(
        "the last {} blocks do not introduce different elements that all stay until the {}",
        p.k - 2, p.kind == Kind::circular ? "first block follows" : "last block");
  }
  return std::nullopt;
}

std::unique_ptr<BlockSource> extend_single_change(const Design& design, std::uint64_t rounds) {
  const Parameters larger = extended_parameters(design, rounds);
  return std::make_unique<ExtendedSource>(design, rounds, larger);
}

std::optional<ExpansionSet> extended_expansion_set(const Design& design, std::uint64_t rounds) {
  (void)extended_parameters(design, rounds);
  const std::uint64_t k = design.k();
  std::optional<ExpansionSet> set = lasting_expansion_set(design);
  if (!set) {
    return std::nullopt;
  }
  std::optional<UnchangedSubset> closing;
  if (!set->empty() && set->back().position == design.block_count()) {
    closing = std::move(set->back());
    set->pop_back();
  }
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const Size size = size_after(design, round);
    std::uint64_t position = size.b - (k - 2);
    for (const Script::Step& step : script(k).steps) {
      if (!step.all_further) {
        ++position;
        continue;
      }
      UnchangedSubset held{static_cast<std::size_t>(position), {}};
      for (const Role role : step.roles) {
        held.elements.push_back(static_cast<Element>(size.v + role - old_roles(k)));
      }
      set->push_back(std::move(held));
      position += size.v - old_roles(k);
    }
  }
  if (closing) {
    closing->position = static_cast<std::size_t>(size_after(design, rounds).b);
    set->push_back(*std::move(closing));
  }
  return set;
}

}  // namespace changeover
