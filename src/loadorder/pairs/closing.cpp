#include "loadorder/pairs/closing.hpp"

#include <algorithm>
#include <numeric>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "run/portable_math.hpp"

namespace changeover {
namespace {

constexpr std::size_t partners_looked_at = 64;
constexpr std::size_t items_looked_at = 1024;
constexpr std::size_t looked_at_in_a_hurry = 8;
constexpr std::size_t items_in_a_window = 250;

}  // namespace

Closing::Closing(const PairGraph& graph, std::uint64_t room, const std::vector<Element>& order)
    : room_(room), names_(order) {
  const std::size_t n = order.size();
  std::vector<Element> ours(n);
  for (std::size_t i = 0; i < n; ++i) {
    ours[order[i]] = static_cast<Element>(i);
  }
  begin_.resize(n + 1, 0);
  alone_.resize(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    begin_[i + 1] = begin_[i] + graph.partners(order[i]).size();
    alone_[i] = begin_[i + 1] == begin_[i] && graph.is_needed(order[i]);
  }
  partners_.resize(static_cast<std::size_t>(begin_[n]));
  // Every item, in order, is appended to its partners' lists, which are therefore sorted.
  front_.assign(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (const Element y : graph.partners(order[i])) {
      partners_[front_[ours[y]]++] = static_cast<Element>(i);
    }
  }
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0U);
  position_ = order_;
  needed_.resize(n, 0);
  reset();
}

void Closing::reset() {
  const std::size_t n = names_.size();
  for (Element& partner : partners_) {
    partner &= ~met;
  }
  front_.assign(begin_.begin(), begin_.end() - 1);
  open_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    open_[i] = static_cast<std::uint32_t>(begin_[i + 1] - begin_[i]);
  }
  memory_.clear();
  closed_.clear();
  place_.assign(n, 0);
  log_.clear();
  moves_.clear();
  hurrying_ = false;
}

void Closing::take_order(std::vector<Element> order) {
  order_ = std::move(order);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    position_[order_[i]] = static_cast<std::uint32_t>(i);
  }
}

std::uint32_t Closing::needed(Element x) {
  if (needed_[x] == 0) {
    std::uint32_t first = position_[x];
    std::size_t looked = 0;
    const std::size_t most = hurrying_ ? looked_at_in_a_hurry : partners_looked_at;
    for (std::uint64_t i = front_[x]; i < begin_[x + 1] && looked < most; ++i) {
      ++work_;
      if ((partners_[i] & met) == 0) {
        first = std::min(first, position_[partners_[i]]);
        ++looked;
      }
    }
    needed_[x] = first + 1;
  }
  return needed_[x];
}

void Closing::evict(Element x) {
  const std::uint32_t place = place_[x] - 1;
  memory_[place] = memory_.back();
  place_[memory_[place]] = place + 1;
  memory_.pop_back();
  place_[x] = 0;
  went_ = x;
}

void Closing::make_room(Element keep) {
  went_ = LoadMove::nothing;
  if (memory_.size() + closed_.size() < room_) {
    return;
  }
  if (!closed_.empty()) {
    went_ = closed_.back();
    closed_.pop_back();
    place_[went_] = 0;
    return;
  }
  Element last = LoadMove::nothing;
  std::uint32_t when = 0;
  const std::size_t most = hurrying_ ? looked_at_in_a_hurry : items_looked_at;
  const std::size_t count = std::min(memory_.size(), most);
  for (std::size_t i = 0; i < count || last == LoadMove::nothing; ++i) {
    cursor_ = cursor_ + 1 < memory_.size() ? cursor_ + 1 : 0;
    const Element x = memory_[memory_.size() <= most ? i : cursor_];
    if (x != keep) {
      if (const std::uint32_t n = needed(x); n > when) {
        when = n;
        last = x;
      }
    }
  }
  work_ += count;
  evict(last);
}

