#include "plan/search/exact_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <queue>
#include <utility>

#include "changeover/plan/model.hpp"
#include "core/bit_number.hpp"
#include "core/words.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/choices/choice_lists.hpp"
#include "plan/search/listener.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_small_parts = 12;
constexpr std::uint64_t most_small_pairs = 64;
constexpr std::uint64_t endless = all_of_them / 4;

using Mask = std::uint64_t;   // of needed pairs
using Parts = std::uint16_t;  // of relevant parts
using Labels = std::array<std::uint8_t, most_small_parts>;

// Parts that can be useful: with a needed pair, mounted, or of a slot that must not be empty.
std::vector<Element> useful_parts(const Job& job) {
  std::vector<bool> useful(job.names.size());
  job.needed.for_each(all_of_them, [&](Element x, Element y) { useful[x] = useful[y] = true; });
  for (const Element m : job.mounted) {
    useful[m] = true;
  }
  for (Element x = 0; x < job.slot_of.size(); ++x) {
    useful[x] = useful[x] || (job.slot_of[x] != no_slot && job.slots[job.slot_of[x]].least > 0);
  }
  std::vector<Element> parts;
  for (Element x = 0; x < job.parts(); ++x) {
    if (useful[x]) {
      parts.push_back(x);
    }
  }
  return parts;
}

struct Node {
  Mask met = 0;
  std::uint64_t cost = 0;
  std::uint32_t parent = 0;
  Parts setup = 0;
  Parts as_chosen = 0;  // the set-up in the labels of the parent
  Labels label{};       // by label of the parent
};

struct State {
  Mask met = 0;
  Parts setup = 0;
};

std::size_t state_hash(const State& state) {
  std::uint64_t h = state.met * 0x9e3779b97f4a7c15ULL ^ std::uint64_t{state.setup} << 40;
  h = (h ^ h >> 29) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<std::size_t>(h ^ h >> 32);
}

