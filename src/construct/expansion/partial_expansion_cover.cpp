// Finding covers by unchanged subsets.
//
// The ends of a linear design offer C(k,m) subsets each. None is written down: the search picks
// inner subsets only and asks at its leaves whether the ends, and what may be left out, can take
// the rest.
#include <algorithm>
#include <map>
#include <utility>

#include "changeover/construct/expansion.hpp"
#include "changeover/run/control.hpp"
#include "construct/expansion/partial_expansion_parts.hpp"
#include "core/checked.hpp"
#include "core/sorted.hpp"

namespace changeover {
namespace {

// The search recurses once an element at most.
constexpr std::uint64_t max_searched_elements = 4096;

// Which elements are to be taken by the ends and which are left out.
struct Finish {
  Block first, last, left_out;
  std::uint64_t ends = 0;  // how many ends are used
};

// A set-cover problem: distinct inner subsets of n elements, two ends, `slack` elements to leave
// out.
class CoverSearch {
 public:
  CoverSearch(const Design& design, const std::vector<UnchangedSubset>& inner)
      : v_(static_cast<std::size_t>(design.v())),
        n_(static_cast<std::size_t>(design.k() - design.parameters().change)),
        holders_(v_) {
    for (const UnchangedSubset& subset : inner) {
      stop_if_asked();
      if (index_.try_emplace(subset.elements, subsets_.size()).second) {
        for (const Element x : subset.elements) {
          holders_[x].push_back(static_cast<std::uint32_t>(subsets_.size()));
        }
        subsets_.push_back(&subset);
      }
    }
    if (design.parameters().kind == Kind::linear && design.block_count() > 0) {
      first_ = std::vector<bool>(v_, false);
      last_ = first_;
      for (const Element x : design.block(0)) {
        first_[x] = true;
      }
      for (const Element x : design.block(design.block_count() - 1)) {
        last_[x] = true;
      }
    }
  }

  struct Answer {
    std::optional<std::vector<std::size_t>> inner;  // indices of distinct subsets
    Finish finish;
    bool complete = false;  // no answer with fewer subsets than this one, or than allowed
    std::uint64_t cost = 0;
  };

  // The fewest subsets, less than `limit`, that leave at most `slack` elements out; it is known
  // that fewer than `least` do not.
  Answer run(std::uint64_t slack, std::uint64_t limit, std::uint64_t least, bool greedy_only,
             const SearchLimits& limits) {
    slack_ = slack;
    limit_ = limit;
    least_ = std::max(least, ceil_div(v_ - std::min<std::uint64_t>(slack, v_), n_));
    answer_ = {};
    greedy();
    if (greedy_only) {
      answer_.complete = answer_.inner && answer_.cost == least_;
      return answer_;
    }
    reset(limits);
    search();
    answer_.complete = !stopped_;
    return answer_;
  }

  // The same with one subset that has to be taken, and one element that need not be covered.
  Answer run_with(const UnchangedSubset& taken, Element exempt, std::uint64_t limit,
                  const SearchLimits& limits) {
    slack_ = 0;
    limit_ = limit;
    least_ = ceil_div(v_ - 1, n_);
    answer_ = {};
    reset(limits);
    const std::size_t i = index_.at(taken.elements);
    chosen_.push_back(i);
    change(static_cast<std::uint32_t>(i), +1);
    change_element(exempt, +1);
    search();
    answer_.complete = !stopped_;
    return answer_;
  }

  [[nodiscard]] const UnchangedSubset& subset(std::size_t i) const { return *subsets_[i]; }

 private:
  void reset(const SearchLimits& limits) {
    nodes_ = 0;
    limits_ = &limits;
    stopped_ = false;
    times_.assign(v_, 0);
    deferred_.assign(v_, false);
    banned_.assign(subsets_.size(), 0);
    chosen_.clear();
    uncovered_ = v_;
  }

