#include "proof/clause_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

bool is_digit(int byte) { return byte >= '0' && byte <= '9'; }
bool is_blank(int byte) { return byte == ' ' || byte == '\t' || byte == '\r'; }

std::string shown(int byte) {
  if (byte == ByteReader::end) {
    return "the end";
  }
  return byte > ' ' && byte < 127 ? fmt::format("'{}'", static_cast<char>(byte))
                                  : fmt::format("byte {}", byte);
}

}  // namespace

ByteReader::ByteReader(std::istream& stream, std::string name, const StopQuestion* stop)
    : stream_(&stream), name_(std::move(name)), stop_(stop) {}

void ByteReader::refill() {
  if (stop_ != nullptr && *stop_ && (*stop_)()) {
    throw CheckStopped{};
  }
  buffer_.resize(buffer_bytes);
  stream_->read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.resize(static_cast<std::size_t>(stream_->gcount()));
  position_ = 0;
  if (stream_->bad()) {
    throw MissingResource(name_ + ": cannot read; check the file and the disk");
  }
}

void ByteReader::skip_blanks(bool over_lines) {
  while (is_blank(peek()) || (over_lines && peek() == '\n')) {
    take();
  }
}

void ByteReader::skip_line() {
  for (int byte = take(); byte != '\n' && byte != end;) {
    byte = take();
  }
}

std::int32_t ByteReader::number(std::uint64_t limit, const char* what) {
  const bool negative = peek() == '-';
  if (negative) {
    take();
  }
  if (!is_digit(peek())) {
    fail(fmt::format("expected {}, found {}", what, shown(peek())));
  }
  std::uint64_t value = 0;
  while (is_digit(peek())) {
    value = value * 10 + static_cast<std::uint64_t>(take() - '0');
    if (value > limit) {
      fail(fmt::format("{} exceeds {}", what, limit));
    }
  }
  if (!is_blank(peek()) && peek() != '\n' && peek() != end) {
    fail(fmt::format("expected a blank after {}, found {}", what, shown(peek())));
  }
  const auto magnitude = static_cast<std::int32_t>(value);
  return negative ? -magnitude : magnitude;
}

void ByteReader::fail_at(std::uint64_t line, const std::string& what) const {
  throw BadInput(fmt::format("{}:{}: {}", name_, line, what));
}

DimacsReader::DimacsReader(std::istream& stream, std::string name, const ReadLimits& limits)
    : bytes_(stream, std::move(name), limits.stop), limits_(limits) {
  for (bytes_.skip_blanks(true); bytes_.peek() == 'c'; bytes_.skip_blanks(true)) {
    bytes_.skip_line();
  }
  for (const char expected : {'p', ' ', 'c', 'n', 'f', ' '}) {
    if (expected == ' ' ? !is_blank(bytes_.peek()) : bytes_.peek() != expected) {
      bytes_.fail(fmt::format("expected the header 'p cnf VARIABLES CLAUSES', found {}",
                              shown(bytes_.peek())));
    }
    expected == ' ' ? bytes_.skip_blanks(false) : static_cast<void>(bytes_.take());
  }
  constexpr std::uint64_t most_clauses = 1'000'000'000;
  const std::int32_t variables = bytes_.number(limits_.max_variable, "the number of variables");
  bytes_.skip_blanks(false);
  const std::int32_t clauses = bytes_.number(most_clauses, "the number of clauses");
  bytes_.skip_blanks(false);
  if (variables < 0 || clauses < 0) {
    bytes_.fail("the header has a negative number");
  }
  if (bytes_.peek() != '\n' && bytes_.peek() != ByteReader::end) {
    bytes_.fail(fmt::format("expected the end of the line, found {}", shown(bytes_.peek())));
  }
  variables_ = static_cast<std::uint64_t>(variables);
  declared_ = static_cast<std::uint64_t>(clauses);
}

