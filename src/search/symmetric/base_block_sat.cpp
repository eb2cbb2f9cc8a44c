#include "search/symmetric/base_block_sat.hpp"

#include <algorithm>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "search/pair_orbits.hpp"
#include "search/sat/cardinality.hpp"
#include "search/sat/sat_solver.hpp"
#include "search/symmetric/base_block_anneal.hpp"

namespace changeover {
namespace {

class Model {
 public:
  Model(const Parameters& p, const BaseBlockShape& shape, bool tight, std::uint64_t seed)
      : solver(seed),
        p_(p),
        shape_(shape),
        orbits_(shape),
        v_(static_cast<std::size_t>(shape.v())),
        c_(static_cast<std::size_t>(shape.base_blocks)) {
    in_block_ = variables(c_ * v_);
    require_changes();
    cover(tight);
    if (tight) {
      require_degrees();
    }
    break_symmetry();
  }

  std::vector<Block> blocks() const {
    std::vector<Block> blocks(c_);
    for (std::size_t i = 0; i < c_; ++i) {
      for (Element x = 0; x < v_; ++x) {
        if (solver.holds(in(i, x))) {
          blocks[i].push_back(x);
        }
      }
    }
    return blocks;
  }

  IncrementalSolver solver;

 private:
  std::vector<Literal> variables(std::size_t how_many) {
    std::vector<Literal> list(how_many);
    std::ranges::generate(list, [&] { return solver.cnf.new_variable(); });
    return list;
  }

  Literal in(std::size_t i, Element x) const { return in_block_[i * v_ + x]; }
  Literal introduced(std::size_t i, Element x) const { return introduced_[i * v_ + x]; }

  // Whether x is in the block before block i: block 0 follows π⁻¹(B_{c−1}), which contains x if
  // B_{c−1} contains π(x).
  Literal before(std::size_t i, Element x) const {
    return i > 0 ? in(i - 1, x) : in(c_ - 1, shape_.image(x, 1));
  }

  // A new variable that is equivalent to: a and not b.
  Literal and_not(Literal a, Literal b) {
    Cnf& cnf = solver.cnf;
    const Literal result = cnf.new_variable();
    cnf.add({-result, a});
    cnf.add({-result, -b});
    cnf.add({result, -a, b});
    return result;
  }

  void require_changes() {
    introduced_.reserve(c_ * v_);
    const auto k = static_cast<std::size_t>(p_.k);
    const auto m = static_cast<std::size_t>(p_.change);
    for (std::size_t i = 0; i < c_; ++i) {
      stop_if_asked();
      std::vector<Literal> leaving;
      for (Element x = 0; x < v_; ++x) {
        introduced_.push_back(and_not(in(i, x), before(i, x)));
        leaving.push_back(and_not(before(i, x), in(i, x)));
      }
      const auto row = static_cast<std::ptrdiff_t>(i * v_);
      const auto width = static_cast<std::ptrdiff_t>(v_);
      const std::vector<Literal> block(in_block_.begin() + row, in_block_.begin() + row + width);
      const std::vector<Literal> enter(introduced_.begin() + row,
                                       introduced_.begin() + row + width);
      require_exactly(solver.cnf, block, k);
      require_exactly(solver.cnf, enter, m);
      require_exactly(solver.cnf, leaving, m);
    }
  }

  // Each orbit of pairs is in some block or, for tight designs, newly covered exactly once.
  void cover(bool exactly_once) {
    Cnf& cnf = solver.cnf;
    std::vector<std::vector<Literal>> covers(orbits_.count());
    for (std::size_t i = 0; i < c_; ++i) {
      for (Element y = 1; y < v_; ++y) {
        stop_if_asked();
        for (Element x = 0; x < y; ++x) {
          const Literal covered = cnf.new_variable();
          cnf.add({-covered, in(i, x)});
          cnf.add({-covered, in(i, y)});
          if (exactly_once) {
            cnf.add({-covered, introduced(i, x), introduced(i, y)});
            cnf.add({covered, -introduced(i, x), -in(i, y)});
            cnf.add({covered, -introduced(i, y), -in(i, x)});
          }
          covers[orbits_.of(x, y)].push_back(covered);
        }
      }
    }
    for (const std::vector<Literal>& orbit : covers) {
      stop_if_asked();
      cnf.add(orbit);
      if (exactly_once) {
        at_most_one(cnf, orbit);
      }
    }
  }

  // Each cycle has one of the degrees that the identity allows: if it has exactly i introductions,
  // then it has the r occurrences that belong to i.
  void require_degrees() {
    for (std::uint64_t cycle = 0; cycle < shape_.cycles + shape_.fixed; ++cycle) {
      std::vector<Literal> enter;
      std::vector<Literal> occur;
      for (std::size_t i = 0; i < c_; ++i) {
        for (Element x = 0; x < v_; ++x) {
          if (shape_.cycle(x) == cycle) {
            enter.push_back(introduced(i, x));
            occur.push_back(in(i, x));
          }
        }
      }
      const std::vector<Degree> degrees =
          cycle < shape_.cycles ? cycle_degrees(p_, shape_) : fixed_degrees(p_, shape_);
      require_degree(enter, occur, degrees);
    }
  }