  // The elements that are uncovered, as the ends and the slack would take them.
  template <typename Uncovered>
  std::optional<Finish> finish(const Uncovered& uncovered) const {
    Block only_first, only_last, both, neither;
    for (std::size_t x = 0; x < v_; ++x) {
      if (uncovered(x)) {
        const bool in_first = !first_.empty() && first_[x];
        const bool in_last = !last_.empty() && last_[x];
        (in_first  ? in_last ? both : only_first
         : in_last ? only_last
                   : neither)
            .push_back(static_cast<Element>(x));
      }
    }
    const std::size_t all = only_first.size() + only_last.size() + both.size() + neither.size();
    if (all <= slack_) {
      Finish result;
      result.left_out = neither;
      for (const Block* more : {&only_first, &only_last, &both}) {
        result.left_out.insert(result.left_out.end(), more->begin(), more->end());
      }
      return result;
    }
    if (first_.empty()) {
      return std::nullopt;
    }
    std::optional<Finish> best;
    for (const auto& [use_first, use_last] :
         {std::pair{true, false}, std::pair{false, true}, std::pair{true, true}}) {
      if (best) {
        break;  // with one end
      }
      Finish result;
      result.left_out = neither;
      result.ends = use_first && use_last ? 2 : 1;
      const auto take = [&](const Block& from, bool may_first, bool may_last) {
        for (const Element x : from) {
          if (may_first && result.first.size() < n_) {
            result.first.push_back(x);
          } else if (may_last && result.last.size() < n_) {
            result.last.push_back(x);
          } else {
            result.left_out.push_back(x);
          }
        }
      };
      take(only_first, use_first, false);
      take(only_last, false, use_last);
      take(both, use_first, use_last);
      if (result.left_out.size() <= slack_) {
        best = std::move(result);
      }
    }
    return best;
  }

  void record(const std::vector<std::size_t>& chosen, Finish finish) {
    const std::uint64_t cost = chosen.size() + finish.ends;
    if (cost < limit_) {
      limit_ = cost;
      answer_.inner = chosen;
      answer_.finish = std::move(finish);
      answer_.cost = cost;
    }
  }

  // Always a subset that covers the most, the first such one; by sweeps for every gain from n down,
  // as gains only fall.
  void greedy() {
    std::vector<bool> covered(v_, false);
    std::vector<std::size_t> chosen;
    const auto uncovered = [&](std::size_t x) { return !covered[x]; };
    const auto try_finish = [&] {
      if (auto end = finish(uncovered)) {
        record(chosen, *std::move(end));
      }
    };
    std::size_t left = v_;
    // Finishing is tried when few enough elements are left for it to be possible.
    const auto near_end = [&] { return left <= slack_ + (first_.empty() ? 0 : 2 * n_); };
    if (near_end()) {
      try_finish();
    }
    for (std::size_t gain = n_; gain > 0 && left > 0; --gain) {
      stop_if_asked();
      for (std::size_t i = 0; i < subsets_.size(); ++i) {
        const Block& elements = subsets_[i]->elements;
        const auto gained = static_cast<std::size_t>(std::ranges::count_if(elements, uncovered));
        if (gained < gain) {
          continue;
        }
        for (const Element x : elements) {
          covered[x] = true;
        }
        left -= gained;
        chosen.push_back(i);
        if (near_end()) {
          try_finish();
        }
        if (left <= slack_) {
          return;
        }
      }
    }
  }

  bool enter() {
    const bool limit = limits_->nodes && nodes_ >= *limits_->nodes;
    constexpr std::uint64_t between_looks = 256;
    if (nodes_ % between_looks == 0) {
      stop_if_asked();
    }
    stopped_ = limit || (nodes_ % between_looks == 0 && limits_->stop && limits_->stop());
    nodes_ += stopped_ ? 0U : 1U;
    return !stopped_;
  }

  [[nodiscard]] bool done() const { return stopped_ || limit_ <= least_; }

  // Picks the uncovered element that the fewest subsets can cover, and tries each of these, the one
  // that covers the most first, and then none. A subset that was tried need not be tried again
  // below its later siblings.
  void search() {
    const std::uint64_t open = uncovered_ - std::min<std::uint64_t>(slack_, uncovered_);
    if (chosen_.size() + ceil_div(open, n_) >= limit_ || done()) {
      return;
    }
    std::size_t pick = v_;
    std::size_t fewest = subsets_.size() + 1;
    for (std::size_t x = 0; x < v_; ++x) {
      if (times_[x] != 0 || deferred_[x]) {
        continue;
      }
      std::size_t count = 0;
      for (const std::uint32_t i : holders_[x]) {
        count += banned_[i] == 0 ? 1U : 0U;
      }
      if (count < fewest) {
        fewest = count;
        pick = x;
      }
    }
    if (pick == v_) {
      if (auto end = finish([&](std::size_t x) { return times_[x] == 0; })) {
        record(chosen_, *std::move(end));
      }
      return;
    }
    std::vector<std::pair<std::size_t, std::uint32_t>> options;  // gain, subset
    for (const std::uint32_t i : holders_[pick]) {
      if (banned_[i] == 0) {
        options.emplace_back(gain(i), i);
      }
    }
    std::ranges::stable_sort(options,
                             [](const auto& a, const auto& b) { return a.first > b.first; });
    std::size_t tried = 0;
    for (; tried < options.size() && enter(); ++tried) {
      const std::uint32_t i = options[tried].second;
      change(i, +1);
      chosen_.push_back(i);
      search();
      chosen_.pop_back();
      change(i, -1);
      ++banned_[i];
      if (done()) {
        ++tried;
        break;
      }
    }
    if (!done() && (slack_ > 0 || !first_.empty()) && enter()) {
      deferred_[pick] = true;
      if (finish([&](std::size_t x) { return times_[x] == 0 && deferred_[x]; })) {
        search();
      }
      deferred_[pick] = false;
    }
    for (std::size_t j = 0; j < tried; ++j) {
      --banned_[options[j].second];
    }
  }

