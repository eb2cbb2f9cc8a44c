#include "plan/search/bounds/exchange_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/step_program.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_exchanges = 3600;
constexpr std::uint64_t largest_cost = std::uint64_t{1} << 50U;

// A set of parts that is entered at least once, and what that is worth.
struct Entry {
  std::vector<bool> has;  // by part
  std::int64_t price = 0;
};

// The prices of the theorem: w, z, and what follows of them.
class ExchangeProof {
 public:
  // `out` by part: a proposal for w; of what is not proposed, -1.
  ExchangeProof(const Job& job, std::vector<std::int64_t> out, std::vector<Entry> entries)
      : job_(&job), out_(std::move(out)), entries_(std::move(entries)), is_mounted_(job.parts()) {
    for (const Element m : job.mounted) {
      is_mounted_[m] = true;
    }
    const auto too_costly = [&] {
      return std::any_of(in_.begin(), in_.end(), [](std::int64_t cost) { return cost < 0; });
    };
    const std::vector<std::int64_t> proposed = out_;
    settle();
    if (too_costly()) {
      entries_.clear();
      out_ = proposed;
      settle();
    }
  }

  // The job at the prices π.
  [[nodiscard]] Job priced() const {
    Job plain = *job_;
    plain.replace_costs.clear();
    for (Element x = 0; x < job_->parts(); ++x) {
      plain.change_costs[x] = Amount{static_cast<std::uint64_t>(in_[x] - out_[x])};
    }
    return plain;
  }

  // What a list costs more than at these prices, if `room` parts are once together.
  [[nodiscard]] std::int64_t more(std::uint64_t room) const {
    std::int64_t sum = 0;
    for (const Entry& entry : entries_) {
      sum += entry.price;
    }
    std::vector<std::uint64_t> there(job_->slots.size() + 1, 0);
    for (const Element x : job_->start) {
      sum -= out_[x];
      ++there[place_of(x)];
    }
    if (job_->slots.empty()) {
      return sum + static_cast<std::int64_t>(room - std::min(room, there[0])) * empty(0);
    }
    for (std::size_t s = 0; s < job_->slots.size(); ++s) {
      const std::uint64_t least = job_->slots[s].least;
      sum += least > there[s] ? static_cast<std::int64_t>(least - there[s]) * empty(s) : 0;
    }
    return sum;
  }

 private:
  [[nodiscard]] std::size_t place_of(Element x) const {
    return job_->slots.empty() || job_->slot_of[x] == no_slot ? job_->slots.size()
                                                              : job_->slot_of[x];
  }

  // A change, less what the sets are worth that it enters.
  [[nodiscard]] std::int64_t to_empty(Element in) const {
    auto cost = static_cast<std::int64_t>(job_->change_costs[in].millionths);
    for (const Entry& entry : entries_) {
      cost -= entry.has[in] ? entry.price : 0;
    }
    return cost;
  }
  [[nodiscard]] std::int64_t exchanged(Element out, Element in) const {
    auto cost = static_cast<std::int64_t>(job_->replace_cost(out, in).millionths);
    for (const Entry& entry : entries_) {
      cost -= entry.has[in] && !entry.has[out] ? entry.price : 0;
    }
    return cost;
  }

  // u of these w; where it is less than w, w becomes less, until all π are at least 0. Then all w
  // of a slot become less by the least of them.
  void settle() {
    const std::size_t v = job_->parts();
    std::vector<std::int64_t> costs(v * v, 0);
    std::vector<std::int64_t> empty(v, 0);
    for (Element x = 0; x < v; ++x) {
      empty[x] = to_empty(x);
      out_[x] = is_mounted_[x] ? 0 : out_[x] < 0 ? std::max<std::int64_t>(0, empty[x]) : out_[x];
      for (Element y = 0; y < v; ++y) {
        costs[x * v + y] = exchanged(x, y);
      }
    }
    const auto cheapest = [&](Element in) {
      std::int64_t least = empty[in];
      for (Element x = 0; x < v; ++x) {
        if (x != in && !is_mounted_[x] && job_->may_replace(x, in)) {
          least = std::min(least, costs[x * v + in] + out_[x]);
        }
      }
      return least;
    };
    in_.assign(v, 0);
    for (bool again = true; again;) {
      again = false;
      for (Element x = 0; x < v; ++x) {
        in_[x] = cheapest(x);
        if (in_[x] < 0) {
          return;
        }
        if (in_[x] < out_[x]) {
          out_[x] = in_[x];
          again = true;
        }
      }
    }
    std::vector<std::int64_t> least(job_->slots.size() + 1,
                                    std::numeric_limits<std::int64_t>::max());
    for (Element x = 0; x < v; ++x) {
      least[place_of(x)] =
          is_mounted_[x] ? least[place_of(x)] : std::min(least[place_of(x)], out_[x]);
    }
    for (Element x = 0; x < v; ++x) {
      out_[x] -= is_mounted_[x] ? 0 : least[place_of(x)];
    }
    for (Element x = 0; x < v; ++x) {
      in_[x] = cheapest(x);
    }
  }

