#include "search/sat/base_block_solver.hpp"

#include <algorithm>
#include <cadical.hpp>
#include <exception>
#include <limits>
#include <utility>

namespace changeover {

// Counts learned clauses, one a conflict, for the solver does not tell its conflicts. What is thrown while it
// asks must not pass through the solver: it is kept, and thrown after it.
struct Formula::Solver final : CaDiCaL::Terminator, CaDiCaL::Learner {
  CaDiCaL::Solver sat;
  RunControl* control = nullptr;
  std::uint64_t learned = 0;
  std::exception_ptr fault;

  bool terminate() override {
    if (fault) {
      return true;
    }
    try {
      if (control->progress_due()) {
        control->tell({.phase = "SAT solver", .steps = learned, .unit = "conflicts"});
      }
      return control->stop_wanted();
    } catch (...) {
      fault = std::current_exception();
      return true;
    }
  }
  bool learning(int) override {
    ++learned;
    return false;
  }
  void learn(int) override {}
};

Formula::Formula(std::uint64_t seed) : solver_(std::make_unique<Solver>()) {
  solver_->sat.set("quiet", 1);
  solver_->sat.set("seed", static_cast<int>(seed % 2'000'000'000));
  solver_->sat.connect_learner(solver_.get());
}

Formula::~Formula() { solver_->sat.disconnect_learner(); }

Formula::Answer Formula::solve(RunControl& control, std::optional<std::uint64_t> conflicts) {
  constexpr std::size_t between_questions = std::size_t{1} << 14;
  const auto literals = cnf.literals();
  for (; handed_over_ < literals.size(); ++handed_over_) {
    if (handed_over_ % between_questions == 0 && control.stop_wanted()) {
      return Answer::unknown;  // the next call goes on here
    }
    solver_->sat.add(literals[handed_over_]);
  }
  if (control.stop_wanted()) {
    return Answer::unknown;
  }
  solver_->control = &control;
  if (conflicts) {
    solver_->sat.limit("conflicts", static_cast<int>(std::min<std::uint64_t>(
                                        *conflicts, std::numeric_limits<int>::max())));
  }
  solver_->sat.connect_terminator(solver_.get());
  const int answer = solver_->sat.solve();
  solver_->sat.disconnect_terminator();
  if (solver_->fault) {
    std::rethrow_exception(std::exchange(solver_->fault, nullptr));
  }
  return answer == 10   ? Answer::satisfiable
         : answer == 20 ? Answer::unsatisfiable
                        : Answer::unknown;
}

bool Formula::holds(Literal literal) const { return solver_->sat.val(literal) > 0; }

std::uint64_t Formula::conflicts() const { return solver_->learned; }

void at_most_one(Cnf& cnf, std::span<const Literal> literals) {
  if (literals.size() <= 6) {
    for (std::size_t i = 0; i < literals.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        cnf.add({-literals[i], -literals[j]});
      }
    }
    return;
  }
  Literal before = literals[0];  // one of the literals so far
  for (std::size_t i = 1; i < literals.size(); ++i) {
    cnf.add({-before, -literals[i]});
    if (i + 1 < literals.size()) {
      const Literal next = cnf.new_variable();
      cnf.add({-before, next});
      cnf.add({-literals[i], next});
      before = next;
    }
  }
}

void require_not_less(Cnf& cnf, std::span<const Literal> a, std::span<const Literal> b) {
  std::vector<Literal> same;  // the negation of: no difference so far
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<Literal> clause = same;
    clause.insert(clause.end(), {a[i], -b[i]});
    cnf.add(clause);
    if (i + 1 == a.size()) {
      break;
    }
    // As a ≥ b at this digit if all before are the same, it is the same unless a has 1 and b has 0.
    const Literal still = cnf.new_variable();
    for (const Literal reason : {-a[i], b[i]}) {
      clause = same;
      clause.insert(clause.end(), {still, -reason});
      cnf.add(clause);
    }
    same = {-still};
  }
}

}  // namespace changeover
