#include "construct/known_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// How often rules are put on top of what rules made: once less where each time costs seconds.
unsigned levels(const Parameters& p) {
  constexpr std::uint64_t most_elements = 300;
  return p.v <= most_elements ? 3 : 2;
}

// How many elements are taken away from one larger design.
constexpr std::size_t most_smaller = 8;

constexpr std::uint64_t largest_k_for_groups = 12;

// Designs are kept while they have no more than so many numbers together: 64 MiB.
constexpr std::uint64_t most_numbers_held = std::uint64_t{1} << 24;

std::size_t depth(const Recipe& recipe) {
  std::size_t deepest = 0;
  for (const Recipe& input : recipe.inputs) {
    deepest = std::max(deepest, depth(input));
  }
  return deepest + 1;
}

Offer offer_of(Recipe recipe, std::uint64_t b) {
  Offer offer{std::move(recipe), b, false, false, false};
  offer.economical = b == counting_bound(offer.recipe.parameters);
  return offer;
}

Parameters with(Parameters p, std::uint64_t v, std::uint64_t k) {
  p.v = v;
  p.k = k;
  return p;
}

// One more element in every block; of a design that has such elements, one more of them.
Recipe fixed_once_more(const Recipe& recipe) {
  const auto f = recipe.arguments.find("f");
  return recipe.construction == "fix" && f != recipe.arguments.end()
             ? fix_recipe(recipe.inputs.front(), static_cast<std::uint64_t>(f->second) + 1)
             : fix_recipe(recipe, 1);
}

// A cover by as few of the available positions as there can be, all of them 0: no design's cover
// costs less.
CoverPositions smallest_cover(const Parameters& p, std::uint64_t available) {
  CoverPositions cover{{}, available};
  cover.positions.resize(static_cast<std::size_t>(ceil_div(p.v, p.k - p.change)));
  return cover;
}

// About the fewest blocks that are left when elements of a linear single-change design are closed
// up one by one.
std::uint64_t left_by_closing_up(std::uint64_t b, const Parameters& p, std::size_t elements) {
  for (std::uint64_t v = p.v; v > p.v - elements; --v) {
    const std::uint64_t stays =
        2 * ceil_div(b + p.k, v);  // of one of the longest there, generously
    b -= std::min(b, stays);
  }
  return b;
}

}  // namespace

/// The next level of one cell.
class KnownDesigns::Cell {
 public:
  Cell(KnownDesigns& all, const Parameters& p, unsigned level, bool alone)
      : all_(all),
        p_(p),
        level_(level),
        alone_(alone),
        only_news_(all.comes_settled(p)),
        best_(all.at(p, level - 1, alone)) {}

  Ptr improved() {
    if (done() || (only_news_ && !all_.users_)) {
      return best_;
    }
    stop_if_asked();
    if (p_.kind == Kind::linear) {
      cut_open();
    }
    if (level_ == 1) {
      if (!alone_) {
        from_other_change_numbers();
      }
      fix(with_one_less(), level_);
      return best_;
    }
    if (level_ == 2 && !alone_) {
      coarsen();
    }
    if (level_ == 2 && !alone_) {
      concatenate_groups();
    }
    fix(with_one_less(), level_ - 1);
    unfix();
    take_away();
    expand();
    join_ends();
    if (best_ && !done() && usable(*best_)) {
      const std::uint64_t needed = all_.needed_of(best_);
      take(drop_recipe(best_->offer.recipe), needed, *best_);
    }
    // Last, so that designs of this cell's own come first: of the smaller design as good as it
    // gets, so that one that is best there is here, too.
    const Parameters smaller = with_one_less();
    fix(smaller, level_ == levels(p_) ? levels(smaller) : level_);
    return best_;
  }

 private:
  [[nodiscard]] bool done() const { return best_ && best_->offer.b == all_.bound(p_).blocks; }
  [[nodiscard]] bool helps(std::uint64_t b) const { return !best_ || b < best_->offer.b; }
  [[nodiscard]] bool usable(const Known& known) const {
    return known.depth < deepest_chain && (!only_news_ || known.news);
  }

  void take(Recipe recipe, std::uint64_t b, const Known& from) {
    if (helps(b)) {
      best_ = known(offer_of(std::move(recipe), b), from.news);
    }
  }

