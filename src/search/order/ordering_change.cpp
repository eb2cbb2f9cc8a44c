// order_for_change: Hamiltonian paths and cycles by rotation and extension, exactly by SAT.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "run/random.hpp"
#include "search/order/ordering_bound.hpp"
#include "search/sat/cardinality.hpp"
#include "search/sat/sat_solver.hpp"

namespace changeover {
namespace {

constexpr std::size_t blocks_between_questions = 16;
constexpr std::uint64_t rotations_between_questions = 256;
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t most_listed = 512;  // neighbours of a block in a large graph
constexpr std::size_t comparisons_between_questions = 4096;
constexpr std::size_t small_graph = 2000;  // blocks whose neighbours are all listed

/// The graph of blocks that may be neighbours.
class ChangeGraph {
 public:
  ChangeGraph(const Overlaps& overlaps, std::uint64_t m) : overlaps_(overlaps), m_(m) {
    const std::size_t b = overlaps.count();
    lists_.resize(b);
    std::uint64_t listed = 0;
    for (std::size_t i = 0; i < b; ++i) {
      std::vector<std::uint32_t>& list = lists_[i];
      report_progress({.phase = "looking for neighbours", .steps = i, .unit = "blocks"});
      for (std::size_t j = 0; j < b; ++j) {
        if (j % comparisons_between_questions == 0) {
          stop_if_asked();
        }
        if (adjacent(i, j)) {
          list.push_back(static_cast<std::uint32_t>(j));
        }
      }
      if (b > small_graph && list.size() > most_listed) {
        for (std::size_t at = 0; at < most_listed; ++at) {
          list[at] = list[at * list.size() / most_listed];
        }
        list.resize(most_listed);
        complete_ = false;
      }
      list.shrink_to_fit();
      listed += list.size();
      require_memory(listed * sizeof(std::uint32_t), "the graph of blocks that may be neighbours");
    }
  }

  [[nodiscard]] bool adjacent(std::size_t i, std::size_t j) const {
    return i != j && overlaps_(i, j) + m_ == overlaps_.size(i);
  }
  [[nodiscard]] const std::vector<std::uint32_t>& neighbours(std::size_t i) const {
    return lists_[i];
  }
  [[nodiscard]] std::size_t count() const { return lists_.size(); }
  /// Whether all neighbours are listed.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  const Overlaps& overlaps_;
  std::uint64_t m_;
  std::vector<std::vector<std::uint32_t>> lists_;
  bool complete_ = true;
};

// A short argument that there is no order, for b ≥ 2; empty if none is known.
std::string obstruction(const ChangeGraph& graph, const ChangeWanted& wanted) {
  const bool circular = wanted.kind == Kind::circular && graph.count() > 2;
  const std::string m = count_of(wanted.m, "element");
  std::size_t ends = 0;
  for (std::size_t i = 0; i < graph.count(); ++i) {
    const std::size_t degree = graph.neighbours(i).size();
    if (degree == 0) {
      return fmt::format("no other block differs from block {} in exactly {}", i + 1, m);
    }
    if (degree == 1 && circular) {
      return fmt::format("only one other block differs from block {} in exactly {}", i + 1, m);
    }
    ends += degree == 1 ? 1 : 0;
    if (ends > 2 && !circular && graph.count() > 2) {
      return fmt::format("three blocks differ from only one other block in exactly {}", m);
    }
  }
  if (graph.complete()) {
    std::vector<bool> reached(graph.count(), false);
    std::vector<std::uint32_t> open{0};
    reached[0] = true;
    std::size_t count = 1;
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      for (const std::uint32_t j : graph.neighbours(i)) {
        if (!reached[j]) {
          reached[j] = true;
          ++count;
          open.push_back(j);
        }
      }
    }
    if (count < graph.count()) {
      const auto out = std::ranges::find(reached, false) - reached.begin();
      return fmt::format("block {} is not reached from block 1 by steps that change exactly {}",
                         out + 1, m);
    }
  }
  return "";
}

/// A path that grows, and is rotated when it cannot.
class Rotation {
 public:
  Rotation(const ChangeGraph& graph, bool circular, Random& random)
      : graph_(graph), circular_(circular), random_(random), place_(graph.count()) {}

  // Returns whether an order was found.
  bool run(std::uint64_t most, std::uint64_t& rotations, RunControl& control) {
    const std::uint64_t patience = 20'000 + 100 * graph_.count();
    while (rotations < most && !control.stop_wanted()) {
      begin();
      for (std::uint64_t since = 0; since < patience && rotations < most; ++since) {
        if (extend()) {
          since = 0;
          if (path_.size() % blocks_between_questions == 0 && control.stop_wanted()) {
            return false;
          }
          continue;
        }
        if (done()) {
          return true;
        }
        ++rotations;
        if (rotations % rotations_between_questions == 0 && control.stop_wanted()) {
          return false;
        }
        rotate();
      }
    }
    return false;
  }

