// Concatenation with groups: which designs are worth trying, and those that are made.
//
// What comes of a design depends on its blocks, too, not only on how many there are: on how many
// disjoint unchanged subsets it has. So some designs with a few blocks more are kept as well, if
// they have more of these.
#include <algorithm>
#include <tuple>
#include <utility>

#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/run/control.hpp"
#include "construct/known_designs.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_over = 4;       // the best that is known without
constexpr std::size_t most_built = 10;       // for one cell
constexpr std::uint64_t most_repeated = 12;  // parts with a class that another has, too
constexpr std::uint64_t most_in_hole = 24;   // beside the hinge

// What carries its blocks is named by its label.
Recipe recipe_in_catalog(CatalogEntry entry) {
  if (!entry.carries_blocks()) {
    return std::move(entry.recipe);
  }
  Recipe recipe{"found", entry.parameters, {}, {}, {}};
  recipe.provenance = entry.label();
  return recipe;
}

}  // namespace

struct KnownDesigns::GroupCandidate {
  std::uint64_t b;
  std::size_t repeated;
  Ptr base, closed, open;
  Grouping how;

  [[nodiscard]] auto order() const {
    return std::tuple(b, repeated, base->offer.recipe.parameters, how.groups.groups,
                      open == nullptr, how.hinge.at);
  }
};

const std::vector<Hinge>& KnownDesigns::hinges_of(const Ptr& known) {
  if (!known->hinges) {
    known->hinges = hinges(design_of(known));
  }
  return *known->hinges;
}

const std::vector<KnownDesigns::Ptr>& KnownDesigns::bases_at(const Parameters& p) {
  if (const auto found = bases_.find(p); found != bases_.end()) {
    return found->second;
  }
  std::vector<Ptr> bases;
  if (const Ptr best = at(p, 2, false)) {
    bases.push_back(best);
  }
  const std::vector<Ptr>& made = with_groups_at(p);
  bases.insert(bases.end(), made.begin(), made.end());
  if (registry_.catalog() != nullptr && !bases.empty()) {
    const std::uint64_t most = bases.front()->offer.b + most_over;
    for (CatalogEntry& each : registry_.catalog()->cell(p)) {
      if (each.retracted.empty() && each.b <= most) {
        const std::uint64_t b = each.b;
        Ptr one = known({recipe_in_catalog(std::move(each)), b, false, false, false}, false);
        if (one->depth < deepest_chain) {
          bases.push_back(std::move(one));
        }
      }
    }
  }
  std::ranges::stable_sort(bases, {}, [](const Ptr& each) { return each->offer.b; });
  // Not those with no more parts than one with no more blocks.
  const auto parts = [this](const Ptr& each, bool at_end) {
    std::size_t most = 0;
    for (const Hinge& hinge : hinges_of(each)) {
      if ((hinge.at == each->offer.b) == at_end) {
        most = std::max(most, hinge.positions.size() + 1);
      }
    }
    return most;
  };
  std::vector<Ptr> kept;
  for (const Ptr& each : bases) {
    if (std::ranges::none_of(kept, [&](const Ptr& better) {
          return parts(better, false) >= parts(each, false) &&
                 parts(better, true) >= parts(each, true);
        })) {
      kept.push_back(each);
    }
  }
  return bases_.emplace(p, std::move(kept)).first->second;
}

void KnownDesigns::add_candidates(const Parameters& p, const Ptr& base, const Groups& groups,
                                  std::uint64_t fewer_than, std::vector<GroupCandidate>& found) {
  const Parameters& w = base->offer.recipe.parameters;
  const std::uint64_t n = p.k - p.change;
  const std::uint64_t classes = class_count(groups, p.change);
  const std::uint64_t a_class = groups.groups * groups.size / p.change;
  const auto piece = [&](Kind kind, std::uint64_t h) {
    const Parameters q = p.as(kind).on(groups.size + h);
    return possible(q) ? at(q, 2, false) : nullptr;
  };
  for (const Hinge& hinge : hinges_of(base)) {
    const std::uint64_t most =
        std::min<std::uint64_t>(hinge.positions.size(), classes + most_repeated);
    for (std::uint64_t parts = classes; parts <= most; ++parts) {
      const std::uint64_t h = w.v - n * parts;
      if (h > n + most_in_hole) {
        continue;
      }
      const Ptr closed = groups.size + h == p.k ? nullptr : piece(Kind::circular, h);
      const bool comes_back =
          p.kind == Kind::circular || (w.kind == Kind::linear && hinge.at != base->offer.b);
      for (const bool ends_open : {false, true}) {
        if (ends_open && comes_back) {
          continue;
        }
        const Ptr open = ends_open ? piece(Kind::linear, h) : nullptr;
        if (ends_open && !open) {
          continue;
        }
        GroupCandidate one{
            0, static_cast<std::size_t>(parts - classes), base, closed, open, {groups, hinge, 0}};
        one.how.hinge.positions.resize(static_cast<std::size_t>(parts));
        const auto count = [&](const Ptr& known) {
          return known ? std::optional(known->offer.b) : std::nullopt;
        };
        for (const bool dropping : {false, true}) {
          const std::uint64_t rings = groups.groups - (ends_open ? 1 : 0);
          one.how.dropped = !dropping ? 0 : comes_back ? rings - rings % 2 : rings;
          const auto more = piece_blocks(p, one.how, h, count(closed), count(open), ends_open);
          if (more) {
            one.b = base->offer.b + parts * a_class + *more;
            if (one.b < fewer_than) {
              found.push_back(one);
            }
          }
        }
      }
    }
  }
}

