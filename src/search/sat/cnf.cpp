#include "search/sat/cnf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {

Literal Cnf::new_variable() {
  if (variables_ == most_variables) {
    throw MissingResource(
        "these parameters need a formula of more than 10^8 variables; give smaller ones");
  }
  return static_cast<Literal>(++variables_);
}

void Cnf::reserve(const CnfSize& size) {
  literals_.reserve(static_cast<std::size_t>(std::min(size.literals, most_literals)));
}

void Cnf::add(std::span<const Literal> clause) {
  if (literals_.size() + clause.size() + 1 > most_literals) {
    throw MissingResource(
        "these parameters need a formula of more than 2^31 literals; give smaller ones");
  }
  for (const Literal literal : clause) {
    if (literal == 0 || static_cast<std::size_t>(literal < 0 ? -literal : literal) > variables_) {
      throw InternalError(fmt::format("a clause has the literal {} of no variable", literal));
    }
  }
  literals_.insert(literals_.end(), clause.begin(), clause.end());
  literals_.push_back(0);
  ++clauses_;
}

void write_dimacs(const Cnf& cnf, std::span<const Literal> assumptions,
                  const std::vector<std::string>& comments, Sink& sink) {
  constexpr std::size_t piece = std::size_t{1} << 15;
  std::string text;
  for (const std::string& comment : comments) {
    text += fmt::format("c {}\n", comment);
  }
  text += fmt::format("p cnf {} {}\n", cnf.variables(), cnf.clauses() + assumptions.size());
  for (const Literal literal : cnf.literals()) {
    text += fmt::format_int(literal).c_str();
    text += literal == 0 ? '\n' : ' ';
    if (text.size() > piece) {
      stop_if_asked();
      sink.write(text);
      text.clear();
    }
  }
  for (const Literal literal : assumptions) {
    text += fmt::format("{} 0\n", literal);
  }
  sink.write(text);
}

namespace {

// Bytes per variable, clause and literal. Measured on x86-64 with CaDiCaL 1.5.3 as the growth of
// the resident memory, up to its peak, for the formulas of DCCD(40,5) with 120 blocks, DCCD(60,5)
// with 270 and DCCD(72,4) with 520 (6, 42 and 175 million literals). In millions of bytes: the
// solver 322 and 1706 after six seconds, 5201 after three; the checker 99 and 704, the third was
// not measured; the splitter 114, 706 and 2834. The formula takes 4.0 bytes per literal. The
// constants exceed each of these by 1 to 40 percent.
struct Cost {
  std::uint64_t variable = 0;
  std::uint64_t clause = 0;
  std::uint64_t literal = 0;

  [[nodiscard]] std::uint64_t of(const CnfSize& size) const {
    return checked_add(checked_multiply(variable, size.variables),
                       checked_add(checked_multiply(clause, size.clauses),
                                   checked_multiply(literal, size.literals)));
  }
};

constexpr Cost formula{.variable = 0, .clause = 0, .literal = 4};
constexpr Cost solver{.variable = 400, .clause = 125, .literal = 4};
constexpr Cost checker{.variable = 70, .clause = 40, .literal = 5};
constexpr Cost splitter{.variable = 60, .clause = 24, .literal = 10};

}  // namespace

CnfSize& CnfSize::operator+=(const CnfSize& other) {
  variables = checked_add(variables, other.variables);
  clauses = checked_add(clauses, other.clauses);
  literals = checked_add(literals, other.literals);
  return *this;
}

CnfSize CnfSize::times(std::uint64_t factor) const {
  return {checked_multiply(variables, factor), checked_multiply(clauses, factor),
          checked_multiply(literals, factor)};
}

CnfSize clauses_of(std::uint64_t count, std::uint64_t length) {
  return {.variables = 0, .clauses = count, .literals = checked_multiply(count, length + 1)};
}

std::uint64_t solving_bytes(const CnfSize& size, const SolvingNeeds& needs) {
  try {
    const std::uint64_t one =
        std::max(solver.of(size), needs.proof ? checker.of(size) : std::uint64_t{0});
    const std::uint64_t all = checked_multiply(std::max(1U, needs.threads), one);
    return checked_add(formula.of(size), std::max(all, needs.split ? splitter.of(size) : 0));
  } catch (const ImpossibleParameters&) {
    return std::numeric_limits<std::uint64_t>::max();
  }
}

void require_representable(const CnfSize& size, std::string_view what) {
  if (size.variables > most_variables || size.literals > most_literals) {
    throw MissingResource(
        fmt::format("{} would have {:.3g} variables and {:.3g} literals, more than a formula "
                    "holds (10^8 and 2^31); ask for something smaller",
                    what, static_cast<double>(size.variables), static_cast<double>(size.literals)));
  }
}

}  // namespace changeover