  [[nodiscard]] std::size_t gain(std::uint32_t i) const {
    const Block& elements = subsets_[i]->elements;
    return static_cast<std::size_t>(
        std::ranges::count_if(elements, [&](Element x) { return times_[x] == 0; }));
  }

  void change(std::uint32_t i, int by) {
    for (const Element x : subsets_[i]->elements) {
      change_element(x, by);
    }
  }

  void change_element(Element x, int by) {
    if (by > 0) {
      uncovered_ -= times_[x]++ == 0 ? 1U : 0U;
    } else {
      uncovered_ += --times_[x] == 0 ? 1U : 0U;
    }
  }

  std::size_t v_, n_;
  std::vector<std::vector<std::uint32_t>> holders_;  // by element
  std::vector<const UnchangedSubset*> subsets_;
  std::map<Block, std::size_t> index_;  // in subsets_, by elements
  std::vector<bool> first_, last_;      // elements of the end blocks of a linear design, else empty

  std::uint64_t slack_ = 0, limit_ = 0, least_ = 0, nodes_ = 0;
  const SearchLimits* limits_ = nullptr;
  bool stopped_ = false;
  std::size_t uncovered_ = 0;
  std::vector<std::uint32_t> times_;  // by element: chosen subsets that hold it
  std::vector<bool> deferred_;        // by element: left to the ends or left out
  std::vector<std::uint32_t> banned_;
  std::vector<std::size_t> chosen_;
  Answer answer_;
};

// A cover being looked for, with what does not change between the searches.
class Finder {
 public:
  Finder(const Design& design, const CoverOptions& options)
      : design_(design),
        p_(design.parameters()),
        w_(options.new_elements),
        limits_(options.limits),
        n_(p_.k - p_.change),
        inner_(inner_subsets(design)),
        search_(design, inner_),
        greedy_only_(p_.v > max_searched_elements ||
                     inner_.size() > options.exact_up_to / std::max<std::uint64_t>(p_.v, 1)) {}

  std::optional<UnchangedCover> run() {
    if (design_.block_count() == 0) {
      return std::nullopt;
    }
    const std::vector<UnchangedSubset> all = one_subset_a_position(design_);
    std::optional<UnchangedCover> plain = without_leaving_out();
    if (plain) {
      const auto count = best_positions(p_, plain->subsets.size(), all.size(), w_);
      if (!count) {
        return std::nullopt;
      }
      (void)add_positions(*plain, all, *count);
    }
    if (p_.change == 1) {
      return plain && w_ > 1 ? with_one_wandering(*std::move(plain)) : std::move(plain);
    }
    return leaving_out(std::move(plain), positions_for_factors(p_, w_));
  }

 private:
  static std::vector<UnchangedSubset> inner_subsets(const Design& design) {
    std::vector<UnchangedSubset> result = unchanged_subsets(design);
    std::erase_if(result, [&](const UnchangedSubset& subset) {
      return subset.elements.size() != design.k() - design.parameters().change;
    });
    return result;
  }

  std::optional<UnchangedCover> without_leaving_out() {
    std::uint64_t at_least = 0;
    if (p_.v % n_ == 0 && !greedy_only_) {
      ExpansionSearch exact = find_expansion_sets(
          design_, {.how_many = 1, .count = false, .partial = false, .limits = limits_});
      if (!exact.sets.empty()) {
        return UnchangedCover{std::move(exact.sets.front()), {}, 0, true};
      }
      at_least = p_.v / n_ + (exact.complete ? 1 : 0);
    }
    return cover_of(search_.run(0, p_.v + 1, at_least, greedy_only_, limits_));
  }

