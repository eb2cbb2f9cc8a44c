#include "search/sat/sat_engine.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cadical.hpp>
#include <exception>
#include <limits>
#include <new>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {

struct SatEngine::Solver final : CaDiCaL::Terminator, CaDiCaL::Learner {
  CaDiCaL::Solver sat;
  bool counting = false;
  RunControl* control = nullptr;
  const SatWatch* watch = nullptr;
  std::uint64_t learned = 0;
  std::exception_ptr fault;

  bool terminate() override {
    if (fault) {
      return true;
    }
    try {
      if (control->progress_due()) {
        control->tell(watch->progress());
      }
      return control->stop_wanted() || (watch->give_up && watch->give_up());
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

SatEngine::SatEngine() : solver_(std::make_unique<Solver>()) { set("quiet", 1); }

SatEngine::~SatEngine() {
  if (solver_->counting) {
    solver_->sat.disconnect_learner();
  }
}

void SatEngine::set(const char* option, int value) {
  if (!solver_->sat.set(option, value)) {
    throw InternalError(fmt::format("the SAT solver does not know its option '{}'", option));
  }
}

void SatEngine::count_conflicts() {
  solver_->sat.connect_learner(solver_.get());
  solver_->counting = true;
}

void SatEngine::trace_proof(std::FILE* file, const std::string& name) {
  set("binary", 0);
  if (!solver_->sat.trace_proof(file, name.c_str())) {
    throw InternalError("the SAT solver refuses to write a proof");
  }
}

void SatEngine::close_proof() { solver_->sat.close_proof_trace(); }

template <typename Work>
auto SatEngine::within_memory(Work&& work) const {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw MissingResource(fmt::format(
        "not enough memory to solve a formula of {} clauses; ask for something smaller", clauses_));
  }
}

bool SatEngine::add(const Cnf& cnf, RunControl& control) {
  constexpr std::size_t between_questions = std::size_t{1} << 14;
  clauses_ = cnf.clauses();
  return within_memory([&] {
    const std::span<const Literal> literals = cnf.literals();
    for (; handed_over_ < literals.size(); ++handed_over_) {
      if (handed_over_ % between_questions == 0 && control.stop_wanted()) {
        return false;
      }
      solver_->sat.add(literals[handed_over_]);
    }
    return true;
  });
}

void SatEngine::add_units(std::span<const Literal> literals) {
  for (const Literal literal : literals) {
    solver_->sat.add(literal);
    solver_->sat.add(0);
  }
}

void SatEngine::assume(std::span<const Literal> literals) {
  for (const Literal literal : literals) {
    solver_->sat.assume(literal);
  }
}

void SatEngine::prefer(std::span<const Literal> literals) {
  for (const Literal literal : preferred_) {
    solver_->sat.unphase(literal);
  }
  preferred_.assign(literals.begin(), literals.end());
  for (const Literal literal : preferred_) {
    solver_->sat.phase(literal);
  }
}

Outcome SatEngine::solve(RunControl& control, std::optional<std::uint64_t> conflicts,
                         const SatWatch& watch) {
  if (control.stop_wanted()) {
    return Outcome::unknown;
  }
  solver_->control = &control;
  solver_->watch = &watch;
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  if (conflicts && !solver_->sat.limit("conflicts", static_cast<int>(std::min(*conflicts, most)))) {
    throw InternalError("the SAT solver knows no limit of conflicts");
  }
  solver_->sat.connect_terminator(solver_.get());
  const int answer = within_memory([this] { return solver_->sat.solve(); });
  solver_->sat.disconnect_terminator();
  if (solver_->fault) {
    std::rethrow_exception(std::exchange(solver_->fault, nullptr));
  }
  constexpr int satisfiable = 10;
  constexpr int unsatisfiable = 20;
  return answer == satisfiable     ? Outcome::found
         : answer == unsatisfiable ? Outcome::none
                                   : Outcome::unknown;
}

bool SatEngine::holds(Literal literal) const { return solver_->sat.val(literal) > 0; }

std::uint64_t SatEngine::conflicts() const { return solver_->learned; }

}  // namespace changeover
