// What verbs that search share: limits, threads, seed, progress on stderr, and Ctrl-C.
//
//     RunRequest run;
//     run.add_to(verb, "60s", output);
//     …
//     const auto running = std::make_shared<Running>(run, output);  // now Ctrl-C stops it
//     auto result = improve(p, options, running->control());
//     running->finish();
//     return final_answer(running, show_design(…));
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "answer/answer.hpp"
#include "changeover/run/control.hpp"
#include "cli/cli.hpp"
#include "request/output.hpp"

namespace changeover::cli {

/// "90", "90s", "1.5m", "2h", "250ms": a duration, in seconds unless it says otherwise.
/// @throws UsageError that names `option`.
[[nodiscard]] std::chrono::duration<double> parse_duration(const std::string& text,
                                                           const std::string& option);

/// "500M", "4G", "4000000000": a number of bytes, in powers of 1000. @throws UsageError that names
/// `option`.
[[nodiscard]] std::uint64_t parse_size(const std::string& text, const std::string& option);

/// [--time DURATION] [--memory SIZE] [--threads N] [--seed N] [--quiet].
struct RunRequest {
  std::string time;
  std::string memory;
  std::optional<std::uint64_t> threads;
  std::optional<std::uint64_t> seed;
  bool quiet = false;

  /// `default_time` as in "60s", or "" for no limit. What is searched for is precious to `output`.
  void add_to(Verb& verb, const std::string& default_time, OutputRequest& output);

  /// The same without --seed, for what draws no random numbers, and perhaps without --threads.
  void add_limits_to(Verb& verb, const std::string& default_time, OutputRequest& output,
                     bool uses_threads = true);

  /// The options as they would be typed, for provenance: "--seed 7 --threads 2 --time 60s". What
  /// draws no random numbers has no seed.
  [[nodiscard]] std::string command(bool seeded = true) const;

  /// What a control needs of it; the rest is added by Running. @throws UsageError if an option is
  /// wrong.
  [[nodiscard]] RunControl::Settings settings() const;

  std::string default_time;
};

/// A search under way: its control, which this thread listens to (run/control.hpp), its progress on
/// stderr, and Ctrl-C, SIGTERM or a terminal that goes away, which ask it to stop; a second Ctrl-C
/// ends the process. One at a time. Knows the team (team.hpp): only its first member shows
/// progress.
class Running {
 public:
  /// @throws UsageError if an option is wrong; MissingResource if the output cannot be written.
  Running(const RunRequest& request, const OutputRequest& output);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] RunControl& control();

  /// The search is over: no progress is shown any more, and this thread listens to no limit while
  /// what was found is verified and written.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The answer of a search: of several processes that share it the first one speaks, and Ctrl-C does
/// not end the process before it is delivered.
[[nodiscard]] Answer final_answer(std::shared_ptr<Running> running, Answer answer);

/// Work without its own limits: what lasts longer than a second is told on a terminal, tables
/// that half of the machine's memory does not hold are refused, and Ctrl-C ends the process. For
/// the whole program; a Running takes its place while it lives.
class Watched {
 public:
  Watched();
  ~Watched();
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::cli
