#include "run_request.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <thread>

#include "request.hpp"
#include "team.hpp"

namespace changeover::cli {
namespace {

using Seconds = std::chrono::duration<double>;

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

// The first signal asks, the next one ends the process.
void ask_to_stop(int signal) {
  if (interrupted.exchange(true)) {
    remove_unfinished_outputs();
    ::signal(signal, SIG_DFL);
    ::raise(signal);
  }
}

std::string clock_time(Seconds time) {
  const auto whole = static_cast<std::uint64_t>(std::max(0.0, std::ceil(time.count())));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  return whole < 3600 ? fmt::format("{}:{:02} min", whole / 60, whole % 60)
                      : fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

std::string short_number(double number) {
  if (number < 1e4) {
    return fmt::format("{:.0f}", number);
  }
  return number < 1e7 ? fmt::format("{:.0f} k", number / 1e3)
                      : fmt::format("{:.0f} M", number / 1e6);
}

std::string line_of(const Progress& progress) {
  std::string line = progress.phase;
  const double seconds = progress.elapsed.count();
  if (progress.steps > 0 && seconds > 0) {
    line += fmt::format("; {} {} ({}/s)", short_number(static_cast<double>(progress.steps)),
                        progress.unit, short_number(static_cast<double>(progress.steps) / seconds));
  }
  if (progress.missing) {
    line += fmt::format("; {} missing", *progress.missing);
  }
  if (progress.best) {
    line += fmt::format("; best {}", *progress.best);
  }
  if (progress.lower_bound) {
    line += fmt::format("; bound {}", *progress.lower_bound);
  }
  line += "; " + clock_time(progress.elapsed);
  return progress.left ? line + ", " + clock_time(*progress.left) + " left" : line;
}

// So that the line never wraps, which would leave its halves behind.
std::size_t progress_width() {
  constexpr std::size_t usual = 100;
  constexpr std::size_t least = 20;
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::max(least, known ? std::size_t{size.ws_col} : usual) - 1;
}

}  // namespace

Seconds parse_duration(const std::string& text, const std::string& option) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  const std::string unit(rest, end);
  const double scale = unit.empty() || unit == "s"    ? 1.0
                       : unit == "ms"                 ? 1e-3
                       : unit == "m" || unit == "min" ? 60.0
                       : unit == "h"                  ? 3600.0
                       : unit == "d"                  ? 86400.0
                                                      : 0.0;
  if (failure != std::errc() || !(number >= 0) || scale == 0.0) {
    throw UsageError{fmt::format(
        "{} '{}' is not a duration; give a number with ms, s, m, h or d, as in 90s", option, text)};
  }
  return Seconds(number * scale);
}

void RunRequest::add_to(Verb& verb, const std::string& limit) {
  default_time = limit;
  verb.option("--time", time, "DURATION",
              limit == "0s" ? "search so long for a better answer, e.g. 90s, 5m, 2h (default: not)"
                            : "stop after so long, e.g. 90s, 5m, 2h (default " +
                                  (limit.empty() ? std::string("no limit") : limit) + ")");
  verb.option("--threads", threads, "N", "threads to use (default: all cores)");
  verb.option("--seed", seed, "N", "of the random numbers (default 1)");
  verb.flag("--quiet", quiet, "no progress on stderr");
}

std::string RunRequest::command() const {
  std::string text = fmt::format("--seed {}", seed.value_or(1));
  if (threads) {
    text += fmt::format(" --threads {}", *threads);
  }
  return time.empty() ? text : text + " --time " + time;
}

struct Running::State {
  std::unique_ptr<RunControl> control;
  struct sigaction old_interrupt {};
  struct sigaction old_terminate {};
  bool terminal = false;
  std::size_t shown = 0;  // columns of the progress line that is on the terminal
  Seconds last_line{0};

  void show(const Progress& progress) {
    if (!terminal) {  // In a log: a line every ten seconds.
      constexpr Seconds interval{10};
      if (progress.elapsed >= last_line + interval) {
        last_line = progress.elapsed;
        fmt::print(stderr, "changeover: {}\n", line_of(progress));
      }
      return;
    }
    std::string line = line_of(progress);
    const std::size_t width = progress_width();
    if (line.size() > width) {
      line.resize(width);
    }
    const std::size_t columns = line.size();
    line.resize(std::max(columns, shown), ' ');
    shown = columns;
    fmt::print(stderr, "\r{}", line);
    std::fflush(stderr);
  }
};

Running::Running(const RunRequest& request, const OutputRequest& output)
    : state_(std::make_unique<State>()) {
  output.check_writable();
  constexpr std::uint64_t most_threads = 1024;
  const Team& team = Team::world();
  RunControl::Settings settings;
  const std::string& limit = request.time.empty() ? request.default_time : request.time;
  if (!limit.empty()) {
    settings.time = parse_duration(limit, "--time");
  }
  if (request.threads && (*request.threads == 0 || *request.threads > most_threads)) {
    throw UsageError{
        fmt::format("--threads {} is out of range; give 1 to {}", *request.threads, most_threads)};
  }
  // Members of a team share the machine unless they say otherwise.
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  settings.threads = request.threads   ? static_cast<unsigned>(*request.threads)
                     : team.size() > 1 ? 1
                                       : cores;
  settings.seed = request.seed.value_or(1);
  settings.share = {team.index(), team.size()};
  settings.interrupted = &interrupted;
  if (team.size() > 1) {
    settings.found_elsewhere = [] { return Team::world().heard(); };
  }
  state_->terminal = ::isatty(STDERR_FILENO) == 1;
  if (!request.quiet && team.index() == 0) {
    settings.on_progress = [state = state_.get()](const Progress& progress) {
      state->show(progress);
    };
  }
  state_->control = std::make_unique<RunControl>(std::move(settings));

  interrupted = false;
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, &state_->old_interrupt);
  ::sigaction(SIGTERM, &action, &state_->old_terminate);
}

Running::~Running() {
  finish_progress();
  ::sigaction(SIGINT, &state_->old_interrupt, nullptr);
  ::sigaction(SIGTERM, &state_->old_terminate, nullptr);
}

RunControl& Running::control() { return *state_->control; }

void Running::finish_progress() {
  if (state_->shown > 0) {
    fmt::print(stderr, "\r{}\r", std::string(state_->shown, ' '));
    state_->shown = 0;
  }
}

}  // namespace changeover::cli
