// Disjoint unchanged subsets: a greedy search, in which an element that few of them can still hold
// comes first, and then a walk that takes a set for one that it meets, until another set fits in.
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "changeover/run/control.hpp"
#include "construct/tools/concatenation/groups.hpp"
#include "core/each.hpp"
#include "core/sorted.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

constexpr std::uint32_t tries_a_place = 6;
constexpr std::size_t most_places_at_an_end = 40;
constexpr std::size_t walk_a_place = 2;  // steps for each element of the design
constexpr std::size_t walk_from_another = 15;
constexpr std::size_t last_walk = 500;
constexpr std::size_t last_walks = 3;
constexpr std::size_t rest_of_a_set = 20;  // steps until a set that went may come back

// Elements that no chosen set holds.
class FreeElements {
 public:
  explicit FreeElements(std::size_t v) : place_(v) {}
  [[nodiscard]] bool empty() const { return elements_.empty(); }
  [[nodiscard]] Element any(Random& random) const {
    return elements_[random.below(static_cast<std::uint32_t>(elements_.size()))];
  }
  void add(Element x) {
    place_[x] = elements_.size();
    elements_.push_back(x);
  }
  void remove(Element x) {
    elements_[place_[x]] = elements_.back();
    place_[elements_.back()] = place_[x];
    elements_.pop_back();
  }

 private:
  std::vector<Element> elements_;
  std::vector<std::size_t> place_;  // in elements_, of those that are there
};

class Packing {
 public:
  explicit Packing(const Design& design)
      : v_(static_cast<std::size_t>(design.v())),
        part_size_(static_cast<std::size_t>(design.k() - design.parameters().change)),
        with_(v_) {
    std::map<Block, std::size_t> numbers;
    for (UnchangedSubset& each : unchanged_subsets(design)) {
      if (each.elements.size() != part_size_) {
        continue;
      }
      const auto [known, is_new] = numbers.try_emplace(std::move(each.elements), sets_.size());
      if (is_new) {
        sets_.push_back({known->first, each.position, 0});
        for (const Element x : known->first) {
          with_[x].push_back(static_cast<std::uint32_t>(known->second));
        }
      }
      ++sets_[known->second].times;
    }
    // A design that was made with groups has its parts many times: they fit together.
    for (std::uint32_t i = 0; i < sets_.size(); ++i) {
      if (sets_[i].times > 1) {
        often_.push_back(i);
      }
    }
    std::ranges::stable_sort(often_,
                             [this](auto a, auto b) { return sets_[a].times > sets_[b].times; });
  }

  /// No more sets fit beside the hinge.
  [[nodiscard]] std::size_t most(const Block& hinge) const {
    return (v_ - hinge.size()) / part_size_;
  }
  [[nodiscard]] const Block& elements(std::uint32_t set) const { return sets_[set].elements; }
  [[nodiscard]] std::size_t position(std::uint32_t set) const { return sets_[set].position; }

  /// Sets that do not meet each other and `hinge`.
  std::vector<std::uint32_t> best(const Block& hinge, Random& random) {
    std::vector<std::uint32_t> best;
    for (std::uint32_t i = 0; i < tries_a_place && best.size() < most(hinge); ++i) {
      std::vector<std::uint32_t> found = pack(hinge, i % 2 == 0, random);
      if (found.size() > best.size()) {
        best = std::move(found);
      }
    }
    return walked(hinge, std::move(best), walk_a_place * v_, random);
  }

  /// Those of `sets` that do not meet the hinge.
  [[nodiscard]] std::vector<std::uint32_t> beside(const Block& hinge,
                                                  std::vector<std::uint32_t> sets) const {
    std::erase_if(sets,
                  [&](std::uint32_t i) { return !intersection(sets_[i].elements, hinge).empty(); });
    return sets;
  }