  // The design of q, if with so many blocks more it can be better than what there is.
  Ptr useful(const Parameters& q, unsigned level, std::uint64_t more, bool alone) {
    if (!all_.possible(q) || !helps(all_.bound(q).blocks + more)) {
      return nullptr;
    }
    // Where only news counts, cells that did not come with the catalog are not worth their levels.
    const bool leaf = only_news_ && !all_.comes_settled(q);
    const Ptr source = all_.at(q, leaf ? 0 : level, alone);
    return source && usable(*source) && helps(source->offer.b + more) ? source : nullptr;
  }
  Ptr useful(const Parameters& q, unsigned level, std::uint64_t more) {
    return useful(q, level, more, alone_);
  }

  // The cut that lets most blocks be dropped.
  void cut_open() {
    const Parameters circular = p_.as(Kind::circular);
    if (!all_.possible(circular)) {
      return;
    }
    const Ptr source = all_.at(circular, level_, alone_);
    if (!source || !usable(*source) || (best_ && best_->offer.b < source->offer.b)) {
      return;
    }
    const Recipe& recipe = source->offer.recipe;
    take(cut_recipe(recipe), source->offer.b, *source);
    if (level_ > 1 && !done()) {
      const BestCut cut = all_.cut_of(source, all_.bound(p_).blocks);
      take(drop_recipe(cut_recipe(recipe, cut.at)), cut.needed, *source);
    }
  }

  // What is linear, with a way back.
  void join_ends() {
    if (p_.kind == Kind::circular) {
      const Parameters linear = p_.as(Kind::linear);
      if (const Ptr source = useful(linear, level_ - 1, 0)) {
        if (auto made = join_ends_recipe(source->offer.recipe, all_.design_of(source))) {
          take(std::move(made->recipe), made->b, *source);
        }
      }
    }
  }

  // m from a proper divisor by blowing up, from 1 by coarsening; 1 from 2 by interpolating, which
  // looks no further.
  void from_other_change_numbers() {
    const std::uint64_t m = p_.change;
    const auto changed = [this](std::uint64_t s, std::uint64_t k, std::uint64_t change) {
      Parameters q = with(p_, p_.v / s, k / s);
      q.change = change;
      return q;
    };
    for (std::uint64_t s = 2; s <= m; ++s) {
      if (m % s != 0 || p_.v % s != 0 || p_.k % s != 0 || p_.k / s < 2) {
        continue;
      }
      const Parameters q = changed(s, p_.k, m / s);
      if (const Ptr source = useful(q, 2, 0, false)) {
        take(blow_up_recipe(source->offer.recipe, s), source->offer.b, *source);
      }
    }
    if (m == 1) {
      const Parameters q = changed(1, p_.k, 2);
      if (all_.possible(q) && helps(interpolated_count(q, 1, all_.bound(q).blocks))) {
        const Ptr source = all_.at(q, 1, true);
        if (source && usable(*source)) {
          take(interpolate_recipe(source->offer.recipe, 1),
               interpolated_count(q, 1, source->offer.b), *source);
        }
      }
    }
  }

  void concatenate_groups() {
    if (all_.stored_ == Stored::anew && is_stored_cell(p_) && p_.k <= largest_k_for_groups) {
      for (const Ptr& made : all_.with_groups_at(p_)) {
        if (helps(made->offer.b)) {
          best_ = made;
        }
      }
    }
  }

  // On one level only: of the other rules this one takes longest.
  void coarsen() {
    const std::uint64_t m = p_.change;
    if (m < 2 || p_.k <= m) {
      return;
    }
    Parameters q = with(p_, p_.v, p_.k - (m - 1));
    q.change = 1;
    if (!all_.possible(q) || !helps(ceil_div(all_.bound(q).blocks, m))) {
      return;
    }
    const Ptr source = all_.at(q, 1, false);
    if (source && usable(*source) && helps(ceil_div(source->offer.b, m))) {
      if (auto made = coarsen_recipe(source->offer.recipe, all_.design_of(source), m)) {
        take(std::move(made->recipe), made->b, *source);
      }
    }
  }

  [[nodiscard]] Parameters with_one_less() const { return with(p_, p_.v - 1, p_.k - 1); }

