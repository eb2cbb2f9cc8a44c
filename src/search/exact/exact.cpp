#include "changeover/search/exact.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <limits>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/io/output.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "io/file/remedies.hpp"
#include "run/threads.hpp"
#include "search/exact/exact_encoding.hpp"
#include "search/exact/exact_wanted.hpp"
#include "search/sat/sat_solver.hpp"

namespace changeover {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

constexpr Seconds no_limit = std::chrono::hours(24 * 365 * 100);

/// Processor time of this thread, which does not depend on other programs.
class Stopwatch {
 public:
  [[nodiscard]] Seconds elapsed() const { return now() - begin_; }

 private:
  static Seconds now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

  Seconds begin_ = now();
};

void require_regular(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw MissingResource(
        path + ": not a regular file, so a proof in it cannot be checked; name another folder");
  }
}

std::string proof_folder(const ExactOptions& options) {
  std::error_code error;
  if (options.proof_directory.empty()) {
    fs::path folder = fs::temp_directory_path(error);
    return error ? "." : folder.string();
  }
  make_folder(options.proof_directory);
  return options.proof_directory;
}

// Each of several threads or processes needs its own part of a question.
bool must_split(const ExactOptions& options, const RunControl& control) {
  return options.cubes > 1 || control.threads() > 1 || control.settings().share.of > 1;
}

/// One question, with or without cubes.
class Question {
 public:
  Question(const Parameters& p, std::uint64_t b, const ExactOptions& options, RunControl& control)
      : options_(options),
        control_(control, options.time_per_step.value_or(no_limit)),
        stem_(file_stem(p, b, options.wanted)) {
    decision_.parameters = p;
    decision_.b = b;
  }

  Decision run() {
    const auto begin = RunControl::Clock::now();
    const WorkShare share = control_.settings().share;
    if (share.of == 0 || share.index >= share.of) {
      throw BadInput(fmt::format("share {} of {}: the index must be below the number of shares",
                                 share.index, share.of));
    }
    if (options_.prove) {
      folder_ = proof_folder(options_);
    }
    try {
      solve(share);
    } catch (const MissingResource&) {
      if (!decision_.design) {
        throw;  // With a design, the fault of another thread does not matter.
      }
    } catch (const std::bad_alloc&) {
      throw MissingResource(fmt::format("not enough memory for {}; ask for something smaller",
                                        formula_name(decision_.parameters, decision_.b)));
    }
    conclude(share);
    decision_.time = RunControl::Clock::now() - begin;
    return std::move(decision_);
  }

 private:
  void solve(const WorkShare& share) {
    const RunScope scope(control_);
    try {
      const unsigned threads = require_room(decision_.parameters, decision_.b, options_, control_);
      formula_.emplace(
          encode_design(decision_.parameters, decision_.b, options_.encoding, options_.wanted));
      if (must_split(options_, control_)) {
        split(share);
      } else {
        cubes_.emplace_back();
      }
      mine_ = (cubes_.size() - share.index + share.of - 1) / share.of;
      work(share, static_cast<unsigned>(std::min<std::uint64_t>(threads, mine_)));
    } catch (const Stopped&) {
      // The control knows the reason, and mine_ whether there was work yet.
    }
  }

  // About 16 cubes per process, or 8 per thread: enough to balance their times.
  void split(const WorkShare& share) {
    const std::uint64_t wanted = options_.cubes > 0 ? options_.cubes
                                 : share.of > 1
                                     ? 16 * share.of
                                     : 8 * static_cast<std::uint64_t>(control_.threads());
    constexpr int deepest = 12;
    const auto depth = std::min(static_cast<int>(std::bit_width(wanted - 1)), deepest);
    const std::uint64_t places = decision_.b * decision_.parameters.v;
    cubes_ = split_into_cubes(formula_->cnf(), static_cast<std::size_t>(places),
                              static_cast<unsigned>(depth));
    if (!cubes_cover_everything(cubes_)) {
      throw InternalError(fmt::format("the cubes of {} leave something out", stem_));
    }
    decision_.cubes = cubes_.size();
  }

  // The threads take the cubes of this process one after another, in order.
  void work(const WorkShare& share, unsigned threads) {
    std::atomic<std::uint64_t> next{share.index};
    run_together(control_, std::max(1U, threads), [&](unsigned) {
      while (!control_.stop_wanted()) {
        const std::uint64_t index = next.fetch_add(share.of);
        if (index >= cubes_.size()) {
          return;
        }
        solve_part(index);
      }
    });
  }

