// Clauses from DIMACS CNF and DRAT files, one after another.
//
//     DimacsReader formula(stream, "a.cnf", limits);
//     while (formula.next(clause)) { … }
//     DratReader proof(stream, "a.drat", format, limits);
//     while (proof.next(step)) { … }
//
// Memory is one buffer and one clause. Every fault is one line with the file's name and the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "changeover/proof/proof.hpp"

namespace changeover {

/// Literals ±x, as in the file.
using Literals = std::vector<std::int32_t>;

/// Thrown out of long work when ProofOptions::stop says so; no fault.
struct CheckStopped {};

/// Whether to stop; nullptr: never.
using StopQuestion = std::function<bool()>;

struct ReadLimits {
  std::uint64_t max_variable = 0;
  std::uint64_t max_literals = 0;  ///< of one clause
  const StopQuestion* stop =
      nullptr;  ///< asked for each buffer; CheckStopped is thrown if it says so
};

/// The bytes of a stream, with the number of the line.
class ByteReader {
 public:
  static constexpr int end = -1;

  ByteReader(std::istream& stream, std::string name, const StopQuestion* stop = nullptr);

  /// The next byte without taking it, or `end`.
  int peek() {
    if (position_ == buffer_.size()) {
      refill();
    }
    return position_ == buffer_.size() ? end : static_cast<unsigned char>(buffer_[position_]);
  }
  int take() {
    const int byte = peek();
    if (byte != end) {
      ++position_;
      line_ += byte == '\n' ? 1 : 0;
    }
    return byte;
  }
  /// The line of the next byte, from 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }

  void skip_blanks(bool over_lines);
  void skip_line();
  /// A whole number of decimal digits, perhaps with a minus. @throws BadInput if there is none or
  /// if it exceeds `limit`.
  std::int32_t number(std::uint64_t limit, const char* what);
  /// @throws BadInput with the name and the line.
  [[noreturn]] void fail(const std::string& what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::uint64_t line, const std::string& what) const;

 private:
  void refill();

  std::istream* stream_;
  std::string name_;
  const StopQuestion* stop_;
  std::vector<char> buffer_;
  std::size_t position_ = 0;
  std::uint64_t line_ = 1;
};

/// A formula: comments, "p cnf VARIABLES CLAUSES", and the clauses, each ended by 0.
class DimacsReader {
 public:
  /// Reads up to and with the header.
  DimacsReader(std::istream& stream, std::string name, const ReadLimits& limits);

  [[nodiscard]] std::uint64_t variables() const { return variables_; }

  /// The next clause; false at the end. @throws BadInput, also if there are not as many clauses as
  /// the header says.
  bool next(Literals& clause);

 private:
  ByteReader bytes_;
  ReadLimits limits_;
  std::uint64_t variables_ = 0;
  std::uint64_t declared_ = 0;
  std::uint64_t read_ = 0;
};

/// One line of a proof.
struct ProofStep {
  bool deletes = false;
  std::uint64_t line = 0;  ///< of a text, where it begins; number of the step of a binary proof
  Literals clause;
};

class DratReader {
 public:
  DratReader(std::istream& stream, std::string name, ProofFormat format, const ReadLimits& limits);

  /// The next step; false at the end.
  bool next(ProofStep& step);

  /// Where reading stands: a line, or the number of steps read.
  [[nodiscard]] std::uint64_t place() const {
    return format_ == ProofFormat::text ? bytes_.line() : steps_;
  }

 private:
  bool next_text(ProofStep& step);
  bool next_binary(ProofStep& step);
  void add(ProofStep& step, std::int32_t literal);

  ByteReader bytes_;
  ProofFormat format_;
  ReadLimits limits_;
  std::uint64_t steps_ = 0;  // of a binary proof
};

}  // namespace changeover