  void fix(const Parameters& smaller, unsigned level) {
    if (p_.k > 2) {
      if (const Ptr source = useful(smaller, level, 0)) {
        take(fixed_once_more(source->offer.recipe), source->offer.b, *source);
      }
    }
  }

  void unfix() {
    if (const Ptr source = useful(with(p_, p_.v + 1, p_.k + 1), level_ - 1, 0)) {
      if (const auto& recipe = all_.unfixed_of(source)) {
        take(*recipe, source->offer.b, *source);
      }
    }
  }

  // Larger designs lose elements.
  void take_away() {
    const bool closes_up = p_.change == 1 && p_.kind == Kind::linear;
    for (std::size_t elements = 1; elements <= most_smaller; ++elements) {
      const Parameters q = with(p_, p_.v + elements, p_.k);
      if (!all_.possible(q)) {
        continue;
      }
      const auto hopeful = [&](std::uint64_t b) {
        return helps(closes_up ? left_by_closing_up(b, q, elements) : b);
      };
      if (!hopeful(all_.bound(q).blocks)) {
        continue;
      }
      const bool leaf = only_news_ && !all_.comes_settled(q);
      const Ptr source = all_.at(q, leaf ? 0 : level_ - 1, alone_);
      if (source && usable(*source) && hopeful(source->offer.b)) {
        if (const Ptr made = all_.smaller(source, elements); made && helps(made->offer.b)) {
          best_ = made;
        }
      }
    }
  }

  // New elements at the positions of a cover, which is searched for only if the smallest there can
  // be would help, and for a few designs only: those that promise most.
  void expand() {
    struct Promising {
      std::uint64_t b, w, added;
    };
    std::vector<Promising> sources;
    for (std::uint64_t w = 1; p_.change < p_.k && p_.v > p_.k + w; ++w) {
      const Parameters q = with(p_, p_.v - w, p_.k);
      if (p_.change >= 3 && w > p_.change) {
        break;
      }
      if (!new_elements_fit(q, w)) {
        continue;
      }
      constexpr std::uint64_t any = std::numeric_limits<std::uint32_t>::max();
      const auto added = partial_expansion_count(q, 0, smallest_cover(q, any), w);
      if (!added || !helps(*added + counting_bound(q))) {
        continue;
      }
      if (const Ptr source = useful(q, 1, 0)) {
        sources.push_back({source->offer.b + *added, w, *added});
      }
    }
    constexpr std::size_t most_sources = 20;
    std::ranges::stable_sort(sources, {}, &Promising::b);
    sources.resize(std::min(sources.size(), most_sources));
    for (const auto& [b, w, added] : sources) {
      const Parameters q = with(p_, p_.v - w, p_.k);
      if (const Ptr source = useful(q, level_ - 1, added)) {
        const auto& cover = all_.cover_of(source);
        const auto made =
            cover ? partial_expansion_count(q, source->offer.b, *cover, w) : std::nullopt;
        if (made && helps(*made)) {
          take(partial_expansion_recipe(source->offer.recipe, *cover, w), *made, *source);
        }
      }
    }
  }

  KnownDesigns& all_;
  Parameters p_;
  unsigned level_;
  bool alone_;
  bool only_news_;
  Ptr best_;
};

KnownDesigns::KnownDesigns(const Registry& registry, Stored stored)
    : registry_(registry),
      stored_(stored),
      users_(registry.catalog() != nullptr && registry.catalog()->largest_users_v()) {}

KnownDesigns::Ptr KnownDesigns::known(Offer offer, bool news) {
  const std::size_t deep = depth(offer.recipe);
  return std::make_shared<Known>(Known{.offer = std::move(offer), .depth = deep, .news = news});
}

std::optional<Offer> KnownDesigns::best(const Parameters& p) {
  if (p.strength != 2 || p.k < 2 || p.v > largest_v_of_a_range || impossibility(p) || p.v == p.k) {
    return registry_.best(p);
  }
  const Ptr best = at(p, levels(p), false);
  if (!best) {
    return std::nullopt;
  }
  if (!comes_settled(p) || best != at(p, 0, false)) {
    static_cast<void>(design_of(best));  // It keeps its promise.
  }
  return best->offer;
}

