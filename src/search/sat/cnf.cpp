#include "search/sat/cnf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

Literal Cnf::new_variable() {
  if (variables_ == most_variables) {
    throw MissingResource("these parameters need a formula of more than 10^8 variables");
  }
  return static_cast<Literal>(++variables_);
}

void Cnf::reserve(const CnfSize& size) {
  literals_.reserve(static_cast<std::size_t>(std::min(size.literals, most_literals)));
}

void Cnf::add(std::span<const Literal> clause) {
  if (literals_.size() + clause.size() + 1 > most_literals) {
    throw MissingResource("these parameters need a formula of more than 2^31 literals");
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
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const std::string& comment : comments) {
    fmt::format_to(out, "c {}\n", comment);
  }
  fmt::format_to(out, "p cnf {} {}\n", cnf.variables(), cnf.clauses() + assumptions.size());
  for (const Literal literal : cnf.literals()) {
    fmt::format_to(out, "{}{}", literal, literal == 0 ? '\n' : ' ');
    if (text.size() > piece) {
      stop_if_asked();
      sink.write({text.data(), text.size()});
      text.clear();
    }
  }
  for (const Literal literal : assumptions) {
    fmt::format_to(out, "{} 0\n", literal);
  }
  sink.write({text.data(), text.size()});
}

}  // namespace changeover