  void require_degree(const std::vector<Literal>& enter, const std::vector<Literal>& occur,
                      const std::vector<Degree>& degrees) {
    Cnf& cnf = solver.cnf;
    std::uint64_t most_enter = 0;
    std::uint64_t most_occur = 0;
    for (const Degree& degree : degrees) {
      most_enter = std::max(most_enter, degree.introductions);
      most_occur = std::max(most_occur, degree.occurrences);
    }
    const auto enters = unary_count(cnf, enter, static_cast<std::size_t>(most_enter + 1));
    const auto occurs = unary_count(cnf, occur, static_cast<std::size_t>(most_occur + 1));
    std::vector<Literal> one_of;
    for (const Degree& degree : degrees) {
      const Literal chosen = cnf.new_variable();
      one_of.push_back(chosen);
      const auto exactly = [&](const std::vector<Literal>& at_least, std::uint64_t number) {
        if (number > at_least.size()) {
          cnf.add({-chosen});
          return;
        }
        if (number > 0) {
          cnf.add({-chosen, at_least[static_cast<std::size_t>(number - 1)]});
        }
        if (number < at_least.size()) {
          cnf.add({-chosen, -at_least[static_cast<std::size_t>(number)]});
        }
      };
      exactly(enters, degree.introductions);
      exactly(occurs, degree.occurrences);
    }
    cnf.add(one_of);
  }

  // These are compatible: each cycle can be rotated independently, which does not change the blocks
  // that it meets, so cycles can be sorted by these blocks; fixed points can be sorted by the
  // blocks that contain them.
  void break_symmetry() {
    Cnf& cnf = solver.cnf;
    std::vector<std::vector<Literal>> meets;
    for (std::uint64_t cycle = 0; cycle < shape_.cycles; ++cycle) {
      const auto first = static_cast<Element>(cycle * shape_.n);
      std::vector<Literal> met;
      stop_if_asked();
      for (std::size_t i = 0; i < c_; ++i) {
        const Literal meet = cnf.new_variable();
        std::vector<Literal> some{-meet};
        for (Element x = first; x < first + shape_.n; ++x) {
          cnf.add({meet, -in(i, x)});
          some.push_back(in(i, x));
        }
        cnf.add(some);
        // The first block that meets the cycle contains its residue 0.
        std::vector<Literal> if_first = met;
        if_first.insert(if_first.end(), {-meet, in(i, first)});
        cnf.add(if_first);
        met.push_back(meet);
      }
      meets.push_back(std::move(met));
    }
    for (std::size_t cycle = 1; cycle < meets.size(); ++cycle) {
      require_not_less(cnf, meets[cycle - 1], meets[cycle]);
    }
    for (auto x = static_cast<Element>(v_ - shape_.fixed); x + 1 < v_; ++x) {
      std::vector<Literal> here;
      std::vector<Literal> next;
      for (std::size_t i = 0; i < c_; ++i) {
        here.push_back(in(i, x));
        next.push_back(in(i, x + 1));
      }
      require_not_less(cnf, here, next);
    }
  }

  Parameters p_;
  BaseBlockShape shape_;
  PairOrbits orbits_;
  std::size_t v_;
  std::size_t c_;
  std::vector<Literal> in_block_;    // by block and element
  std::vector<Literal> introduced_;  // in the block, but not in the one before
};

}  // namespace

std::uint64_t sat_size(const BaseBlockShape& shape) {
  return checked_multiply(shape.base_blocks, binomial(shape.v(), 2));
}

// Literals of the clauses for pairs, with the zeros that end them: 8 per pair for covering; 26 for
// covering exactly once, with the chain that allows at most one. The rest, counters of blocks and
// steps, grows with c·v·k.
std::uint64_t sat_bytes(const Parameters& p, const BaseBlockShape& shape, bool tight) {
  // The formula takes 4 bytes per literal. The solver's clauses, watches and copies took about 40.
  constexpr std::uint64_t bytes_of_a_literal = 44;
  const std::uint64_t of_pairs = checked_multiply(tight ? 26 : 8, sat_size(shape));
  constexpr std::uint64_t of_a_counter = 30;
  const std::uint64_t of_counters = checked_multiply(
      of_a_counter, checked_multiply(checked_multiply(shape.base_blocks, p.v), p.k + 2 * p.change));
  // For the clauses on which block meets a cycle first.
  const std::uint64_t of_symmetry =
      checked_multiply(checked_multiply(shape.base_blocks, shape.base_blocks), shape.cycles);
  return checked_multiply(bytes_of_a_literal,
                          checked_add(checked_add(of_pairs, of_counters), of_symmetry));
}

BaseBlocksBySat base_blocks_by_sat(const Parameters& p, const BaseBlockShape& shape, bool tight,
                                   std::optional<std::uint64_t> conflicts, RunControl& control) {
  control.require_memory(sat_bytes(p, shape, tight), "the formula for " + to_string(shape));
  Model model(p, shape, tight, control.seed());
  BaseBlocksBySat result;
  result.outcome = model.solver.solve(control, conflicts);
  result.conflicts = model.solver.conflicts();
  if (result.outcome == Outcome::found) {
    result.blocks = model.blocks();
  }
  return result;
}

}  // namespace changeover