  /// As many or more such sets, after so many steps from `start`.
  std::vector<std::uint32_t> walked(const Block& hinge, std::vector<std::uint32_t> start,
                                    std::size_t steps, Random& random) const {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    constexpr std::uint32_t never = none - 1;
    std::vector<std::uint32_t> holder(v_, none);
    for (const Element x : hinge) {
      holder[x] = never;
    }
    for (const std::uint32_t i : start) {
      for (const Element x : sets_[i].elements) {
        holder[x] = i;
      }
    }
    std::size_t size = start.size();
    std::vector<std::size_t> back(sets_.size(), 0);
    FreeElements free(v_);
    for (Element x = 0; x < v_; ++x) {
      if (holder[x] == none && !with_[x].empty()) {
        free.add(x);
      }
    }
    for (std::size_t step = 0; step < steps && !free.empty() && start.size() < most(hinge);
         ++step) {
      const Element x = free.any(random);
      const std::uint32_t come =
          with_[x][random.below(static_cast<std::uint32_t>(with_[x].size()))];
      std::uint32_t gone = none;
      bool fits = back[come] <= step;
      for (std::size_t i = 0; i < part_size_ && fits; ++i) {
        const std::uint32_t other = holder[sets_[come].elements[i]];
        fits = other == none || (other != never && (gone == none || other == gone));
        gone = other == none ? gone : other;
      }
      if (!fits) {
        continue;
      }
      if (gone != none) {
        for (const Element y : sets_[gone].elements) {
          holder[y] = none;
          free.add(y);
        }
        back[gone] = step + rest_of_a_set;
        --size;
      }
      for (const Element y : sets_[come].elements) {
        holder[y] = come;
        free.remove(y);
      }
      if (++size > start.size()) {
        start.clear();
        for (const std::uint32_t each : holder) {
          if (each < never) {
            start.push_back(each);
          }
        }
        std::ranges::sort(start);
        start.erase(std::ranges::unique(start).begin(), start.end());
      }
    }
    return start;
  }

  /// Increasing.
  [[nodiscard]] std::vector<Element> positions_of(const std::vector<std::uint32_t>& sets) const {
    std::vector<Element> positions = each_of<Element>(
        sets, [&](const std::uint32_t i) { return static_cast<Element>(sets_[i].position); });
    std::ranges::sort(positions);
    return positions;
  }

 private:
  struct Set {
    Block elements;
    std::size_t position, times;
  };

  std::vector<std::uint32_t> pack(const Block& hinge, bool often_first, Random& random) {
    stop_if_asked();
    can_.assign(sets_.size(), true);
    left_.assign(v_, 0);
    for (std::size_t x = 0; x < v_; ++x) {
      left_[x] = static_cast<std::uint32_t>(with_[x].size());
    }
    std::vector<std::uint32_t> chosen;
    forbid(hinge);
    for (const std::uint32_t i : often_first ? often_ : std::vector<std::uint32_t>{}) {
      if (can_[i]) {
        choose(i, chosen);
      }
    }
    for (;;) {
      const auto rarest = rarest_element(random);
      if (rarest == v_) {
        return chosen;
      }
      choose(set_with(rarest, random), chosen);
    }
  }

  std::size_t rarest_element(Random& random) const {
    std::size_t rarest = v_;
    std::uint32_t alike = 0;
    for (std::size_t x = 0; x < v_; ++x) {
      if (left_[x] == 0 || (rarest != v_ && left_[x] > left_[rarest])) {
        continue;
      }
      alike = rarest != v_ && left_[x] == left_[rarest] ? alike + 1 : 1;
      if (random.below(alike) == 0) {
        rarest = x;
      }
    }
    return rarest;
  }

  // Most often the one whose elements are rarest.
  std::uint32_t set_with(std::size_t x, Random& random) const {
    const bool any = random.below(5) == 0;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    std::uint32_t alike = 0;
    std::uint32_t found = 0;
    for (const std::uint32_t i : with_[x]) {
      if (!can_[i]) {
        continue;
      }
      const std::uint64_t sum =
          sum_of(any ? Block{} : sets_[i].elements, [&](const Element y) { return left_[y]; });
      if (sum > least) {
        continue;
      }
      alike = sum == least ? alike + 1 : 1;
      least = sum;
      if (random.below(alike) == 0) {
        found = i;
      }
    }
    return found;
  }

