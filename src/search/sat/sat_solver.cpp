#include "search/sat/sat_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
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
        fmt::format("{}: cannot write the proof: {}; free some space or name another directory",
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

namespace {

/// Unit propagation by counters, which is enough for look-ahead at a few hundred places.
class Lookahead {
 public:
  explicit Lookahead(const Cnf& cnf) : value_(cnf.variables() + 1, 0), within_(2 * value_.size()) {
    const std::span<const Literal> all = cnf.literals();
    for (std::size_t begin = 0; begin < all.size();) {
      ask_now_and_then();
      std::size_t end = begin;
      while (all[end] != 0) {
        within_[index(all[end])].push_back(clauses_.size());
        ++end;
      }
      clauses_.push_back(all.subspan(begin, end - begin));
      begin = end + 1;
    }
    open_.reserve(clauses_.size());
    for (const auto& clause : clauses_) {
      ask_now_and_then();
      open_.push_back(clause.size());
      consistent_ = consistent_ && !clause.empty();
      if (clause.size() == 1) {
        consistent_ = assign(clause.front()) && consistent_;
      }
    }
    consistent_ = consistent_ && propagate();
  }

  [[nodiscard]] bool consistent() const { return consistent_; }
  [[nodiscard]] bool is_open(Literal x) const { return value_of(x) == 0; }
  [[nodiscard]] std::size_t trail() const { return trail_.size(); }

  /// Assumes x and propagates; returns false on a contradiction. Call undo() afterwards.
  bool assume(Literal x) { return assign(x) && propagate(); }

  void undo(std::size_t trail) {
    while (trail_.size() > trail) {
      const Literal x = trail_.back();
      trail_.pop_back();
      if (trail_.size() < propagated_) {
        for (const std::size_t c : within_[index(-x)]) {
          ++open_[c];
        }
      }
      value_[variable(x)] = 0;
    }
    propagated_ = std::min(propagated_, trail);
  }

 private:
  // An exception leaves the counters inconsistent; they are not read any more.
  void ask_now_and_then() {
    constexpr unsigned often = 1024;
    if (++steps_ % often == 0) {
      stop_if_asked();
    }
  }
  static std::size_t variable(Literal x) { return static_cast<std::size_t>(x < 0 ? -x : x); }
  static std::size_t index(Literal x) { return 2 * variable(x) + (x < 0 ? 1U : 0U); }
  [[nodiscard]] int value_of(Literal x) const {
    return x > 0 ? value_[variable(x)] : -value_[variable(x)];
  }

  bool assign(Literal x) {
    if (value_of(x) == 0) {
      value_[variable(x)] = x > 0 ? 1 : -1;
      trail_.push_back(x);
    }
    return value_of(x) > 0;
  }

  // open_[c]: literals of the clause that are not false, according to the part of the trail that
  // was propagated.
  bool propagate() {
    bool consistent = true;
    while (consistent && propagated_ < trail_.size()) {
      ask_now_and_then();
      const Literal x = trail_[propagated_++];
      for (const std::size_t c : within_[index(-x)]) {
        --open_[c];
        if (open_[c] > 1 || !consistent) {
          continue;  // every counter is updated, as undo() expects it
        }
        const auto& clause = clauses_[c];
        const auto unit = std::ranges::find_if(clause, [&](Literal y) { return value_of(y) >= 0; });
        consistent = unit != clause.end() && assign(*unit);
      }
    }
    return consistent;
  }

  std::vector<std::span<const Literal>> clauses_;
  std::vector<std::int8_t> value_;
  std::vector<std::vector<std::size_t>> within_;  // clauses, by literal
  std::vector<std::size_t> open_;
  std::vector<Literal> trail_;
  std::size_t propagated_ = 0;
  bool consistent_ = true;
  unsigned steps_ = 0;
};

/// The literal to branch on, with the value that fixes more; 0 if there is none.
Literal best_branch(Lookahead& ahead, std::size_t candidates) {
  Literal best = 0;
  std::size_t most = 0;
  const std::size_t before = ahead.trail();
  for (Literal x = 1; x <= static_cast<Literal>(candidates); ++x) {
    if (!ahead.is_open(x)) {
      continue;
    }
    stop_if_asked();
    std::array<std::size_t, 2> fixes{};
    bool both = true;
    for (const Literal y : {x, -x}) {
      both = ahead.assume(y) && both;
      fixes[y > 0 ? 0 : 1] = ahead.trail() - before;
      ahead.undo(before);
    }
    const std::size_t product = fixes[0] * fixes[1];
    if (both && product > most) {
      most = product;
      best = fixes[0] >= fixes[1] ? x : -x;
    }
  }
  return best;
}

}  // namespace

std::vector<Cube> split_into_cubes(const Cnf& cnf, std::size_t candidates, unsigned depth) {
  if (candidates > cnf.variables()) {
    throw InternalError("a formula is to be split on variables that it has not");
  }
  Lookahead ahead(cnf);
  std::vector<Cube> leaves;
  std::vector<Cube> open{{}};
  while (!open.empty()) {
    Cube cube = std::move(open.back());
    open.pop_back();
    const std::size_t before = ahead.trail();
    bool consistent = ahead.consistent();
    for (const Literal x : cube) {
      consistent = consistent && ahead.assume(x);
    }
    const Literal branch = consistent && cube.size() < depth ? best_branch(ahead, candidates) : 0;
    ahead.undo(before);
    if (branch == 0) {
      leaves.push_back(std::move(cube));
      continue;
    }
    for (const Literal x : {-branch, branch}) {
      open.emplace_back(cube).push_back(x);
    }
  }
  return leaves;
}

}  // namespace changeover