  [[nodiscard]] std::string path_of(std::uint64_t index, const char* ending) const {
    const std::string part =
        cubes_.size() == 1 ? "" : fmt::format("-part{}of{}", index + 1, cubes_.size());
    // Temporary files belong to this process alone.
    const std::string front =
        options_.proof_directory.empty() ? fmt::format("changeover-{}-", ::getpid()) : "";
    return (fs::path(folder_) / (front + stem_ + part + ending)).string();
  }

  [[nodiscard]] Progress progress(const char* doing) const {
    return {.phase = fmt::format("{} {} with {}", doing, name(decision_.parameters),
                                 count_of(decision_.b, "block")),
            .unit = "kB of proof"};
  }

  void solve_part(std::uint64_t index) {
    const Cube& cube = cubes_[index];
    SatOptions sat{.progress = progress("deciding"), .conflicts = options_.conflicts_per_step};
    if (!options_.prove) {
      const SatResult result = solve_sat(formula_->cnf(), cube, sat, control_);
      if (result.outcome == Outcome::found) {
        found(result);
      } else if (result.outcome == Outcome::none) {
        const std::scoped_lock lock(mutex_);
        ++unproved_;
      } else {
        control_.stop(WhyStopped::step_limit);  // unless the control stopped it
      }
      return;
    }
    OutputFile cnf(path_of(index, ".cnf"));
    OutputFile proof(path_of(index, ".drat"));
    write_dimacs(formula_->cnf(), cube, comments(index), cnf);
    cnf.flush();
    sat.proof_path = proof.path_until_commit();
    const Stopwatch solving;
    const SatResult result = solve_sat(formula_->cnf(), cube, sat, control_);
    if (result.outcome == Outcome::found) {
      found(result);
      return;
    }
    if (result.outcome != Outcome::none) {
      control_.stop(WhyStopped::step_limit);  // unless the control stopped it
      return;
    }
    CheckedPart part{.cube = cube, .solve_time = solving.elapsed()};
    if (!checked(cnf.path_until_commit(), sat.proof_path, part)) {
      return;
    }
    if (!options_.proof_directory.empty()) {
      part.cnf_path = path_of(index, ".cnf");
      part.proof_path = path_of(index, ".drat");
      cnf.commit();
      proof.commit();
    }
    const std::scoped_lock lock(mutex_);
    decision_.parts.push_back(std::move(part));
  }

  // A proof that the solver wrote, and that is completely on the disk, cannot be malformed.
  [[nodiscard]] ProofVerdict read_back(const std::string& cnf, const std::string& proof,
                                       const ProofOptions& limits) const {
    try {
      return check_proof_files(cnf, proof, limits);
    } catch (const BadInput& fault) {
      throw InternalError(fmt::format("the proof for {} cannot be read: {}", stem_, fault.what()));
    }
  }

  // False if the control stopped the check.
  bool checked(const std::string& cnf, const std::string& proof, CheckedPart& part) {
    require_regular(cnf);
    require_regular(proof);
    control_.tell(progress("checking the proof for"));
    const Stopwatch checking;
    ProofOptions limits{.stop = [this] { return control_.stop_wanted(); }};
    limits.max_variable = std::max<std::uint64_t>(limits.max_variable, formula_->cnf().variables());
    limits.max_literals = std::numeric_limits<std::uint32_t>::max();
    const ProofVerdict verdict = read_back(cnf, proof, limits);
    if (verdict.outcome == ProofVerdict::Outcome::stopped) {
      return false;
    }
    if (!verdict.verified()) {
      throw InternalError(fmt::format("the proof for {} does not check: line {}: {}", stem_,
                                      verdict.line, verdict.reason));
    }
    part.variables = verdict.variables;
    part.clauses = verdict.clauses;
    part.proof_steps = verdict.added + verdict.deleted + verdict.ignored_deletions;
    part.check_time = checking.elapsed();
    std::error_code error;
    part.proof_bytes = fs::file_size(proof, error);
    return true;
  }

  [[nodiscard]] std::vector<std::string> comments(std::uint64_t index) const {
    const Parameters& p = decision_.parameters;
    std::vector<std::string> lines{
        fmt::format("There is a {} with {}{}.", name(p), count_of(decision_.b, "block"),
                    wanted_words(options_.wanted)),
        fmt::format("Block i holds element e, from 0: variable {} i + e + 1.", p.v)};
    std::ranges::copy(lines_of(formula_->wanted()), std::back_inserter(lines));
    if (cubes_.size() > 1) {
      lines.push_back(
          fmt::format("Part {} of {}: the last {} clauses are its cube; see the list of cubes "
                      "beside this file.",
                      index + 1, cubes_.size(), cubes_[index].size()));
    }
    return lines;
  }