  void choose(std::uint32_t i, std::vector<std::uint32_t>& chosen) {
    chosen.push_back(i);
    forbid(sets_[i].elements);
  }

  void forbid(const Block& elements) {
    for (const Element x : elements) {
      for (const std::uint32_t i : with_[x]) {
        if (can_[i]) {
          can_[i] = false;
          for (const Element y : sets_[i].elements) {
            --left_[y];
          }
        }
      }
    }
  }

  std::size_t v_, part_size_;
  std::vector<Set> sets_;
  std::vector<std::vector<std::uint32_t>> with_;  // by element
  std::vector<std::uint32_t> often_;
  std::vector<bool> can_;            // by set: disjoint from all that is chosen
  std::vector<std::uint32_t> left_;  // by element: how many such sets hold it
};

// Visits the n-subsets of a block until `visit` returns false.
template <typename Visit>
void for_subsets(const Block& block, std::size_t n, Visit visit) {
  std::vector<bool> in(block.size());
  std::fill_n(in.begin(), n, true);
  do {
    Block subset;
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (in[i]) {
        subset.push_back(block[i]);
      }
    }
    if (!visit(subset)) {
      return;
    }
  } while (std::prev_permutation(in.begin(), in.end()));
}

}  // namespace

std::vector<Hinge> hinges(const Design& design) {
  const std::size_t b = design.block_count();
  const auto n = static_cast<std::size_t>(design.k() - design.parameters().change);
  if (n == 0 || design.v() < 2 * n || b < 2) {
    return {};
  }
  Packing packing(design);
  Random random(1);
  std::vector<Hinge> found;
  const auto longest = [&](const Block& hinge, const std::vector<std::uint32_t>& start) {
    std::vector<std::uint32_t> best = start;
    for (std::size_t i = 0; i < last_walks && best.size() < packing.most(hinge); ++i) {
      std::vector<std::uint32_t> parts =
          packing.walked(hinge, start, last_walk * static_cast<std::size_t>(design.v()), random);
      if (parts.size() > best.size()) {
        best = std::move(parts);
      }
    }
    return best;
  };
  // At a step: any one of sets that fit together, beside the others.
  std::vector<std::uint32_t> together = longest({}, packing.best({}, random));
  if (design.parameters().kind == Kind::linear) {
    // A place and its parts, of those that were looked at the one with most.
    Hinge end;
    std::vector<std::uint32_t> parts;
    const auto look = [&](bool reversed, const Block& subset) {
      std::vector<std::uint32_t> here = packing.best(subset, random);
      std::vector<std::uint32_t> from_there =
          packing.walked(subset, packing.beside(subset, together),
                         walk_from_another * static_cast<std::size_t>(design.v()), random);
      std::vector<std::uint32_t>& more = from_there.size() > here.size() ? from_there : here;
      if (end.elements.empty() || more.size() > parts.size()) {
        end = {b, reversed, subset, {}};
        parts = std::move(more);
      }
      return parts.size() < packing.most(subset);
    };
    for (const bool reversed : {false, true}) {
      std::size_t places = 0;
      for_subsets(sorted(design.block(reversed ? 0 : b - 1)), n, [&](const Block& subset) {
        return look(reversed, subset) && ++places < most_places_at_an_end;
      });
    }
    end.positions = packing.positions_of(longest(end.elements, parts));
    if (end.reversed) {
      for (Element& position : end.positions) {
        position = static_cast<Element>(b) - position;
      }
      std::ranges::reverse(end.positions);
    }
    found.push_back(std::move(end));
  }
  if (!together.empty()) {
    const std::uint32_t hinge = together.back();
    together.pop_back();
    found.push_back(
        {packing.position(hinge), false, packing.elements(hinge), packing.positions_of(together)});
  }
  return found;
}

}  // namespace changeover