const Bound& KnownDesigns::bound(const Parameters& p) {
  const auto found = bounds_.find(p);
  if (found != bounds_.end()) {
    return found->second;
  }
  stop_if_asked();
  return bounds_.emplace(p, lower_bound(p)).first->second;
}

bool KnownDesigns::possible(const Parameters& p) {
  if (p.k < 2 || p.v <= p.k || p.change > p.k || p.v > largest_v_of_a_range) {
    return false;
  }
  const auto found = possible_.find(p);
  return found != possible_.end() ? found->second
                                  : possible_.emplace(p, !impossibility(p)).first->second;
}

bool KnownDesigns::comes_settled(const Parameters& p) const {
  return stored_ == Stored::as_shipped && registry_.catalog() != nullptr && is_stored_cell(p);
}

KnownDesigns::Ptr KnownDesigns::at(const Parameters& p, unsigned level, bool alone) {
  const Key key(p, level, alone);
  if (const auto found = cells_.find(key); found != cells_.end()) {
    return found->second;
  }
  Ptr result = level > 0 ? Cell(*this, p, level, alone).improved()
               : alone   ? at(p, 0, false)
                         : offered(p);
  return cells_.emplace(key, std::move(result)).first->second;
}

KnownDesigns::Ptr KnownDesigns::offered(const Parameters& p) {
  auto offer = registry_.best(p);
  if (!offer) {
    return nullptr;
  }
  bool news = false;
  if (users_) {
    const auto fewest = registry_.catalog()->fewest(p);
    news = fewest && fewest->b == offer->b && !registry_.catalog()->is_shipped(fewest->label);
  }
  return known(*std::move(offer), news);
}

const Design& KnownDesigns::design_of(const Ptr& known) {
  const auto held =
      std::ranges::find_if(designs_, [&](const auto& each) { return each.first == known; });
  if (held != designs_.end()) {
    return held->second;
  }
  stop_if_asked();
  const Offer& offer = known->offer;
  Design design = registry_.build_design(offer.recipe);
  if (design.block_count() != offer.b || !verify(design).valid()) {
    throw InternalError(fmt::format("the construction {} does not keep its promise for {}",
                                    offer.recipe.construction, name(offer.recipe.parameters)));
  }
  const auto size = [](const Design& of) { return std::uint64_t{of.block_count()} * of.k(); };
  numbers_held_ += size(design);
  designs_.emplace_back(known, std::move(design));
  while (numbers_held_ > most_numbers_held && designs_.size() > 1) {
    numbers_held_ -= size(designs_.front().second);
    designs_.pop_front();
  }
  return designs_.back().second;
}

std::uint64_t KnownDesigns::needed_of(const Ptr& known) {
  if (!known->needed) {
    known->needed = needed_block_count(design_of(known));
  }
  return *known->needed;
}

const BestCut& KnownDesigns::cut_of(const Ptr& known, std::uint64_t enough) {
  constexpr std::size_t most_cuts = 64;
  if (!known->cut) {
    known->cut = best_cut(design_of(known), most_cuts, enough);
  }
  return *known->cut;
}

const std::optional<Recipe>& KnownDesigns::unfixed_of(const Ptr& known) {
  if (!known->unfixed) {
    known->unfixed = unfix_recipe(known->offer.recipe, design_of(known));
  }
  return *known->unfixed;
}

const std::optional<CoverPositions>& KnownDesigns::cover_of(const Ptr& known) {
  if (!known->cover) {
    known->cover = cover_positions(design_of(known));
  }
  return *known->cover;
}

KnownDesigns::Ptr KnownDesigns::smaller(const Ptr& from, std::size_t elements) {
  while (from->smaller.size() < elements && !from->no_smaller) {
    const Ptr last = from->smaller.empty() ? from : from->smaller.back();
    const Recipe& recipe = last->offer.recipe;
    const Design& design = design_of(last);
    if (auto made = close_up_recipe(recipe, design)) {
      from->smaller.push_back(known(offer_of(std::move(made->recipe), made->b), from->news));
    } else if (auto truncated = truncate_recipe(recipe, design)) {
      from->smaller.push_back(known(offer_of(*std::move(truncated), last->offer.b), from->news));
    } else {
      from->no_smaller = true;
    }
  }
  return elements <= from->smaller.size() ? from->smaller[elements - 1] : nullptr;
}

}  // namespace changeover
