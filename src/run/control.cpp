#include "changeover/run/control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

constexpr std::chrono::milliseconds question_interval{20};

RunControl::Clock::duration ticks(std::chrono::duration<double> time) {
  return std::chrono::duration_cast<RunControl::Clock::duration>(time);
}

std::string size_words(std::uint64_t bytes) {
  constexpr double kilo = 1e3, mega = 1e6, giga = 1e9;
  const auto size = static_cast<double>(bytes);
  return size < kilo   ? fmt::format("{} bytes", bytes)
         : size < mega ? fmt::format("{:.1f} kB", size / kilo)
         : size < giga ? fmt::format("{:.1f} MB", size / mega)
                       : fmt::format("{:.1f} GB", size / giga);
}

// A limit so far away that the clock cannot hold it is none.
std::optional<RunControl::Clock::time_point> end_after(
    RunControl::Clock::time_point begin, std::optional<std::chrono::duration<double>> time) {
  constexpr std::chrono::duration<double> forever = std::chrono::hours(24 * 365 * 50);
  if (!time || !(*time < forever)) {
    return std::nullopt;
  }
  return begin + ticks(std::max(*time, std::chrono::duration<double>::zero()));
}

}  // namespace

std::string_view to_string(WhyStopped why) {
  constexpr std::array<std::string_view, 8> words{"running",         "found",      "exhausted",
                                                  "time limit",      "step limit", "interrupted",
                                                  "found elsewhere", "a fault"};
  return words.at(static_cast<std::size_t>(why));
}

RunControl::RunControl(Settings settings)
    : settings_(std::move(settings)), end_(end_after(begin_, settings_.time)) {}

RunControl::RunControl(RunControl& parent, std::chrono::duration<double> time,
                       std::optional<std::uint64_t> seed)
    : settings_(parent.settings_), parent_(&parent), end_(end_after(begin_, time)) {
  settings_.time = time;
  settings_.seed = seed.value_or(settings_.seed);
}

RunControl::RunControl(RunControl& parent, Questions questions)
    : settings_(parent.settings_), parent_(&parent), questions_(questions.most) {
  settings_.time.reset();
}

std::unique_ptr<RunControl> RunControl::beyond_limit(RunControl& parent) {
  auto control = std::make_unique<RunControl>(parent, Questions{~std::uint64_t{0}});
  control->parents_limit_counts_ = false;
  return control;
}

RunControl::RunControl(RunControl& parent, unsigned threads)
    : settings_(parent.settings_), parent_(&parent), quiet_(true) {
  settings_.threads = threads;
}

void RunControl::require_memory(std::uint64_t bytes, std::string_view what) const {
  const auto limit = settings_.memory_bytes;
  if (limit && bytes > *limit) {
    throw MissingResource(
        fmt::format("{} would take about {} of memory, more than the {} allowed; "
                    "raise the memory limit, or give smaller parameters",
                    what, size_words(bytes), size_words(*limit)));
  }
}

bool RunControl::stop_wanted() { return stops(true); }

bool RunControl::stops(bool by_its_limit) {
  const WhyStopped why = why_stopped();
  const bool at_its_limit = why == WhyStopped::time_limit || why == WhyStopped::step_limit;
  if (why != WhyStopped::running && (by_its_limit || !at_its_limit)) {
    return true;
  }
  if (parent_ != nullptr) {
    if (parent_->stops(parents_limit_counts_)) {
      stop(parent_->why_stopped());
      return true;
    }
  } else if (settings_.interrupted != nullptr &&
             settings_.interrupted->load(std::memory_order_relaxed)) {
    stop(WhyStopped::interrupted);
    return true;
  }
  const Clock::time_point now = Clock::now();
  if (by_its_limit && end_ && now >= *end_) {
    stop(WhyStopped::time_limit);
    for (RunControl* each = this; each != nullptr; each = each->parent_) {
      each->time_was_up_.store(true, std::memory_order_relaxed);
    }
    return true;
  }
  if (by_its_limit && questions_ && asked_++ >= *questions_) {
    stop(WhyStopped::step_limit);
    return true;
  }
  if (parent_ == nullptr && settings_.found_elsewhere) {
    const Clock::rep tick = now.time_since_epoch().count();
    if (tick >= next_question_.load(std::memory_order_relaxed)) {
      const std::unique_lock lock(asking_, std::try_to_lock);
      if (lock.owns_lock()) {
        next_question_ = (now + question_interval).time_since_epoch().count();
        if (settings_.found_elsewhere()) {
          stop(WhyStopped::elsewhere);
          return true;
        }
      }
    }
  }
  return false;
}

void RunControl::stop(WhyStopped why) {
  WhyStopped running = WhyStopped::running;
  why_.compare_exchange_strong(running, why);
}

std::optional<std::chrono::duration<double>> RunControl::time_left() const {
  std::optional<std::chrono::duration<double>> left;
  if (end_) {
    left = std::max<std::chrono::duration<double>>(*end_ - Clock::now(),
                                                   std::chrono::duration<double>::zero());
  }
  if (parent_ != nullptr) {
    const auto of_parent = parent_->time_left();
    if (of_parent && (!left || *of_parent < *left)) {
      left = of_parent;
    }
  }
  return left;
}

bool RunControl::progress_due() const {
  if (quiet_) {
    return false;
  }
  if (parent_ != nullptr) {
    return parent_->progress_due();
  }
  return settings_.on_progress &&
         Clock::now().time_since_epoch().count() >= next_progress_.load(std::memory_order_relaxed);
}

void RunControl::tell(Progress progress, bool now) {
  if (quiet_) {
    return;
  }
  if (parent_ != nullptr) {
    parent_->tell(std::move(progress), now);
    return;
  }
  if (!settings_.on_progress || (!now && !progress_due())) {
    return;
  }
  const std::scoped_lock lock(telling_);
  if (!now && !progress_due()) {
    return;  // Another thread was faster.
  }
  next_progress_ = (Clock::now() + ticks(settings_.progress_interval)).time_since_epoch().count();
  progress.elapsed = elapsed();
  progress.left = time_left();
  settings_.on_progress(progress);
}

}  // namespace changeover
