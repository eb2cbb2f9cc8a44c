#include "changeover/proof/proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <new>

#include "changeover/core/error.hpp"
#include "proof/clause_reader.hpp"
#include "proof/clause_store.hpp"

namespace changeover {
namespace {

/// Sorts and removes repetitions; false if a literal and its negation occur, so that the clause is
/// true.
bool normalise(Literals& clause) {
  std::sort(clause.begin(), clause.end(), [](std::int32_t a, std::int32_t b) {
    const std::int32_t x = a < 0 ? -a : a;
    const std::int32_t y = b < 0 ? -b : b;
    return x != y ? x < y : a < b;
  });
  clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
  return std::adjacent_find(clause.begin(), clause.end(),
                            [](std::int32_t a, std::int32_t b) { return a == -b; }) == clause.end();
}

std::string shown(const Literals& clause) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < clause.size() && i < most; ++i) {
    text += fmt::format("{} ", clause[i]);
  }
  return text + (clause.size() > most ? "... 0" : "0");
}

class Check {
 public:
  explicit Check(const ProofOptions& options)
      : options_(options), store_(options.max_literals, [this] { ask(); }) {}

  void read_formula(DimacsReader& formula) {
    verdict_.variables = formula.variables();
    reserve(formula.variables());
    Literals clause;
    while (formula.next(clause)) {
      ++verdict_.clauses;
      if (!store_.contradictory() && normalise(clause)) {
        store_.add(clause);
      }
    }
  }

  /// What is known when the check is given up.
  ProofVerdict stopped() {
    return end(ProofVerdict::Outcome::stopped, line_, "the check was stopped");
  }

  ProofVerdict run(DratReader& proof) {
    if (store_.contradictory()) {
      return end(ProofVerdict::Outcome::verified, 0, "unit propagation alone refutes the formula");
    }
    ProofStep step;
    while (proof.next(step)) {
      line_ = step.line;
      if (++steps_ % 1024 == 0) {
        ask();
      }
      const std::int32_t pivot = step.clause.empty() ? 0 : step.clause.front();
      if (step.deletes) {
        remove(step.clause);
      } else if (!add(step.clause, pivot)) {
        return end(ProofVerdict::Outcome::refuted, step.line,
                   step.clause.empty()
                       ? std::string("the empty clause does not follow")
                       : fmt::format("the clause {} does not follow: neither by unit propagation "
                                     "nor by resolution on {}",
                                     shown(step.clause), pivot));
      }
      if (store_.contradictory()) {
        return end(ProofVerdict::Outcome::verified, step.line, "a contradiction was reached");
      }
    }
    return end(ProofVerdict::Outcome::refuted, proof.place(),
               "the proof ends without a contradiction");
  }

 private:
  ProofVerdict end(ProofVerdict::Outcome outcome, std::uint64_t line, std::string reason) {
    verdict_.outcome = outcome;
    verdict_.line = line;
    verdict_.reason = std::move(reason);
    verdict_.propagations = store_.propagations();
    return verdict_;
  }

  void reserve(std::uint64_t variable) { store_.reserve(largest_ = std::max(largest_, variable)); }

  void reserve(const Literals& clause) {
    std::uint64_t most = largest_;
    for (const std::int32_t x : clause) {
      most = std::max(most, static_cast<std::uint64_t>(x < 0 ? -x : x));
    }
    if (most > largest_) {
      reserve(most);
    }
  }

  void remove(Literals& clause) {
    reserve(clause);
    const bool removed = normalise(clause) && !clause.empty() && store_.remove(clause);
    (removed ? verdict_.deleted : verdict_.ignored_deletions) += 1;
  }

  // Leaves a refused clause as it was written, up to the order of its literals.
  bool add(Literals& clause, std::int32_t pivot) {
    reserve(clause);
    if (!normalise(clause)) {
      ++verdict_.added;
      return true;  // it says nothing
    }
    if (!store_.implies(clause)) {
      if (clause.empty() || !store_.implies_resolvents(clause, pivot)) {
        return false;
      }
      ++verdict_.by_resolvents;
    }
    ++verdict_.added;
    store_.add(clause);
    return true;
  }

  void ask() const {
    if (options_.stop && options_.stop()) {
      throw CheckStopped{};
    }
  }

  const ProofOptions& options_;
  ClauseStore store_;
  ProofVerdict verdict_;
  std::uint64_t largest_ = 0;
  std::uint64_t steps_ = 0;
  std::uint64_t line_ = 0;  // of the proof, where the check is
};

std::ifstream open(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw MissingResource(path + ": cannot open; check the path and the permissions");
  }
  return file;
}

}  // namespace

ProofVerdict check_proof(std::istream& cnf, const std::string& cnf_name, std::istream& proof,
                         const std::string& proof_name, const ProofOptions& options) {
  constexpr std::uint64_t longest_clause = std::uint64_t{1} << 26;
  constexpr std::uint64_t largest_variable = std::uint64_t{1} << 28;
  const ReadLimits limits{std::min(options.max_variable, largest_variable),
                          std::min(options.max_literals, longest_clause), &options.stop};
  try {
    Check check(options);
    try {
      DimacsReader formula(cnf, cnf_name, limits);
      check.read_formula(formula);
      DratReader steps(proof, proof_name, options.format, limits);
      return check.run(steps);
    } catch (const CheckStopped&) {
      return check.stopped();
    }
  } catch (const std::bad_alloc&) {
    throw MissingResource(
        fmt::format("not enough memory to check the proof {}; close other programs", proof_name));
  }
}

ProofVerdict check_proof_files(const std::string& cnf_path, const std::string& proof_path,
                               const ProofOptions& options) {
  std::ifstream cnf = open(cnf_path);
  std::ifstream proof = open(proof_path);
  return check_proof(cnf, cnf_path, proof, proof_path, options);
}

}  // namespace changeover
