// What verbs that search share: limits, threads, seed, progress on stderr, and Ctrl-C.
//
//     RunRequest run;
//     run.add_to(verb);
//     …
//     Running running(run, output);               // from here on Ctrl-C asks the search to stop
//     auto result = improve(p, options, running.control());
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "changeover/run/control.hpp"
#include "cli.hpp"
#include "request.hpp"

namespace changeover::cli {

/// "90", "90s", "1.5m", "2h", "250ms": a duration, in seconds unless it says otherwise.
/// @throws UsageError that names `option`.
[[nodiscard]] std::chrono::duration<double> parse_duration(const std::string& text,
                                                           const std::string& option);

/// [--time DURATION] [--threads N] [--seed N] [--quiet].
struct RunRequest {
  std::string time;
  std::optional<std::uint64_t> threads;
  std::optional<std::uint64_t> seed;
  bool quiet = false;

  /// `default_time` as in "60s", or "" for no limit.
  void add_to(Verb& verb, const std::string& default_time);

  /// The options as they would be typed, for provenance: "--seed 7 --threads 2 --time 60s".
  [[nodiscard]] std::string command() const;

  std::string default_time;
};

/// A search under way: its control, its progress on stderr, and Ctrl-C, which asks it to stop; a second
/// Ctrl-C ends the process. One at a time. Knows the team (team.hpp): only its first member shows progress.
class Running {
 public:
  /// @throws UsageError if an option is wrong; MissingResource if the output cannot be written.
  Running(const RunRequest& request, const OutputRequest& output);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] RunControl& control();

  /// Ends the progress line, so that an answer can be written.
  void finish_progress();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::cli
