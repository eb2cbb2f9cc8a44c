#include "search/sat/sat_solver.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "search/sat/sat_engine.hpp"

namespace changeover {
namespace {

namespace fs = std::filesystem;

// From this number of literals on, a pass over the formula takes noticeable time: the solver then
// checks wherever it can whether to stop, not only every tenth time. The result does not depend on
// that.
constexpr std::size_t large = 1'000'000;

/// A proof that is written to the disk by the solver, which does not detect write errors.
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
      // The system's reason is lost by now; writing further bytes fails for the same reason.
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
      fail();  // cut short without the solver noticing
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

}  // namespace

SatResult solve_sat(const Cnf& cnf, std::span<const Literal> assumptions, const SatOptions& options,
                    RunControl& control) {
  SatResult result;
  if (control.stop_wanted()) {
    return result;
  }
  ProofFile proof(options.proof_path);
  {
    SatEngine engine;
    if (cnf.literals().size() > large) {
      engine.set("terminateint", 0);
    }
    if (proof.file() != nullptr) {
      engine.trace_proof(proof.file(), options.proof_path);
    }
    if (!engine.add(cnf, control)) {
      return result;
    }
    engine.add_units(assumptions);
    const auto progress = [&] {
      Progress now = options.progress;
      now.steps = proof.kilobytes();
      now.unit = "kB of proof";
      return now;
    };
    result.outcome =
        engine.solve(control, options.conflicts,
                     {.progress = progress, .give_up = [&] { return proof.failed(); }});
    if (result.outcome == Outcome::found) {
      result.model.assign(cnf.variables() + 1, false);
      for (std::size_t x = 1; x <= cnf.variables(); ++x) {
        result.model[x] = engine.holds(static_cast<Literal>(x));
      }
    }
    if (proof.file() != nullptr) {
      engine.close_proof();
    }
  }
  proof.close();
  return result;
}

}  // namespace changeover