  // What an empty place costs more than u, where it is least so.
  [[nodiscard]] std::int64_t empty(std::size_t place) const {
    std::optional<std::int64_t> least;
    for (Element x = 0; x < job_->parts(); ++x) {
      if (place_of(x) == place) {
        const std::int64_t more = to_empty(x) - in_[x];
        least = std::min(least.value_or(more), more);
      }
    }
    return least.value_or(0);
  }

  const Job* job_;
  std::vector<std::int64_t> out_;  // w
  std::vector<std::int64_t> in_;   // u
  std::vector<Entry> entries_;
  std::vector<bool> is_mounted_;
};

// What the program proposes, as whole numbers: entries are worth a little less, since sets that
// cross have to be worth no more than what enters them.
ExchangeProof proof_of(const Job& job, const JobNumbers& n, const ExchangePrices& prices) {
  constexpr double rounding = 1e-7;
  std::vector<std::int64_t> out(job.parts(), -1);
  for (std::size_t x = 0; x < prices.out.size(); ++x) {
    out[n.parts[x]] = static_cast<std::int64_t>(std::ceil(prices.out[x]));
  }
  std::vector<Entry> entries;
  for (const ExchangePrices::Entry& proposed : prices.entries) {
    const double price = proposed.price * (1 - rounding) - 1;
    if (price >= 1) {
      Entry entry{std::vector<bool>(job.parts()), static_cast<std::int64_t>(price)};
      for (std::size_t x = 0; x < proposed.parts.size(); ++x) {
        entry.has[n.parts[x]] = proposed.parts[x];
      }
      entries.push_back(std::move(entry));
    }
  }
  return ExchangeProof(job, std::move(out), std::move(entries));
}

// A lower bound on the cost of all lists, by how many parts are together at most.
CostBound at_these_prices(const Job& job, const ExchangeProof& proof) {
  Job priced = proof.priced();
  const std::uint64_t fewest = job.slots.empty() ? job.mounted.size() + 2 : job.room();
  std::optional<CostBound> best;
  for (std::uint64_t room = job.room();; --room) {
    priced.at_once = room;
    CostBound bound = bound_of_valid_job(priced);
    const auto with = [&](std::uint64_t together) {
      const std::int64_t more = proof.more(together);
      const auto cost = static_cast<std::int64_t>(bound.cost.millionths) + more;
      return Amount{static_cast<std::uint64_t>(std::max<std::int64_t>(0, cost))};
    };
    const Amount with_fewest = with(fewest);
    bound.cost = with(room);
    if (!best || bound.cost < best->cost) {
      best = bound;
    }
    if (room <= fewest || with_fewest >= best->cost) {
      return *best;
    }
  }
}

bool is_too_large(const Job& job) {
  const auto large = [](Amount cost) { return cost.millionths > largest_cost; };
  return large(job.test_cost) ||
         std::any_of(job.change_costs.begin(), job.change_costs.end(), large) ||
         std::any_of(job.replace_costs.begin(), job.replace_costs.end(), large);
}

}  // namespace

void raise_by_exchanges(const Job& job, CostBound& bound) {
  const Job least = at_prices(job, Price::least);
  Amount mounting;
  const std::optional<CostliestParts> parts = costliest_parts_of(least, mounting);
  if (!parts || is_too_large(job)) {
    return;
  }
  const JobNumbers n = numbers_of(least);
  std::vector<Exchange> exchanges;
  for (std::size_t x = 0; x < n.parts.size(); ++x) {
    for (std::size_t y = 0; y < n.parts.size(); ++y) {
      if (x != y && job.may_replace(n.parts[x], n.parts[y])) {
        exchanges.push_back({x, y});
      }
    }
  }
  if (exchanges.empty() || exchanges.size() > most_exchanges) {
    return;
  }
  StepProgram program(job, n, *parts, bound.tests, std::move(exchanges));
  program.solve();
  const CostBound found = at_these_prices(job, proof_of(job, n, program.exchange_prices()));
  const Amount cost = rounded_up(job, found.cost);
  if (cost > bound.cost) {
    bound.cost = cost;
    const bool model = job.model != nullptr;
    bound.reason = fmt::format(
        "each {} takes the place of another, and none is replaced more often than it is {}: {}",
        model ? "value that is set" : "part that is put in", model ? "set" : "put in",
        found.reason);
  }
}

}  // namespace changeover
