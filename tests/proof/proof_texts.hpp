// What the tests of the proof checker share: formulas and proofs as text.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/proof/proof.hpp"

namespace changeover::test {

using Clause = std::vector<int>;
using Clauses = std::vector<Clause>;

inline ProofVerdict check_text(const std::string& cnf, const std::string& proof,
                               const ProofOptions& options = {}) {
  std::istringstream formula(cnf);
  std::istringstream steps(proof);
  return check_proof(formula, "a.cnf", steps, "a.drat", options);
}

inline std::string refusal(const std::string& cnf, const std::string& proof,
                           const ProofOptions& options = {}) {
  try {
    (void)check_text(cnf, proof, options);
  } catch (const BadInput& fault) {
    EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
    return fault.what();
  }
  return "";
}

inline std::string dimacs(int variables, const Clauses& clauses) {
  std::string text =
      "p cnf " + std::to_string(variables) + " " + std::to_string(clauses.size()) + "\n";
  for (const Clause& clause : clauses) {
    for (const int x : clause) {
      text += std::to_string(x) + " ";
    }
    text += "0\n";
  }
  return text;
}

inline std::string lines(const Clauses& clauses) {
  const std::string text = dimacs(1, clauses);
  return text.substr(text.find('\n') + 1);
}

// No assignment of 4 variables satisfies these clauses; unit propagation alone does not see it.
inline const std::string eight =
    "c eight clauses\np cnf 4 8\n1 2 -3 0\n-1 -2 3 0\n2 3 -4 0\n-2 -3 4 0\n-1 -3 -4 0\n1 3 4 0\n"
    "-1 2 4 0\n1 -2 -4 0\n";

inline const std::string needs_unit =
    "p cnf 4 6\n1 2 0\n1 -2 0\n-1 3 4 0\n-1 3 -4 0\n-1 -3 4 0\n-1 -3 -4 0\n";

/// A step of a binary proof.
inline std::string binary_step(char kind, const Clause& clause) {
  std::string bytes(1, kind);
  for (const int x : clause) {
    auto number = static_cast<unsigned>(x > 0 ? 2 * x : -2 * x + 1);
    for (; number > 127; number >>= 7) {
      bytes += static_cast<char>((number & 127) | 128);
    }
    bytes += static_cast<char>(number);
  }
  return bytes + '\0';
}

}  // namespace changeover::test
