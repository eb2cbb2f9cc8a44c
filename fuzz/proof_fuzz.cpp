// A formula and a proof that it has no solution, from any bytes: what is verified is held to all
// assignments.
#include <algorithm>
#include <cstdint>
#include <sstream>

#include "changeover/proof/proof.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::proof_fuzz {
namespace {

constexpr std::uint64_t most_variables_here = 16;

// The clauses of a formula that was accepted: comments begin with c, the line that says how many
// there are with p.
std::vector<std::vector<int>> clauses_of(const std::string& cnf) {
  std::vector<std::vector<int>> clauses(1);
  std::istringstream lines(cnf);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    while (words >> word && word.front() != 'c' && word.front() != 'p') {
      const int literal = std::stoi(word);
      if (literal == 0) {
        clauses.emplace_back();
      } else {
        clauses.back().push_back(literal);
      }
    }
  }
  if (clauses.back().empty()) {
    clauses.pop_back();
  }
  return clauses;
}

bool has_solution(const std::vector<std::vector<int>>& clauses, std::uint64_t variables) {
  for (std::uint64_t values = 0; values < std::uint64_t{1} << variables; ++values) {
    const bool all = std::ranges::all_of(clauses, [&](const std::vector<int>& clause) {
      return std::ranges::any_of(clause, [&](int literal) {
        return ((values >> (std::abs(literal) - 1)) & 1U) == (literal > 0 ? 1U : 0U);
      });
    });
    if (all) {
      return true;
    }
  }
  return false;
}

const Target target("proof", [](const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 2);
  for (const ProofFormat format : {ProofFormat::text, ProofFormat::binary}) {
    std::istringstream cnf(parts[0]);
    std::istringstream proof(parts[1]);
    std::uint64_t asked = 0;
    ProofVerdict verdict;
    const bool judged = accepts([&] {
      verdict = check_proof(
          cnf, "a.cnf", proof, "a.drat",
          {.format = format, .max_variable = 100'000, .max_literals = 1U << 20U, .stop = [&] {
             return ++asked > 10'000;
           }});
    });
    if (judged) {
      must(verdict.reason.empty() || is_one_plain_line(verdict.reason), "a reason is one line");
      if (verdict.verified() && verdict.variables <= most_variables_here) {
        must(!has_solution(clauses_of(parts[0]), verdict.variables),
             "a formula with a solution has no proof that it has none");
      }
    }
  }
});

}  // namespace
}  // namespace changeover::fuzz::proof_fuzz
