// Lists of set-ups of a model that change little: one parameter after the other takes its next
// value, in rounds.
//
// Let p change before q in each round. If p goes from x to x' in a round, and q from y to y', then
// (x, y), (x', y) and (x', y') are tested. If both have a values and go from each to each other
// once, by the same way, (x', x) is tested for all of them, and so all pairs are, with a(a−1) + 1
// settings a parameter, however many parameters there are. With two values that is the least, three
// settings, but for one parameter.
#include <algorithm>
#include <functional>
#include <optional>

#include "plan/search/choices/choice_search.hpp"

namespace changeover {
namespace {

// From each of so many to each other, once, and back: 0 1 0 2 0 3 1 2 1 3 2 3 0.
std::vector<std::size_t> way_through_all(std::size_t values) {
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < values; ++i) {
    for (std::size_t j = i + 1; j < values; ++j) {
      way.push_back(i);
      way.push_back(j);
    }
  }
  way.push_back(0);
  return way;
}

struct Sweep {
  std::vector<Element> values;  // in range, in any order
  std::vector<std::size_t> way;
  std::vector<bool> goes_on;  // by round
};

}  // namespace

std::optional<std::vector<Block>> swept(const ChoiceJob& choices, Random& random) {
  constexpr std::size_t most_values = 6;
  std::vector<Sweep> sweeps(choices.slots());
  std::size_t rounds = 0;
  for (std::size_t p = 0; p < choices.slots(); ++p) {
    Sweep& sweep = sweeps[p];
    for (const Element x : choices.values(p)) {
      if (!choices.job().model->value(x).negative) {
        sweep.values.push_back(x);
      }
    }
    if (sweep.values.empty() || sweep.values.size() > most_values) {
      return std::nullopt;
    }
    sweep.way = way_through_all(sweep.values.size());
    rounds = std::max(rounds, sweep.way.size() - 1);
  }
  std::vector<std::vector<bool>> by_size(most_values + 1);  // equal ways go on in the same rounds
  for (Sweep& sweep : sweeps) {
    std::vector<bool>& goes_on = by_size[sweep.values.size()];
    for (std::size_t left = sweep.way.size() - 1, r = 0; goes_on.size() < rounds; ++r) {
      const bool now = random.below(static_cast<std::uint32_t>(rounds - r)) < left;
      goes_on.push_back(now);
      left -= now ? 1 : 0;
    }
    sweep.goes_on = goes_on;
  }
  std::vector<std::size_t> order(sweeps.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](std::size_t p) { return sweeps[p].values.size(); });
  Block row;
  for (const Sweep& sweep : sweeps) {
    row.push_back(sweep.values[0]);
  }
  std::vector<Block> rows;
  const auto keep = [&] {
    if (choices.allows(row)) {
      rows.push_back(row);
    }
  };
  keep();
  std::vector<std::size_t> at(sweeps.size(), 0);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const std::size_t p : order) {
      if (sweeps[p].goes_on[round]) {
        row[p] = sweeps[p].values[sweeps[p].way[++at[p]]];
        keep();
      }
    }
  }
  return rows;
}

}  // namespace changeover