  [[nodiscard]] std::vector<std::size_t> order() const { return {path_.begin(), path_.end()}; }

 private:
  void begin() {
    std::ranges::fill(place_, nowhere);
    path_.clear();
    push(random_.below(static_cast<std::uint32_t>(graph_.count())));
  }

  void push(std::uint32_t i) {
    place_[i] = static_cast<std::uint32_t>(path_.size());
    path_.push_back(i);
  }

  [[nodiscard]] bool done() const {
    return path_.size() == graph_.count() &&
           (!circular_ || path_.size() <= 2 || graph_.adjacent(path_.front(), path_.back()));
  }

  // Extends to a free neighbour that itself has the fewest free neighbours.
  bool extend() {
    std::uint32_t best = nowhere;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    std::uint32_t ties = 0;
    for (const std::uint32_t j : graph_.neighbours(path_.back())) {
      if (place_[j] != nowhere) {
        continue;
      }
      std::size_t free = 0;
      std::size_t looked = 0;
      for (const std::uint32_t next : graph_.neighbours(j)) {
        free += place_[next] == nowhere ? 1U : 0U;
        if (free > fewest || ++looked == 64) {
          break;
        }
      }
      ties = free < fewest ? 1 : ties + (free == fewest ? 1 : 0);
      if (free < fewest || (free == fewest && random_.below(ties) == 0)) {
        fewest = free;
        best = j;
      }
    }
    if (best == nowhere) {
      return false;
    }
    push(best);
    return true;
  }

  void reverse_from(std::size_t at) {
    std::reverse(path_.begin() + static_cast<std::ptrdiff_t>(at), path_.end());
    for (; at < path_.size(); ++at) {
      place_[path_[at]] = static_cast<std::uint32_t>(at);
    }
  }

  // …, u, w, …, end with u next to end becomes …, u, end, …, w. Now and then the other end is used.
  void rotate() {
    if (random_.below(16) == 0) {
      reverse_from(0);
    }
    const std::vector<std::uint32_t>& list = graph_.neighbours(path_.back());
    const std::uint32_t u = list[random_.below(static_cast<std::uint32_t>(list.size()))];
    reverse_from(place_[u] + std::size_t{1});
  }

  const ChangeGraph& graph_;
  bool circular_;
  Random& random_;
  std::vector<std::uint32_t> path_;
  std::vector<std::uint32_t> place_;  // in the path
};

/// Each block has two neighbours; for linear orders one more vertex, next to all blocks, closes the
/// path.
class HamiltonByCuts {
 public:
  HamiltonByCuts(const ChangeGraph& graph, bool circular, std::uint64_t seed)
      : solver_(seed), blocks_(graph.count()), edges_(graph.count() + (circular ? 0 : 1)) {
    for (std::uint32_t i = 0; i < blocks_; ++i) {
      for (const std::uint32_t j : graph.neighbours(i)) {
        if (j < i) {
          join(i, j);
        }
      }
      if (!circular) {
        join(i, static_cast<std::uint32_t>(blocks_));
      }
    }
    for (const auto& edges : edges_) {
      std::vector<Literal> literals = each_of<Literal>(edges, &Edge::literal);
      require_exactly(solver_.cnf, literals, 2);
    }
  }

  Outcome run(std::uint64_t most, RunControl& control) {
    while (conflicts() < most) {
      const Outcome outcome = solver_.solve(control, most - conflicts());
      if (outcome != Outcome::found || cut()) {
        return outcome;
      }
    }
    return Outcome::unknown;
  }

  [[nodiscard]] std::vector<std::size_t> order() const { return order_; }
  [[nodiscard]] std::uint64_t conflicts() const { return solver_.conflicts(); }

 private:
  struct Edge {
    std::uint32_t to;
    Literal literal;
  };

  void join(std::uint32_t i, std::uint32_t j) {
    const Literal literal = solver_.cnf.new_variable();
    edges_[i].push_back({j, literal});
    edges_[j].push_back({i, literal});
  }