  void found(const SatResult& result) {
    // The time may be over, but a design that was found is verified anyway.
    RunControl unhurried({});
    const RunScope scope(unhurried);
    Design design = formula_->decode([&](Literal x) { return result.is_true(x); });
    design.recipe = literal_recipe(design, "search by SAT");
    VerifiedDesign solution = surely_verified(std::move(design), "a solution of " + stem_);
    auto subsets =
        parts_as_wanted(solution, options_.wanted,
                        formula_->chosen_positions([&](Literal x) { return result.is_true(x); }));
    if (!subsets) {
      throw InternalError(fmt::format("a solution of {} has not what is wanted", stem_));
    }
    const std::scoped_lock lock(mutex_);
    if (!decision_.design) {
      decision_.design = std::move(solution);
      decision_.subsets = *std::move(subsets);
    }
    control_.stop(WhyStopped::found);
  }

  void conclude(const WorkShare& share) {
    if (decision_.design) {
      discard_proofs();
      decision_.outcome = Outcome::found;
      decision_.why_stopped = WhyStopped::found;
      return;
    }
    if (formula_ == std::nullopt || cubes_.empty() || decision_.parts.size() + unproved_ < mine_) {
      decision_.outcome = Outcome::unknown;
      decision_.why_stopped = control_.why_stopped();
      return;
    }
    decision_.why_stopped = WhyStopped::exhausted;
    decision_.outcome = Outcome::none;
    decision_.proved = options_.prove;
    decision_.in_share = share.of > 1;
    std::ranges::sort(decision_.parts, {}, [](const CheckedPart& part) {
      return std::pair(part.cnf_path.size(),
                       std::string_view(part.cnf_path));  // part 2 before part 10
    });
    if (cubes_.size() > 1 && options_.prove && !options_.proof_directory.empty()) {
      write_cubes();
    }
  }

  // Only parts were excluded, not the whole.
  void discard_proofs() {
    std::error_code ignored;
    for (const CheckedPart& part : decision_.parts) {
      fs::remove(part.cnf_path, ignored);
      fs::remove(part.proof_path, ignored);
    }
    decision_.parts.clear();
  }

  void write_cubes() {
    decision_.cubes_path = (fs::path(folder_) / (stem_ + ".cubes")).string();
    OutputFile file(decision_.cubes_path);
    for (const Cube& cube : cubes_) {
      std::string line = "a ";
      for (const Literal literal : cube) {
        line += fmt::format("{} ", literal);
      }
      file.write(line + "0\n");
    }
    file.commit();
  }

  const ExactOptions& options_;
  RunControl control_;
  std::string stem_;
  std::string folder_;
  std::optional<DesignFormula> formula_;
  std::vector<Cube> cubes_;
  std::mutex mutex_;
  Decision decision_;
  std::uint64_t unproved_ = 0;
  std::uint64_t mine_ = 0;  // number of cubes of this process
};

}  // namespace

unsigned require_room(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                      const RunControl& control) {
  if (options.prove) {
    (void)proof_folder(options);
  }
  const CnfSize size = design_formula_size(p, b, options.encoding, options.wanted);
  SolvingNeeds needs{
      .proof = options.prove, .split = must_split(options, control), .threads = control.threads()};
  const auto limit = control.settings().memory_bytes;
  while (limit && needs.threads > 1 && solving_bytes(size, needs) > *limit) {
    --needs.threads;
  }
  control.require_memory(solving_bytes(size, needs), formula_name(p, b));
  return needs.threads;
}

std::string file_stem(const Parameters& p, std::optional<std::uint64_t> b, const Wanted& wanted) {
  constexpr std::size_t digits = 16;
  return fmt::format(
      "{}-m{}-v{}-k{}{}{}{}", to_string(p.kind), p.change, p.v, p.k,
      p.strength == 2 ? std::string() : fmt::format("-t{}", p.strength),
      b ? fmt::format("-b{}", *b) : std::string(),
      wanted.any()
          ? "-with-" +
                to_hex(sha256(wanted_words(wanted, wanted.contained.size()))).substr(0, digits)
          : std::string());
}

Decision decide(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                RunControl& control) {
  check(p);
  if (b == 0) {
    throw BadInput("a design has at least one block");
  }
  if (const std::string defect = wanted_defect(p, options.wanted); !defect.empty()) {
    throw BadInput(defect);
  }
  return Question(p, b, options, control).run();
}

}  // namespace changeover