// At_x is the index of y among the partners of x.
void Closing::meet(Element x, std::uint64_t at_x, Element y) {
  const auto begin = partners_.begin() + static_cast<std::ptrdiff_t>(front_[y]);
  const auto end = partners_.begin() + static_cast<std::ptrdiff_t>(begin_[y + 1]);
  const auto at_y =
      std::lower_bound(begin, end, x, [](Element a, Element b) { return (a & ~met) < b; });
  partners_[at_x] |= met;
  *at_y |= met;
  if (needed_[y] == position_[x] + 1 || needed_[y] == position_[y] + 1) {
    needed_[y] = 0;
  }
  --open_[x];
  if (--open_[y] == 0) {
    const std::uint32_t place = place_[y] - 1;
    memory_[place] = memory_.back();
    place_[memory_[place]] = place + 1;
    memory_.pop_back();
    closed_.push_back(y);
  }
  if (trying_) {
    log_.push_back({at_x, static_cast<std::uint64_t>(at_y - partners_.begin()), x, y});
  } else {
    while (front_[y] < begin_[y + 1] && (partners_[front_[y]] & met) != 0) {
      ++front_[y];
    }
  }
}

void Closing::load(Element x) {
  work_ += begin_[x + 1] - front_[x];
  for (std::uint64_t i = front_[x]; i < begin_[x + 1]; ++i) {
    const Element y = partners_[i];
    if ((y & met) == 0 && place_[y] != 0) {
      meet(x, i, y);
    }
  }
  needed_[x] = 0;
  if (open_[x] == 0) {
    closed_.push_back(x);
    place_[x] = LoadMove::nothing;  // in memory; the place is not needed any more
  } else {
    memory_.push_back(x);
    place_[x] = static_cast<std::uint32_t>(memory_.size());
  }
  if (!trying_) {
    while (front_[x] < begin_[x + 1] && (partners_[front_[x]] & met) != 0) {
      ++front_[x];
    }
    moves_.push_back({names_[x], went_ == LoadMove::nothing ? went_ : names_[went_]});
  }
}

std::uint64_t Closing::close(Element x, std::uint64_t limit) {
  std::uint64_t loads = 0;
  if (alone_[x] && !trying_) {
    make_room(LoadMove::nothing);
    load(x);
    return 1;
  }
  if (open_[x] == 0) {
    return 0;
  }
  if (place_[x] == 0) {
    make_room(LoadMove::nothing);
    load(x);
    ++loads;
  }
  missing_.clear();
  work_ += begin_[x + 1] - front_[x];
  for (std::uint64_t i = front_[x]; i < begin_[x + 1]; ++i) {
    if ((partners_[i] & met) == 0) {
      missing_.push_back(partners_[i]);
    }
  }
  // Items that are needed for this pair only pass first.
  std::stable_partition(missing_.begin(), missing_.end(), [&](Element y) { return open_[y] == 1; });
  work_ += missing_.size();
  for (std::size_t i = 0; i < missing_.size() && loads <= limit; ++i) {
    make_room(x);
    load(missing_[i]);
    ++loads;
  }
  return loads;
}

std::uint64_t Closing::run(std::uint64_t limit, const std::function<bool()>& in_a_hurry) {
  reset();
  trying_ = false;
  const std::uint64_t start = work_;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    close(order_[i], no_limit);
    if (moves_.size() > limit) {
      return moves_.size();
    }
    if (in_a_hurry && !hurrying_ && in_a_hurry()) {
      if (limit != no_limit) {
        return limit + 1;
      }
      hurrying_ = true;
    }
    if (progress_due()) {
      report_progress({.phase = "closing items", .steps = i, .unit = "items"});
    }
  }
  work_of_run_ = work_ - start;
  return moves_.size();
}

void Closing::take_back(const Memory& before) {
  work_ += 2 * log_.size() + memory_.size() + before.items.size();
  for (const Met& pair : log_) {
    partners_[pair.at_x] &= ~met;
    partners_[pair.at_y] &= ~met;
    ++open_[pair.x];
    ++open_[pair.y];
  }
  log_.clear();
  for (const Element x : memory_) {
    place_[x] = 0;
  }
  for (const Element x : closed_) {
    place_[x] = 0;
  }
  memory_ = before.items;
  closed_ = before.closed;
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    place_[memory_[i]] = static_cast<std::uint32_t>(i + 1);
  }
  for (const Element x : closed_) {
    place_[x] = LoadMove::nothing;
  }
}

std::uint64_t Closing::trial(const Window& window, std::uint64_t limit) {
  for (const Element x : memory_) {
    needed_[x] = 0;
  }
  std::uint64_t loads = 0;
  trying_ = true;
  for (std::size_t i = window.begin; i < window.sight && loads <= limit; ++i) {
    ++work_;  // an item that is closed already takes a step, too
    loads += close(order_[i], limit - loads);
  }
  trying_ = false;
  return loads;
}

