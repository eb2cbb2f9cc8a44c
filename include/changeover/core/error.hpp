// Faults, one class for each party that can be at fault.
//
// "No such design", "unknown" and "limit reached" are values. What is thrown derives from Error,
// and its class says whose fault it is. One exception: within a RunScope that you open, work that
// is stopped throws Stopped (run/control.hpp), which is not an error and does not derive from
// Error.
//
//     try {
//       Design design = read_design("mine.txt");
//     } catch (const BadInput& fault) {              // the file or the number that was given
//       std::cerr << fault.what() << '\n';           // one line: what, where, how to correct it
//     }
//
// The library never prints, exits or aborts.
#pragma once

#include <stdexcept>
#include <string_view>

namespace changeover {

/// Base of every fault; catch it, but throw one of its subclasses. The message is one line that is
/// safe to show, even if it quotes file names or words from outside: what is unprintable in them is
/// escaped.
class Error : public std::runtime_error {
 protected:
  explicit Error(std::string_view line);
};

/// Input (a file, a block list, an argument) is malformed. The message is one line that says what
/// is wrong, where, and how to correct it.
class BadInput : public Error {
 public:
  explicit BadInput(std::string_view line) : Error(line) {}
};

/// An option of the caller is impossible. The design or file that came with it is not at fault, and
/// correcting it would not help.
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

/// The reader of the output closed the pipe or connection. It has its own class because on
/// standard output it is often not a fault: `changeover design 99 4 | head -3`.
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