  // Follows the cycles of the model. A single cycle is an order; otherwise each cycle must be left
  // somewhere.
  bool cut() {
    const std::size_t count = edges_.size();
    std::vector<std::uint32_t> cycle_of(count, nowhere);
    std::uint32_t cycles = 0;
    for (std::size_t start = count; start-- > 0;) {
      if (cycle_of[start] != nowhere) {
        continue;
      }
      order_.clear();
      auto at = static_cast<std::uint32_t>(start);
      while (at != nowhere) {
        cycle_of[at] = cycles;
        if (at < blocks_) {
          order_.push_back(at);
        }
        std::uint32_t next = nowhere;
        for (const Edge& edge : edges_[at]) {
          if (cycle_of[edge.to] == nowhere && solver_.holds(edge.literal)) {
            next = edge.to;
            break;
          }
        }
        at = next;
      }
      ++cycles;
    }
    if (cycles == 1) {
      return true;
    }
    std::vector<std::vector<Literal>> leaving(cycles);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (const Edge& edge : edges_[i]) {
        if (cycle_of[edge.to] != cycle_of[i]) {
          leaving[cycle_of[i]].push_back(edge.literal);
        }
      }
    }
    for (const std::vector<Literal>& clause : leaving) {
      solver_.cnf.add(clause);
    }
    return false;
  }

  IncrementalSolver solver_;
  std::size_t blocks_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<std::size_t> order_;
};

void recount(std::span<const Block> blocks, const ChangeWanted& wanted,
             const std::vector<std::size_t>& order) {
  const LeastChangeWanted each{wanted.v, wanted.kind, false};
  (void)change_cost(blocks, order, each);  // refuses what is no permutation
  const std::size_t b = order.size();
  const std::size_t steps = b == 1 ? 0 : wanted.kind == Kind::circular ? b : b - 1;
  for (std::size_t at = 0; at < steps; ++at) {
    if (difference(blocks[order[(at + 1) % b]], blocks[order[at]]).size() != wanted.m) {
      throw InternalError("an order of blocks fails its recount");
    }
  }
}

}  // namespace

ChangeOrder order_for_change(std::span<const Block> blocks, const ChangeWanted& wanted,
                             const ChangeOrderOptions& options, RunControl& control) {
  if (blocks.empty()) {
    throw BadInput("there are no blocks to order");
  }
  if (wanted.m == 0) {
    throw ImpossibleParameters(
        "consecutive blocks must differ; give a change number of at least 1");
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].size() != blocks[0].size()) {
      throw BadInput(fmt::format("block {} has {} and block 1 has {}; all need the same", i + 1,
                                 count_of(blocks[i].size(), "element"), blocks[0].size()));
    }
  }
  const RunScope scope(control);
  const Overlaps overlaps(blocks, wanted.v);
  ChangeOrder result;
  const auto finish = [&](Outcome outcome, std::vector<std::size_t> order) {
    result.outcome = outcome;
    result.order = std::move(order);
    if (outcome == Outcome::found) {
      recount(blocks, wanted, result.order);
    }
    result.why_stopped = outcome == Outcome::found                      ? WhyStopped::found
                         : outcome == Outcome::none                     ? WhyStopped::exhausted
                         : control.why_stopped() != WhyStopped::running ? control.why_stopped()
                                                                        : WhyStopped::step_limit;
    return result;
  };
  if (blocks.size() == 1) {
    return finish(Outcome::found, {0});
  }
  std::optional<ChangeGraph> neighbours;
  try {
    neighbours.emplace(overlaps, wanted.m);
  } catch (const Stopped&) {
    return finish(Outcome::unknown, {});
  }
  const ChangeGraph& graph = *neighbours;
  result.reason = obstruction(graph, wanted);
  if (!result.reason.empty()) {
    return finish(Outcome::none, {});
  }
  const bool circular = wanted.kind == Kind::circular;
  Random random(control.seed());
  Rotation rotation(graph, circular, random);
  // With few blocks the exact method is fast, so stop early.
  const bool few = blocks.size() <= options.sat_blocks && blocks.size() > 2;
  const std::uint64_t most =
      few ? std::min<std::uint64_t>(options.rotations, 200'000) : options.rotations;
  if (rotation.run(most, result.rotations, control)) {
    return finish(Outcome::found, rotation.order());
  }
  if (!few || !graph.complete() || control.stop_wanted()) {
    return finish(Outcome::unknown, {});
  }
  HamiltonByCuts exact(graph, circular, control.seed());
  const Outcome outcome = exact.run(options.conflicts, control);
  result.conflicts = exact.conflicts();
  if (outcome == Outcome::none) {
    result.reason = fmt::format("the SAT solver says that there is none, after {}",
                                count_of(result.conflicts, "conflict"));
  }
  return finish(outcome, outcome == Outcome::found ? exact.order() : std::vector<std::size_t>{});
}

}  // namespace changeover