void KnownDesigns::add_candidates(const Parameters& p, const Parameters& w,
                                  std::uint64_t fewer_than, std::vector<GroupCandidate>& found) {
  const std::uint64_t added = p.v - w.v;
  // The first block of a piece has m elements of its group.
  for (std::uint64_t groups = 2; groups * p.change <= added; ++groups) {
    if (added % groups != 0) {
      continue;
    }
    const Groups each{groups, added / groups};
    const std::uint64_t classes = class_count(each, p.change);
    if (classes == 0 || classes * (p.k - p.change) > w.v - (p.k - p.change) ||
        bound(w).blocks + classes * added / p.change >= fewer_than) {
      continue;
    }
    for (const Ptr& base : bases_at(w)) {
      if (base->offer.b + classes * added / p.change < fewer_than) {
        add_candidates(p, base, each, fewer_than, found);
      }
    }
  }
}

KnownDesigns::Ptr KnownDesigns::built(const Parameters& p, const GroupCandidate& candidate) {
  const std::uint64_t h = candidate.base->offer.recipe.parameters.v -
                          candidate.how.hinge.positions.size() * (p.k - p.change);
  const std::uint64_t less = most_dropped(h, p);
  const auto fits = [&](const Ptr& known, std::uint64_t dropped) {
    return opened(design_of(known), h, dropped).has_value();
  };
  const std::uint64_t rings = candidate.how.groups.groups - (candidate.open ? 1 : 0);
  if ((candidate.how.dropped > 0 && !fits(candidate.closed, less)) ||
      (candidate.closed && candidate.how.dropped < rings && !fits(candidate.closed, 0)) ||
      (candidate.open && !fits(candidate.open, less))) {
    return nullptr;
  }
  const auto recipe_of = [](const Ptr& known) {
    return known ? std::optional(known->offer.recipe) : std::nullopt;
  };
  Offer offer{concatenate_groups_recipe(p, candidate.how, candidate.base->offer.recipe,
                                        recipe_of(candidate.closed), recipe_of(candidate.open)),
              candidate.b, false, false, false};
  Ptr made = known(std::move(offer), false);
  if (made->depth >= deepest_chain) {
    return nullptr;
  }
  static_cast<void>(design_of(made));  // It keeps its promise.
  return made;
}

const std::vector<KnownDesigns::Ptr>& KnownDesigns::with_groups_at(const Parameters& p) {
  if (const auto found = with_groups_.find(p); found != with_groups_.end()) {
    return found->second;
  }
  stop_if_asked();
  std::vector<GroupCandidate> candidates;
  const Ptr without = at(p, 1, false);
  for (std::uint64_t w = p.k + 1; without && p.change >= 2 && w + 2 <= p.v; ++w) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Parameters q = p.as(kind).on(w);
      if ((p.kind == Kind::linear || kind == Kind::circular) && possible(q)) {
        add_candidates(p, q, without->offer.b + most_over, candidates);
      }
    }
  }
  std::ranges::stable_sort(candidates, {}, &GroupCandidate::order);
  std::vector<Ptr> made;
  for (const GroupCandidate& each : candidates) {
    if (made.size() == most_built ||
        (!made.empty() && each.b > made.front()->offer.b + most_over)) {
      break;
    }
    if (Ptr one = built(p, each)) {
      made.push_back(std::move(one));
    }
  }
  return with_groups_.emplace(p, std::move(made)).first->second;
}

}  // namespace changeover
