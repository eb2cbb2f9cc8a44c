// Completes lists and removes what is not needed.
#include <algorithm>
#include <optional>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "plan/search/lists/lists_search.hpp"

namespace changeover {
namespace {

// The set-up of a bench closest to `beside` that contains the target; nullopt if none is found.
std::optional<Block> around(const Lists& lists, std::size_t bench, std::span<const Element> beside,
                            std::span<const Element> target) {
  if (lists.of_model()) {
    return lists.values(bench).around(beside, target);
  }
  const Job& job = lists.job(bench);
  Block setup = job.mounted;
  for (const Element x : target) {
    if (!contains(setup, x)) {
      if (!lists.joins(setup, x)) {  // a permanently mounted part of this bench excludes it
        return std::nullopt;
      }
      setup.push_back(x);
    }
  }
  auto whole = lists.fitting(bench).grown(
      std::move(setup), beside,
      [&](const Block& others, Element z) { return lists.joins(others, z); });
  return whole && whole->size() <= job.room() ? whole : std::nullopt;
}

}  // namespace

bool complete(Lists& lists, RunControl& control) {
  constexpr std::size_t looked_at = 64;
  while (lists.open() > 0) {
    if (control.stop_wanted()) {
      return false;
    }
    const auto found = lists.open_target(0);
    const std::span<const Element> target(found.data(), lists.of_triples() ? 3 : 2);
    const std::size_t stride = lists.tests() / looked_at + 1;
    double best = -1;
    Spot place;
    Block chosen;
    const auto consider = [&](Spot where, std::span<const Element> beside) {
      const auto setup = around(lists, where.bench, beside, target);
      if (!setup) {
        return;
      }
      const std::uint64_t missing = lists.missing();
      const std::int64_t cost = lists.total();
      const std::int64_t largest = lists.largest();
      lists.insert(where, *setup);
      const double gain = static_cast<double>(missing - lists.missing());
      // Negative if going by way of another set-up is cheaper.
      const auto rise = static_cast<double>(lists.total() - cost + lists.largest() - largest);
      const double worth = gain / (std::max(rise, 0.0) + 1.0);
      lists.undo();
      if (worth > best) {
        best = worth;
        place = where;
        chosen = *setup;
      }
    };
    for (std::size_t bench = 0; bench < lists.benches(); ++bench) {
      consider({bench, 0}, lists.job(bench).start);
    }
    for (std::size_t i = 0; i < lists.tests(); i += stride) {
      Spot where = lists.spot(i);
      const auto there = lists.setup(where);
      const Block beside(there.begin(), there.end());
      ++where.at;
      consider(where, beside);
    }
    if (chosen.empty()) {
      throw InternalError("what has to meet has no set-up");
    }
    lists.insert(place, chosen);
    lists.keep();
  }
  return true;
}

void prune(Lists& lists, RunControl& control) {
  const auto no_worse = [&](auto&& change) {
    const bool whole = lists.open() == 0;  // what weighs nothing has to meet, too
    const std::uint64_t missing = lists.missing();
    const std::int64_t total = lists.total();
    const std::int64_t largest = lists.largest();
    change();
    const bool good = (!whole || lists.open() == 0) && lists.missing() <= missing &&
                      lists.total() <= total && lists.largest() <= largest;
    good ? lists.keep() : lists.undo();
    return good;
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = lists.tests(); i-- > 0;) {
      if (control.stop_wanted()) {
        return;
      }
      again = no_worse([&] { lists.take_out(lists.spot(i)); }) || again;
    }
    for (std::size_t bench = 0; bench < lists.benches(); ++bench) {
      for (const Element x : lists.movable()) {
        if (control.stop_wanted()) {
          return;
        }
        if (!lists.is_movable(bench, x)) {
          continue;
        }
        for (std::size_t at = 0; at < lists.tests(bench); ++at) {
          bool spare = true;
          std::size_t last = at;
          for (; last < lists.tests(bench) && lists.holds({bench, last}, x); ++last) {
            spare = spare && lists.may_replace({bench, last}, x, no_part);
          }
          if (last > at && spare) {
            again = no_worse([&] {
                      for (std::size_t i = at; i < last; ++i) {
                        lists.replace({bench, i}, x, no_part);
                      }
                    }) ||
                    again;
          }
          at = std::max(at, last);
        }
      }
    }
  }
}

}  // namespace changeover
