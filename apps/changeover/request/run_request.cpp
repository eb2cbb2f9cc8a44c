#include "request/run_request.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <csignal>
#include <ctime>
#include <map>
#include <thread>

#include "answer/progress_line.hpp"
#include "changeover/run/control.hpp"
#include "cli/ending.hpp"
#include "cli/status_line.hpp"
#include "cli/team.hpp"

namespace changeover::cli {
namespace {

using Seconds = std::chrono::duration<double>;

std::atomic<bool> interrupted = false;
std::atomic<bool> is_over = false;  // the search: its answer is written
std::atomic<int> first_signal = 0;
std::atomic<std::int64_t> first_asked = 0;  // milliseconds of the monotonic clock
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler sets it");

// The first signal asks, the next one ends the process: unless it is the same once more, for a
// program that stops a process and then its whole group (timeout does) signals it twice.
void ask_to_stop(int signal) {
  constexpr std::int64_t at_once = 200;
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = std::int64_t{time.tv_sec} * 1000 + time.tv_nsec / 1'000'000;
  constexpr unsigned seconds_to_write = 3;
  if (!interrupted.exchange(true)) {
    first_asked = now;
    first_signal = signal;
    if (is_over) {
      ::alarm(seconds_to_write);  // a pipe may be full, and its reader not read
    }
  } else if (now - first_asked > at_once) {
    end_by_signal(signal);
  }
}

void end_by_first_signal(int /*alarm*/) { end_by_signal(first_signal); }

std::uint64_t half_of_the_memory() {
  const auto pages = ::sysconf(_SC_PHYS_PAGES);
  const auto page = ::sysconf(_SC_PAGESIZE);
  constexpr std::uint64_t fallback = 4'000'000'000;
  return pages > 0 && page > 0
             ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) / 2
             : fallback;
}

}  // namespace

Seconds parse_duration(const std::string& text, const std::string& option) {
  static const std::map<std::string, double> units{
      {"", 1}, {"s", 1}, {"ms", 1e-3}, {"m", 60}, {"min", 60}, {"h", 3600}, {"d", 86400}};
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  const auto unit = units.find({rest, end});
  constexpr Seconds most{most_seconds};
  if (failure != std::errc() || !(number >= 0) || unit == units.end() ||
      number * unit->second > most.count()) {
    throw UsageError{
        fmt::format("{} '{}' is not a duration; give a number with ms, s, m, h or d, as in 90s, at "
                    "most 36500d",
                    option, text)};
  }
  return Seconds(number * unit->second);
}

std::uint64_t parse_size(const std::string& text, const std::string& option) {
  static const std::map<std::string, std::uint64_t> units{{"", 1},
                                                          {"B", 1},
                                                          {"K", 1'000},
                                                          {"M", 1'000'000},
                                                          {"G", 1'000'000'000},
                                                          {"T", 1'000'000'000'000}};
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  const auto unit = units.find({rest, end});
  if (failure != std::errc() || unit == units.end() || number == 0 ||
      number > UINT64_MAX / unit->second) {
    throw UsageError{fmt::format(
        "{} '{}' is not a size; give a whole number of bytes, 1 to 18446744T, or with K, M, G or "
        "T, as in 4G",
        option, text)};
  }
  return number * unit->second;
}

void RunRequest::add_to(Verb& verb, const std::string& limit, OutputRequest& output) {
  add_limits_to(verb, limit, output);
  verb.option("--seed", seed, "N", "seed of the random numbers (default 1)");
}

void RunRequest::add_limits_to(Verb& verb, const std::string& limit, OutputRequest& output,
                               bool uses_threads) {
  default_time = limit;
  output.precious = true;
  verb.option("--time", time, "DURATION",
              limit == "0s"
                  ? "how long to search for a better answer, e.g. 90s, 5m, 2h (default: not)"
                  : "stop after this time, e.g. 90s, 5m, 2h (default " +
                        (limit.empty() ? std::string("no limit") : limit) + ")");
  verb.option("--memory", memory, "SIZE",
              "memory for tables and formulas, e.g. 4G (default: half of the machine's)");
  if (uses_threads) {
    verb.option("--threads", threads, "N", "threads to use (default: all cores)");
  }
  verb.flag("--quiet", quiet, "no progress on stderr");
}

std::string RunRequest::command(bool seeded) const {
  std::vector<std::string> options;
  if (seeded) {
    options.push_back(fmt::format("--seed {}", seed.value_or(1)));
  }
  if (threads) {
    options.push_back(fmt::format("--threads {}", *threads));
  }
  if (!time.empty()) {
    options.push_back("--time " + time);
  }
  return fmt::format("{}", fmt::join(options, " "));
}

RunControl::Settings RunRequest::settings() const {
  RunControl::Settings settings;
  const std::string& limit = time.empty() ? default_time : time;
  if (!limit.empty()) {
    settings.time = parse_duration(limit, "--time");
  }
  settings.memory_bytes = memory.empty() ? half_of_the_memory() : parse_size(memory, "--memory");
  if (threads && (*threads == 0 || *threads > most_threads)) {
    throw UsageError{
        fmt::format("--threads {} is out of range; give 1 to {}", *threads, most_threads)};
  }
  settings.threads = static_cast<unsigned>(threads.value_or(
      std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, most_threads)));
  settings.seed = seed.value_or(1);
  return settings;
}

struct Running::State {
  std::unique_ptr<RunControl> control;
  std::optional<RunScope> scope;
  static constexpr std::array<int, 5> signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM};
  std::array<struct sigaction, signals.size()> old_actions{};
};