class Exact {
 public:
  Exact(const Job& job, std::uint64_t below, RunControl& control)
      : job_(&job), below_(below), listener_(control), parts_(useful_parts(job)) {
    if (job.model != nullptr) {
      choices_.emplace(job);
    }
    for (const Element x : parts_) {
      price_.push_back(job.change_costs[x].millionths);
    }
    std::uint64_t unit = job.test_cost.millionths;
    for (const std::uint64_t price : price_) {
      unit = std::gcd(unit, price);
    }
    unit_ = std::max<std::uint64_t>(1, unit);
    by_price_.resize(parts_.size());
    std::iota(by_price_.begin(), by_price_.end(), std::size_t{0});
    std::stable_sort(by_price_.begin(), by_price_.end(),
                     [&](std::size_t a, std::size_t b) { return price_[a] < price_[b]; });
    pair_.assign(parts_.size() * parts_.size(), -1);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (job.needed.contains(parts_[i], parts_[j])) {
          pair_[i * parts_.size() + j] = pair_[j * parts_.size() + i] =
              static_cast<int>(ends_.size());
          ends_.push_back({i, j});
        }
      }
    }
    whole_ = ends_.size() == most_small_pairs ? ~Mask{0} : (Mask{1} << ends_.size()) - 1;
    find_setups();
    find_classes();
    find_introductions();
  }

  ExactPlan run(std::uint64_t most_states) {
    Parts bench = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      bench |=
          static_cast<Parts>(std::count(job_->start.begin(), job_->start.end(), parts_[i]) << i);
    }
    nodes_.push_back({.setup = bench});
    std::iota(nodes_[0].label.begin(), nodes_[0].label.end(), std::uint8_t{0});
    expand(0);
    std::uint64_t bound = below_;
    while (!open_.empty()) {
      const Open next = open_.top();
      if (nodes_.size() > most_states || listener_.stop_wanted(20 * setups_.size())) {
        bound = next.least;
        break;
      }
      open_.pop();
      if (next.cost != nodes_[next.node].cost) {
        continue;  // reached at a lower cost since
      }
      if (nodes_[next.node].met == whole_) {
        return {list_to(next.node), Amount{next.cost}, nodes_.size()};
      }
      expand(next.node);
    }
    return {std::nullopt, Amount{bound}, nodes_.size()};
  }

 private:
  struct Open {
    std::uint64_t least = 0;  // for a list through this node
    std::uint64_t cost = 0;
    std::uint32_t node = 0;

    bool operator<(const Open& other) const {
      return least != other.least ? least > other.least : cost < other.cost;
    }
  };

  [[nodiscard]] static std::uint64_t size_of(Parts setup) { return number_of_bits(setup); }

  [[nodiscard]] Mask pairs_of(Parts setup) const {
    Mask pairs = 0;
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if ((setup >> ends_[e][0] & 1) != 0 && (setup >> ends_[e][1] & 1) != 0) {
        pairs |= Mask{1} << e;
      }
    }
    return pairs;
  }

  void find_setups() {
    Parts mounted = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      mounted |= static_cast<Parts>(
          std::count(job_->mounted.begin(), job_->mounted.end(), parts_[i]) << i);
    }
    const bool free = job_->never.size() == 0 && job_->slots.empty();
    const std::uint64_t full = std::min<std::uint64_t>(job_->room(), parts_.size());
    for (std::uint32_t bits = 1; bits < std::uint32_t{1} << parts_.size(); ++bits) {
      const auto setup = static_cast<Parts>(bits);
      const bool fits = free ? size_of(setup) == full : size_of(setup) <= full;
      if (!fits || (setup & mounted) != mounted || pairs_of(setup) == 0 || !allowed(setup)) {
        continue;
      }
      setups_.push_back(setup);
      met_.push_back(pairs_of(setup));
    }
  }

  [[nodiscard]] bool allowed(Parts setup) const {
    std::vector<std::uint64_t> count(job_->slots.size(), 0);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if ((setup >> i & 1) == 0) {
        continue;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if ((setup >> j & 1) != 0 && job_->never.contains(parts_[i], parts_[j])) {
          return false;
        }
      }
      if (!job_->slot_of.empty() && job_->slot_of[parts_[i]] != no_slot) {
        ++count[job_->slot_of[parts_[i]]];
      }
    }
    for (std::size_t s = 0; s < count.size(); ++s) {
      if (count[s] < job_->slots[s].least || count[s] > job_->slots[s].most) {
        return false;
      }
    }
    if (!choices_) {
      return true;
    }
    Block row(count.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if ((setup >> i & 1) != 0) {
        row[job_->slot_of[parts_[i]]] = parts_[i];
      }
    }
    return choices_->allows(row);
  }

  // Classes of interchangeable parts, ignoring the start, which only the first step uses.
  void find_classes() {
    const bool has_rules =
        job_->model != nullptr && (!job_->model->constraints.empty() || !job_->barred.empty());
    const auto alike = [&](std::size_t i, std::size_t j) {
      if (has_rules) {
        return false;
      }
      const auto is_mounted = [&](std::size_t a) {
        return std::count(job_->mounted.begin(), job_->mounted.end(), parts_[a]) != 0;
      };
      if (price_[i] != price_[j] || is_mounted(i) != is_mounted(j) ||
          (!job_->slot_of.empty() && job_->slot_of[parts_[i]] != job_->slot_of[parts_[j]])) {
        return false;
      }
      for (std::size_t z = 0; z < parts_.size(); ++z) {
        if (z != i && z != j &&
            ((pair_[i * parts_.size() + z] < 0) != (pair_[j * parts_.size() + z] < 0) ||
             job_->never.contains(parts_[i], parts_[z]) !=
                 job_->never.contains(parts_[j], parts_[z]))) {
          return false;
        }
      }
      return true;
    };
    std::vector<bool> placed(parts_.size(), false);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (placed[i]) {
        continue;
      }
      classes_.emplace_back();
      for (std::size_t j = i; j < parts_.size(); ++j) {
        if (!placed[j] && (j == i || alike(i, j))) {
          placed[j] = true;
          classes_.back().push_back(j);
        }
      }
    }
  }

  // By number of steps and of pairs left: the fewest introductions with which that many steps can
  // meet that many pairs.
  void find_introductions() {
    const std::uint64_t k = job_->room();
    const auto most_new = [&](std::uint64_t j) {
      return j * (j - std::min<std::uint64_t>(j, 1)) / 2 + j * (k - j);
    };
    const std::size_t pairs = ends_.size();
    fewest_.assign(pairs + 1, std::vector<std::uint64_t>(pairs + 1, endless));
    fewest_[0][0] = 0;
    for (std::size_t t = 1; t <= pairs; ++t) {
      for (std::size_t r = 0; r <= pairs; ++r) {
        for (std::uint64_t j = 0; j <= k; ++j) {
          const std::size_t before =
              r - std::min<std::size_t>(r, static_cast<std::size_t>(most_new(j)));
          fewest_[t][r] = std::min(fewest_[t][r], fewest_[t - 1][before] + j);
        }
      }
    }
  }

  // The most meetings of parts that stay, in t steps with this many introductions.
  [[nodiscard]] std::uint64_t met_by_staying(std::uint64_t t, std::uint64_t introductions) const {
    const std::uint64_t k = job_->room();
    const std::uint64_t each = introductions / t;
    const std::uint64_t more = introductions % t;
    return (t - more) * each * (k - each) + (more == 0 ? 0 : more * (each + 1) * (k - each - 1));
  }

  // The least cost of introductions that gain this much, for each part at most what it lacks.
  [[nodiscard]] std::uint64_t price_of(
      std::uint64_t needed, const std::array<std::uint64_t, most_small_parts>& lacks) const {
    std::uint64_t total = 0;
    for (const std::size_t i : by_price_) {
      const std::uint64_t taken = std::min(needed, lacks[i]);
      total += taken * price_[i];
      needed -= taken;
    }
    return total / (job_->room() - 1);
  }

  // The least cost of everything that is left.
  [[nodiscard]] std::uint64_t rest(Mask met, Parts setup) const {
    std::array<std::uint8_t, most_small_parts> degree{};
    std::size_t left = 0;
    for (Mask missing = whole_ & ~met; missing != 0; missing &= missing - 1) {
      const auto& ends = ends_[static_cast<std::size_t>(std::countr_zero(missing))];
      ++degree[ends[0]];
      ++degree[ends[1]];
      ++left;
    }
    if (left == 0) {
      return 0;
    }
    const std::uint64_t k = job_->room();
    std::uint64_t once = 0;
    std::uint64_t prices = 0;
    std::uint64_t cheapest = endless;
    std::uint64_t places = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (degree[i] > 0) {
        places += (degree[i] + k - 2) / (k - 1);
        cheapest = std::min(cheapest, price_[i]);
        const bool outside = (setup >> i & 1) == 0;
        once += outside ? 1U : 0U;
        prices += outside ? price_[i] : 0;
      }
    }
    std::uint64_t lacking = 0;  // what further introductions and stays must gain
    std::array<std::uint64_t, most_small_parts> lacks{};
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::uint64_t brought = (setup >> i & 1) == 0 ? k - 1 : 0;
      lacks[i] = degree[i] - std::min<std::uint64_t>(degree[i], brought);
      lacking += lacks[i];
    }
    std::uint64_t least = endless;
    for (std::uint64_t t = std::max<std::uint64_t>(1, (places + k - 1) / k);
         t <= left && t * job_->test_cost.millionths + prices < least; ++t) {
      const std::uint64_t tests = t * job_->test_cost.millionths;
      const std::uint64_t fewest = fewest_[static_cast<std::size_t>(t)][left];
      for (std::uint64_t i = std::max(fewest, once); i <= t * k; ++i) {
        const std::uint64_t further = prices + (i - once) * cheapest;
        const std::uint64_t stays = met_by_staying(t, i);
        const std::uint64_t making_up =
            prices + price_of(lacking - std::min(lacking, stays), lacks);
        least = std::min(least, tests + std::max(further, making_up));
        if (making_up <= further || tests + further >= least) {
          break;
        }
      }
    }
    return least;
  }

  // New labels for the parts: within a class, sorted by whether they are mounted and which parts
  // they still have to meet.
  [[nodiscard]] Labels labels(Mask met, Parts setup) const {
    if (classes_.size() == parts_.size()) {
      return nodes_[0].label;  // no part is like another
    }
    std::array<std::uint32_t, most_small_parts> key{};
    for (unsigned round = 0; round < 2; ++round) {
      std::array<std::uint32_t, most_small_parts> sum{};
      for (Mask missing = whole_ & ~met; missing != 0; missing &= missing - 1) {
        const auto& [i, j] = ends_[static_cast<std::size_t>(std::countr_zero(missing))];
        sum[i] += 64 + key[j] % 8191;
        sum[j] += 64 + key[i] % 8191;
      }
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        key[i] = (sum[i] << 1U | (std::uint32_t{setup} >> i & 1U)) * 37 % 1'000'003;
      }
    }
    Labels label{};
    std::array<std::size_t, most_small_parts> sorted{};
    for (const std::vector<std::size_t>& members : classes_) {
      std::copy(members.begin(), members.end(), sorted.begin());
      auto* const end = sorted.begin() + std::ssize(members);
      for (auto* each = sorted.begin(); each != end; ++each) {  // std::stable_sort allocates
        std::rotate(std::upper_bound(sorted.begin(), each, *each,
                                     [&](std::size_t a, std::size_t b) { return key[a] < key[b]; }),
                    each, each + 1);
      }
      for (std::size_t i = 0; i < members.size(); ++i) {
        label[sorted[i]] = static_cast<std::uint8_t>(members[i]);
      }
    }
    return label;
  }

  void expand(std::uint32_t from) {
    const Node node = nodes_[from];
    for (std::size_t s = 0; s < setups_.size(); ++s) {
      const Mask met = node.met | met_[s];
      if (met == node.met) {
        continue;  // going straight to the next set-up introduces no more
      }
      std::uint64_t cost = node.cost + job_->test_cost.millionths;
      for (Parts coming = setups_[s] & static_cast<Parts>(~node.setup); coming != 0;
           coming &= static_cast<Parts>(coming - 1)) {
        cost += price_[static_cast<std::size_t>(std::countr_zero(coming))];
      }
      const std::uint64_t least = cost + (rest(met, setups_[s]) + unit_ - 1) / unit_ * unit_;
      if (least >= below_) {
        continue;
      }
      const Labels label = labels(met, setups_[s]);
      State state;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        state.setup |= static_cast<Parts>((setups_[s] >> i & 1) << label[i]);
      }
      for (Mask all = met; all != 0; all &= all - 1) {
        const auto& [i, j] = ends_[static_cast<std::size_t>(std::countr_zero(all))];
        state.met |= Mask{1} << pair_[label[i] * parts_.size() + label[j]];
      }
      std::uint32_t& known = node_of(state);
      if (known == 0) {
        known = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
      } else if (nodes_[known].cost <= cost) {
        continue;
      }
      nodes_[known] = {state.met, cost, from, state.setup, setups_[s], label};
      open_.push({least, cost, known});
    }
  }

  // Where the number of the node of that state stands; 0 if it is to be written there.
  [[nodiscard]] std::uint32_t& node_of(const State& state) {
    if (known_.size() < 2 * nodes_.size() + 2) {
      known_.assign(std::max<std::size_t>(1024, 2 * known_.size()), 0);
      for (std::uint32_t node = 1; node < nodes_.size(); ++node) {
        node_of({nodes_[node].met, nodes_[node].setup}) = node;
      }
    }
    const std::size_t mask = known_.size() - 1;
    std::size_t at = state_hash(state) & mask;
    while (known_[at] != 0 &&
           (nodes_[known_[at]].met != state.met || nodes_[known_[at]].setup != state.setup)) {
      at = (at + 1) & mask;
    }
    return known_[at];
  }

  [[nodiscard]] std::vector<Block> list_to(std::uint32_t node) const {
    std::vector<std::uint32_t> path;
    for (; node != 0; node = nodes_[node].parent) {
      path.push_back(node);
    }
    std::vector<Block> setups;
    Labels now = nodes_[0].label;  // by part: its label at the node before
    for (auto at = path.rbegin(); at != path.rend(); ++at) {
      const Node& here = nodes_[*at];
      Block setup;
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        if ((here.as_chosen >> now[i] & 1) != 0) {
          setup.push_back(parts_[i]);
        }
        now[i] = here.label[now[i]];
      }
      setups.push_back(std::move(setup));
    }
    return setups;
  }

  const Job* job_;
  std::uint64_t below_;
  Listener listener_;
  std::optional<ChoiceJob> choices_;
  std::vector<Element> parts_;
  std::uint64_t unit_ = 1;                        // divides all costs
  std::vector<std::uint64_t> price_;              // by part
  std::vector<std::size_t> by_price_;             // the parts, cheapest first
  std::vector<int> pair_;                         // by two parts: the number of their pair, or −1
  std::vector<std::array<std::size_t, 2>> ends_;  // by pair
  Mask whole_ = 0;
  std::vector<Parts> setups_;
  std::vector<Mask> met_;  // by set-up
  std::vector<std::vector<std::size_t>> classes_;
  std::vector<std::vector<std::uint64_t>> fewest_;
  std::vector<Node> nodes_;
  // Numbers of nodes, by the hashes of their states, a power of 2 of places: a map of states would
  // wait for memory twice as often.
  std::vector<std::uint32_t> known_;
  std::priority_queue<Open> open_;
};

}  // namespace

