#include "curator/weakest.hpp"

#include <algorithm>
#include <set>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

// Change numbers that blowing up connects.
constexpr std::uint64_t most_copies = 3;

// Calls take(q) for the cells for which a design of p gives one, always or usually, without looking
// at its blocks.
template <typename Take>
void each_neighbour(const Parameters& p, Take&& take) {
  if (p.strength != 2) {
    return;
  }
  const auto with = [&](std::uint64_t v, std::uint64_t k, std::uint64_t change) {
    Parameters q = p;
    q.v = v;
    q.k = k;
    q.change = change;
    return q;
  };
  take(p.as(Kind::linear));                // cut
  take(with(p.v + 1, p.k + 1, p.change));  // fix
  take(with(p.v - 1, p.k, p.change));      // truncate
  for (std::uint64_t s = 2; s <= most_copies; ++s) {
    take(with(s * p.v, s * p.k, s * p.change));  // blow up
  }
}

}  // namespace

WeakestFirst::WeakestFirst(const Catalog& catalog, CatalogFilter filter) {
  RunControl* const control = RunScope::current();
  const auto goes_on = [control] { return control == nullptr || !control->stop_wanted(); };
  // Only cells that these can lead to: reading all takes a second.
  CatalogFilter around{.change = filter.change, .strength = filter.strength};
  for (std::uint64_t s = 1; s <= (filter.change ? most_copies : 1); ++s) {
    if (filter.change) {
      around.change = s * *filter.change;
    }
    catalog.each(around, [&](const CatalogEntry& entry) {
      stands_[entry.parameters] = {entry.b, entry.lower_bound};
      return goes_on();
    });
  }
  filter.best_only = true;
  filter.gap = std::max<std::uint64_t>(filter.gap.value_or(1), 1);
  catalog.each(filter, [&](const CatalogEntry& entry) {
    cells_.push_back(entry.parameters);
    stands_[entry.parameters] = {entry.b, entry.lower_bound};
    return goes_on();
  });
}

std::vector<WeakestFirst::Stands::iterator> WeakestFirst::reached_from(const Parameters& p,
                                                                       std::uint64_t b) {
  std::vector<Stands::iterator> reached;
  std::set<Parameters> seen;
  const auto reach = [&](const Parameters& q) {
    const auto stand = stands_.find(q);
    if (stand != stands_.end() && stand->second.lower_bound <= b && b < stand->second.b &&
        seen.insert(q).second) {
      reached.push_back(stand);
    }
  };
  reach(p);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    each_neighbour(Parameters(reached[next]->first), reach);
  }
  return reached;
}

double WeakestFirst::worth(const Parameters& p) {
  const Stand stand = stands_.at(p);
  std::uint64_t gained = 0;
  for (const auto& cell : reached_from(p, stand.b - 1)) {
    gained += cell->second.b - (stand.b - 1);
  }
  const double over =
      static_cast<double>(stand.b - stand.lower_bound) / static_cast<double>(stand.b);
  return over * static_cast<double>(gained);
}

void WeakestFirst::begin_pass() {
  open_ = {};
  for (const Parameters& p : cells_) {
    if (stands_.at(p).b > stands_.at(p).lower_bound) {
      open_.emplace(worth(p), p);
    }
  }
}

std::optional<Parameters> WeakestFirst::next() {
  while (!open_.empty()) {
    const Parameters p = open_.top().second;
    open_.pop();
    if (stands_.at(p).b <= stands_.at(p).lower_bound) {
      continue;
    }
    // Finds since then usually make cells worth less.
    const double today = worth(p);
    if (open_.empty() || today >= open_.top().first) {
      return p;
    }
    open_.emplace(today, p);
  }
  return std::nullopt;
}

void WeakestFirst::improved(const Parameters& p, std::uint64_t b) {
  for (const auto& cell : reached_from(p, b)) {
    cell->second.b = b;
  }
}

}  // namespace changeover