bool DimacsReader::next(Literals& clause) {
  clause.clear();
  for (bytes_.skip_blanks(true); bytes_.peek() == 'c'; bytes_.skip_blanks(true)) {
    bytes_.skip_line();
  }
  if (bytes_.peek() == ByteReader::end) {
    if (read_ != declared_) {
      bytes_.fail(fmt::format("the header says {} clauses, but there are {}", declared_, read_));
    }
    return false;
  }
  if (read_ == declared_) {
    bytes_.fail(fmt::format("there are more clauses than the {} of the header", declared_));
  }
  while (true) {
    const std::int32_t literal = bytes_.number(variables_, "a literal's variable");
    if (literal == 0) {
      ++read_;
      return true;
    }
    if (clause.size() == limits_.max_literals) {
      bytes_.fail(fmt::format("a clause has more than {} literals", limits_.max_literals));
    }
    clause.push_back(literal);
    bytes_.skip_blanks(true);
    if (bytes_.peek() == ByteReader::end) {
      bytes_.fail("the last clause is not ended by 0: the file seems cut off");
    }
  }
}

DratReader::DratReader(std::istream& stream, std::string name, ProofFormat format,
                       const ReadLimits& limits)
    : bytes_(stream, std::move(name), limits.stop), format_(format), limits_(limits) {}

bool DratReader::next(ProofStep& step) {
  step.clause.clear();
  step.deletes = false;
  return format_ == ProofFormat::text ? next_text(step) : next_binary(step);
}

void DratReader::add(ProofStep& step, std::int32_t literal) {
  if (step.clause.size() == limits_.max_literals) {
    bytes_.fail_at(step.line,
                   fmt::format("a clause has more than {} literals", limits_.max_literals));
  }
  step.clause.push_back(literal);
}

bool DratReader::next_text(ProofStep& step) {
  for (bytes_.skip_blanks(true); bytes_.peek() == 'c'; bytes_.skip_blanks(true)) {
    bytes_.skip_line();
  }
  if (bytes_.peek() == ByteReader::end) {
    return false;
  }
  step.line = bytes_.line();
  if (bytes_.peek() == 'd') {
    bytes_.take();
    step.deletes = true;
    if (!is_blank(bytes_.peek())) {
      bytes_.fail(fmt::format("expected a blank after 'd', found {}", shown(bytes_.peek())));
    }
    bytes_.skip_blanks(true);
  }
  while (true) {
    const std::int32_t literal = bytes_.number(limits_.max_variable, "a literal's variable");
    if (literal == 0) {
      return true;
    }
    add(step, literal);
    bytes_.skip_blanks(true);
    if (bytes_.peek() == ByteReader::end) {
      bytes_.fail("the last clause is not ended by 0: the file seems cut off");
    }
  }
}

bool DratReader::next_binary(ProofStep& step) {
  if (bytes_.peek() == ByteReader::end) {
    return false;
  }
  step.line = ++steps_;
  const int kind = bytes_.take();
  if (kind != 'a' && kind != 'd') {
    bytes_.fail_at(step.line, fmt::format("expected 'a' or 'd', found {}", shown(kind)));
  }
  step.deletes = kind == 'd';
  while (true) {
    std::uint64_t number = 0;
    for (unsigned shift = 0;; shift += 7) {
      const int byte = bytes_.take();
      if (byte == ByteReader::end) {
        bytes_.fail_at(step.line, "the last clause is not ended by 0: the file seems cut off");
      }
      number |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (number / 2 > limits_.max_variable || (shift >= 35 && (byte & 128) != 0)) {
        bytes_.fail_at(step.line,
                       fmt::format("a literal's variable exceeds {}", limits_.max_variable));
      }
      if ((byte & 128) == 0) {
        break;
      }
    }
    if (number == 0) {
      return true;
    }
    if (number == 1) {
      bytes_.fail_at(step.line, "the number 1 is not a literal");
    }
    const auto variable = static_cast<std::int32_t>(number / 2);
    add(step, number % 2 == 0 ? variable : -variable);
  }
}

}  // namespace changeover