bool is_small(const Job& job) {
  const bool any_hides =
      job.model != nullptr &&
      std::any_of(job.model->parameters.begin(), job.model->parameters.end(),
                  [](const ModelParameter& parameter) {
                    return std::any_of(parameter.values.begin(), parameter.values.end(),
                                       [](const ModelValue& v) { return v.negative; });
                  });
  if (any_hides || job.replaces() || !job.triples.empty()) {
    return false;
  }
  constexpr Amount small{std::uint64_t{1} << 50U};  // a thousand of them can be added
  return job.needed.size() > 0 && job.needed.size() <= most_small_pairs &&
         useful_parts(job).size() <= most_small_parts && job.test_cost <= small &&
         std::all_of(job.change_costs.begin(), job.change_costs.end(),
                     [&](Amount cost) { return cost <= small; });
}

ExactPlan exact_plan(const Job& job, Amount below, std::uint64_t most_states, RunControl& control) {
  return Exact(job, below.millionths, control).run(most_states);
}

std::optional<Start> take_exact(RunPlan& plan, ExactPlan exact) {
  if (exact.bound > plan.bound.cost) {
    plan.bound.cost = exact.bound;
    plan.bound.reason = fmt::format(
        "of all lists, looked through from the cheapest on in {}, none costs less; without that, "
        "{}",
        count_of(exact.states, "state"), plan.bound.reason);
  }
  if (!exact.setups) {
    return std::nullopt;
  }
  return Start{"exact search", "the cheapest of all lists, which were looked through",
               std::move(*exact.setups)};
}

}  // namespace changeover