Running::Running(const RunRequest& request, const OutputRequest& output)
    : state_(std::make_unique<State>()) {
  RunControl::Settings settings = request.settings();
  output.check_writable();
  const Team& team = Team::world();
  // Members of a team share the machine unless they say otherwise.
  settings.threads = request.threads || team.size() == 1 ? settings.threads : 1;
  settings.share = {team.index(), team.size()};
  settings.interrupted = &interrupted;
  if (team.size() > 1) {
    settings.found_elsewhere = [] { return Team::world().heard(); };
  }
  if (!request.quiet && team.index() == 0) {
    settings.on_progress = [](const Progress& progress) {
      StatusLine& line = status_line();
      line.show(progress_line(progress, line.width()), progress.elapsed);
    };
  }
  state_->control = std::make_unique<RunControl>(std::move(settings));
  state_->scope.emplace(*state_->control);

  interrupted = is_over = false;
  struct sigaction action {};
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < State::signals.size(); ++i) {
    ::sigaction(State::signals[i], nullptr, &state_->old_actions[i]);
    const bool by_nohup =
        State::signals[i] == SIGHUP && state_->old_actions[i].sa_handler == SIG_IGN;
    action.sa_handler = State::signals[i] == SIGALRM ? end_by_first_signal : ask_to_stop;
    if (!by_nohup) {
      ::sigaction(State::signals[i], &action, nullptr);
    }
  }
}

Running::~Running() {
  finish();
  ::alarm(0);
  for (std::size_t i = 0; i < State::signals.size(); ++i) {
    ::sigaction(State::signals[i], &state_->old_actions[i], nullptr);
  }
}

RunControl& Running::control() { return *state_->control; }

void Running::finish() {
  state_->scope.reset();
  status_line().clear();
  is_over = true;
}

Answer final_answer(std::shared_ptr<Running> running, Answer answer) {
  if (!Team::world().first()) {
    answer.write = nullptr;
  }
  answer.held = std::move(running);
  return answer;
}

struct Watched::State {
  RunControl control;
  RunScope scope{control};

  static RunControl::Settings settings() {
    RunControl::Settings settings;
    settings.memory_bytes = half_of_the_memory();
    if (status_line().on_terminal()) {
      settings.on_progress = [](const Progress& progress) {
        constexpr Seconds patience{1};
        if (progress.elapsed >= patience) {
          StatusLine& line = status_line();
          line.show(progress_line(progress, line.width()), progress.elapsed);
        }
      };
    }
    return settings;
  }
};

Watched::Watched() : state_(new State{.control = RunControl(State::settings())}) {}

Watched::~Watched() { status_line().clear(); }

}  // namespace changeover::cli
