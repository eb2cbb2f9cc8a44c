// Faults, told apart by whose they are.
//
// "No such design", "unknown" and "limit reached" are values and never thrown. What is thrown derives
// from Error, and its class says whose fault it is:
//
//     try {
//       Design design = read_design("mine.txt");
//     } catch (const BadInput& fault) {              // the file or the number that was given
//       std::cerr << fault.what() << '\n';           // one line: what, where, how to mend it
//     }
//
// The library never prints, exits or aborts.
#pragma once

#include <stdexcept>
#include <string_view>

namespace changeover {

/// Base of every fault; catch it, but throw one of its subclasses. The message is one line that is safe to
/// show, whatever file names and words from outside went into it (src/core/printable.hpp).
class Error : public std::runtime_error {
 protected:
  explicit Error(std::string_view line);
};

/// What was given (a file, a block list, an argument) is malformed. The message is one line that says
/// what is wrong, where, and how to mend it.
class BadInput : public Error {
 public:
  explicit BadInput(std::string_view line) : Error(line) {}
};

/// What the caller asks for besides a design or a file cannot be: no fault of that, and no correction of it would help.
class BadOption : public BadInput {
 public:
  using BadInput::BadInput;
};

/// No design, factorization, … with these parameters can exist, or they exceed what is supported.
class ImpossibleParameters : public Error {
 public:
  explicit ImpossibleParameters(std::string_view line) : Error(line) {}
};

/// Something outside is missing: memory, disk space, a file, a permission.
class MissingResource : public Error {
 public:
  explicit MissingResource(std::string_view line) : Error(line) {}
};

/// Whoever read what was being written went away: a pipe or connection is closed. It is told apart
/// because for standard output it is often no fault at all: `changeover design 99 4 | head -3`.
class ReaderGone : public MissingResource {
 public:
  using MissingResource::MissingResource;
};

/// A bug of this library: a result failed its own verification, an invariant broke.
class InternalError : public Error {
 public:
  explicit InternalError(std::string_view line) : Error(line) {}
};

}  // namespace changeover