  // Fewer subsets with elements left out; `plain` if there are none.
  std::optional<UnchangedCover> leaving_out(std::optional<UnchangedCover> plain,
                                            std::uint64_t least) {
    const std::uint64_t end =
        plain ? plain->subsets.size() : one_subset_a_position(design_).size() + 1;
    bool refuted = true;  // all smaller numbers were
    std::uint64_t tries = 0;
    for (std::uint64_t count = least; count < end && tries < max_tries; ++count) {
      const std::uint64_t left_out = may_be_left_out(p_, count, w_);
      if (left_out == 0 ? plain.has_value() : checked_add(count * n_, left_out) < p_.v) {
        continue;
      }
      ++tries;
      const auto answer = search_.run(left_out, count + 1, 0, greedy_only_, limits_);
      std::optional<UnchangedCover> cover = cover_of(answer);
      if (cover && finish(*cover, count)) {
        cover->minimum = refuted;
        return cover;
      }
      refuted = refuted && !cover && answer.complete;
    }
    if (plain) {
      plain->minimum = plain->minimum && refuted;
    }
    return plain;
  }

  // Adds positions until there are `count`, and puts what is left out beside new elements.
  bool finish(UnchangedCover& cover, std::uint64_t count) const {
    return add_positions(cover, one_subset_a_position(design_), count) &&
           put_beside(p_, w_, cover, [&](std::size_t place, Element y) {
             const std::size_t position = cover.subsets[place].position;
             const std::size_t b = design_.block_count();
             const auto is_in = [y](std::span<const Element> block) {
               return std::ranges::find(block, y) != block.end();
             };
             return !(position > 0 && is_in(design_.block(position - 1))) &&
                    !((position < b || p_.kind == Kind::circular) &&
                      is_in(design_.block(position < b ? position : 0)));
           });
  }

  // For m = 1: one position less, if the element that leaves at some position can be left out.
  UnchangedCover with_one_wandering(UnchangedCover plain) {
    const std::uint64_t limit = plain.subsets.size();
    if (greedy_only_ || inner_.empty() || ceil_div(p_.v - 1, n_) >= limit) {
      return plain;
    }
    SearchLimits each = limits_;
    if (each.nodes) {
      *each.nodes = *each.nodes / inner_.size() + 100;
    }
    for (const UnchangedSubset& subset : inner_) {
      const Element leaves =
          difference(design_.block(subset.position - 1), subset.elements).front();
      const auto answer = search_.run_with(subset, leaves, limit, each);
      std::optional<UnchangedCover> cover = cover_of(answer);
      if (!cover || left_out_elements(p_.v, cover->subsets) != Block{leaves} ||
          blocks_added(p_, cover->subsets.size(), w_, true) >=
              blocks_added(p_, plain.subsets.size(), w_, false)) {
        continue;
      }
      for (std::size_t i = 0; i < cover->subsets.size(); ++i) {
        if (cover->subsets[i].elements == subset.elements) {
          cover->subsets[i].position = subset.position;
        }
      }
      sort_by_position(cover->subsets);
      cover->sweep = static_cast<std::size_t>(std::ranges::find(cover->subsets, subset) -
                                              cover->subsets.begin());
      cover->minimum = cover->subsets.size() == ceil_div(p_.v - 1, n_);
      return *std::move(cover);
    }
    return plain;
  }

  [[nodiscard]] std::optional<UnchangedCover> cover_of(const CoverSearch::Answer& answer) const {
    if (!answer.inner) {
      return std::nullopt;
    }
    UnchangedCover cover;
    for (const std::size_t i : *answer.inner) {
      cover.subsets.push_back(search_.subset(i));
    }
    const std::size_t b = design_.block_count();
    const auto add_end = [&](std::size_t position, Block elements, std::size_t block) {
      if (elements.empty()) {
        return;
      }
      for (const Element x : design_.block(block)) {
        if (elements.size() < n_ && std::ranges::find(elements, x) == elements.end()) {
          elements.push_back(x);
        }
      }
      cover.subsets.push_back({position, sorted(elements)});
    };
    add_end(0, answer.finish.first, 0);
    add_end(b, answer.finish.last, b - 1);
    sort_by_position(cover.subsets);
    cover.minimum = answer.complete;
    return cover;
  }

  static void sort_by_position(std::vector<UnchangedSubset>& subsets) {
    std::ranges::sort(subsets,
                      [](const auto& a, const auto& b) { return a.position < b.position; });
  }

  static constexpr std::uint64_t max_tries = 32;

  const Design& design_;
  Parameters p_;
  std::uint64_t w_;
  SearchLimits limits_;
  std::uint64_t n_;
  std::vector<UnchangedSubset> inner_;
  CoverSearch search_;
  bool greedy_only_;
};

}  // namespace

std::optional<UnchangedCover> find_cover(const Design& design, const CoverOptions& options) {
  (void)least_positions(design.parameters(), options.new_elements);  // throws if w does not fit
  return Finder(design, options).run();
}

}  // namespace changeover