void Closing::anneal(const Window& window, std::uint64_t work, Random& random,
                     const std::function<bool()>& stop_wanted) {
  const Memory before{memory_, closed_};
  const auto size = static_cast<std::uint32_t>(window.end - window.begin);
  if (size < 3) {
    return;
  }
  const std::uint64_t start = work_;
  std::uint64_t now = trial(window, no_limit);
  take_back(before);
  if (now == 0) {
    return;  // all of it is closed
  }
  std::uint64_t best = now;
  std::vector<Element> best_order(order_.begin() + static_cast<std::ptrdiff_t>(window.begin),
                                  order_.begin() + static_cast<std::ptrdiff_t>(window.end));
  const auto renumber = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      position_[order_[i]] = static_cast<std::uint32_t>(i);
    }
  };
  while (work_ - start < work && !stop_wanted()) {
    // Moves a run of items elsewhere in the window, or near a partner of its first item.
    const std::uint32_t length =
        1 + (random.one_in_two() ? 0 : random.below(std::min(8U, size / 2)));
    std::size_t from = window.begin + random.below(size - length + 1);
    std::size_t to = window.begin + random.below(size - length + 1);
    const Element x = order_[from];
    const std::uint64_t degree = begin_[x + 1] - begin_[x];
    if (degree > 0 && random.below(4) != 0) {
      const Element y =
          partners_[begin_[x] + random.below(static_cast<std::uint32_t>(degree))] & ~met;
      const std::size_t near = position_[y] + random.below(7);
      if (near >= window.begin + 3 && near - 3 + length <= window.end) {
        to = near - 3;
      }
    }
    if (from == to) {
      work_ += 1;
      continue;
    }
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto move = [&](std::size_t a, std::size_t b) {
      work_ += std::max(a, b) - std::min(a, b) + length;
      if (a < b) {
        std::rotate(at(a), at(a + length), at(b + length));
      } else {
        std::rotate(at(b), at(a), at(a + length));
      }
      renumber(std::min(a, b), std::max(a, b) + length);
    };
    move(from, to);
    const double spent = static_cast<double>(work_ - start) / static_cast<double>(work);
    const double heat = 0.7 * (1 - spent) + 0.05;
    const double u = (static_cast<double>(random.next32()) + 1) / 4294967296.0;
    const std::uint64_t limit = now + static_cast<std::uint64_t>(-heat * natural_log(u));
    const std::uint64_t loads = trial(window, limit);
    take_back(before);
    if (loads <= limit) {
      now = loads;
      if (now < best) {
        best = now;
        std::copy(at(window.begin), at(window.end), best_order.begin());
      }
    } else {
      move(to, from);
    }
  }
  std::ranges::copy(best_order, order_.begin() + static_cast<std::ptrdiff_t>(window.begin));
  renumber(window.begin, window.end);
  for (const Element x : memory_) {
    needed_[x] = 0;
  }
}

void Closing::improve(std::uint64_t work, Random& random, const std::function<bool()>& stop_wanted,
                      const std::function<void()>& looked) {
  const std::size_t n = order_.size();
  const std::size_t size = std::min(n, items_in_a_window);
  const std::size_t step = size == n ? n : size / 2;
  constexpr std::size_t times_looked = 8;
  const std::uint64_t windows = size == n ? 1 : (n - size) / step + 2;
  reset();
  const std::size_t often = ceil_div(ceil_div(n, step), times_looked);
  std::size_t window = 0;
  for (std::size_t begin = 0; begin < n && !stop_wanted(); begin += step) {
    const std::size_t end = std::min(n, begin + size);
    anneal({begin, end, std::min(n, end + size / 4)}, work / windows, random, stop_wanted);
    for (std::size_t i = begin; i < std::min(n, begin + step); ++i) {
      close(order_[i], no_limit);
    }
    if ((++window % often == 0 || begin + step >= n) && !stop_wanted()) {
      looked();
    }
  }
}

std::vector<LoadMove> one_by_one(const LoadOrder& order) {
  std::vector<LoadMove> moves;
  const auto steps = order.stream();
  for (Step step; steps->next(step);) {
    for (std::size_t i = 0; i < step.load.size(); ++i) {
      moves.push_back({step.load[i], i < step.evict.size() ? step.evict[i] : LoadMove::nothing});
    }
  }
  return moves;
}

}  // namespace changeover
