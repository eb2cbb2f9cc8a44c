#include "search/sat/sat_solver.hpp"

#include <fmt/format.h>
#include <cadical.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

namespace fs = std::filesystem;

void set(CaDiCaL::Solver& solver, const char* option, int value) {
  if (!solver.set(option, value)) {
    throw InternalError(fmt::format("the SAT solver does not know its option '{}'", option));
  }
}

// From so many literals on a pass over the formula takes long enough to be noticed, so that the solver asks
// whether to stop wherever it can, and not only every tenth time. What it finds does not depend on that.
constexpr std::size_t large = 1'000'000;

// False if the control stopped it.
bool hand_over(CaDiCaL::Solver& solver, const Cnf& cnf, std::span<const Literal> assumptions,
               RunControl& control) {
  constexpr std::size_t at_once = std::size_t{1} << 14;
  solver.reserve(static_cast<int>(cnf.variables()));
  const std::span<const Literal> all = cnf.literals();
  for (std::size_t begin = 0; begin < all.size(); begin += at_once) {
    if (control.stop_wanted()) {
      return false;
    }
    for (const Literal literal : all.subspan(begin, std::min(at_once, all.size() - begin))) {
      solver.add(literal);
    }
  }
  for (const Literal literal : assumptions) {
    solver.add(literal);
    solver.add(0);
  }
  return true;
}

/// The proof on its way to the disk. The solver writes it and does not look whether that succeeds.
class ProofFile {
 public:
  explicit ProofFile(const std::string& path) : path_(path) {
    if (!path.empty()) {
      file_ = std::fopen(path.c_str(), "wb");
      if (file_ == nullptr) {
        fail();
      }
    }
  }
  ~ProofFile() {
    if (file_ != nullptr) {
      (void)std::fclose(file_);
    }
  }
  ProofFile(const ProofFile&) = delete;
  ProofFile& operator=(const ProofFile&) = delete;

  [[nodiscard]] std::FILE* file() const { return file_; }
  [[nodiscard]] bool failed() const { return file_ != nullptr && std::ferror(file_) != 0; }
  [[nodiscard]] std::uint64_t kilobytes() const {
    const long bytes = file_ == nullptr ? 0 : std::ftell(file_);
    return bytes < 0 ? 0 : static_cast<std::uint64_t>(bytes) / 1000;
  }

  void close() {
    if (file_ == nullptr) {
      return;
    }
    if (failed()) {
      // The system's reason is forgotten by now; it says it again when the next bytes are refused.
      std::clearerr(file_);
      errno = 0;
      (void)std::fputs("0\n", file_);
      (void)std::fflush(file_);
      fail();
    }
    const long written = std::ftell(file_);
    errno = 0;
    if (std::fclose(std::exchange(file_, nullptr)) != 0) {
      fail();
    }
    std::error_code error;
    if (fs::is_regular_file(path_, error) &&
        static_cast<std::uintmax_t>(written) != fs::file_size(path_, error)) {
      fail();  // cut short behind the solver's back
    }
  }

 private:
  [[noreturn]] void fail() const {
    throw MissingResource(
        fmt::format("{}: cannot write the proof: {}; free some space or name another "
                    "directory",
                    path_, std::strerror(errno == 0 ? EIO : errno)));
  }

  std::string path_;
  std::FILE* file_ = nullptr;
};

/// Asked by the solver every few conflicts. What a callback throws waits until the solver has returned.
class Terminator final : public CaDiCaL::Terminator {
 public:
  Terminator(RunControl& control, const Progress& progress, const ProofFile& proof)
      : control_(control), progress_(progress), proof_(proof) {}

  bool terminate() override {
    if (fault_) {
      return true;
    }
    try {
      if (control_.progress_due()) {
        progress_.steps = proof_.kilobytes();
        progress_.unit = "kB of proof";
        control_.tell(progress_);
      }
      return control_.stop_wanted() || proof_.failed();
    } catch (...) {
      fault_ = std::current_exception();
      return true;
    }
  }

  void rethrow() const {
    if (fault_) {
      std::rethrow_exception(fault_);
    }
  }

 private:
  RunControl& control_;
  Progress progress_;
  const ProofFile& proof_;
  std::exception_ptr fault_;
};

}  // namespace

SatResult solve_sat(const Cnf& cnf, std::span<const Literal> assumptions, const SatOptions& options,
                    RunControl& control) try {
  SatResult result;
  if (control.stop_wanted()) {
    return result;
  }
  ProofFile proof(options.proof_path);
  Terminator terminator(control, options.progress, proof);
  {
    CaDiCaL::Solver solver;
    set(solver, "quiet", 1);
    if (cnf.literals().size() > large) {
      set(solver, "terminateint", 0);  // the solver takes options before anything else only
    }
    if (proof.file() != nullptr) {
      set(solver, "binary", 0);
      if (!solver.trace_proof(proof.file(), options.proof_path.c_str())) {
        throw InternalError("the SAT solver refuses to write a proof");
      }
    }
    if (!hand_over(solver, cnf, assumptions, control)) {
      return result;
    }
    if (options.conflicts) {
      constexpr std::uint32_t most = std::numeric_limits<int>::max();
      if (!solver.limit("conflicts", static_cast<int>(std::min(*options.conflicts, most)))) {
        throw InternalError("the SAT solver knows no limit of conflicts");
      }
    }
    solver.connect_terminator(&terminator);
    const int answer = solver.solve();
    solver.disconnect_terminator();
    constexpr int satisfiable = 10;
    constexpr int unsatisfiable = 20;
    if (answer == satisfiable) {
      result.answer = SatAnswer::satisfiable;
      result.model.assign(cnf.variables() + 1, false);
      for (std::size_t x = 1; x <= cnf.variables(); ++x) {
        result.model[x] = solver.val(static_cast<int>(x)) > 0;
      }
    } else if (answer == unsatisfiable) {
      result.answer = SatAnswer::unsatisfiable;
    }
    if (proof.file() != nullptr) {
      solver.close_proof_trace();
    }
  }
  terminator.rethrow();
  proof.close();
  return result;
} catch (const std::bad_alloc&) {
  throw MissingResource(
      fmt::format("not enough memory to solve a formula of {} clauses; ask for something smaller",
                  cnf.clauses()));
}

}  // namespace changeover
