#include "run/grace.hpp"

namespace changeover {

RunGrace::RunGrace(RunControl& control, std::optional<std::chrono::duration<double>> time)
    : outer_(control), time_(time), own_(settings(control)), scope_(own_) {}

// The parent may ask another process whether to stop: ask it now and then, not every time.
RunControl::Settings RunGrace::settings(RunControl& control) {
  RunControl::Settings settings;
  settings.memory_bytes = control.settings().memory_bytes;
  settings.threads = control.threads();
  settings.seed = control.seed();
  if (time_) {
    settings.found_elsewhere = [this] { return over(); };
  }
  if (control.settings().on_progress) {
    settings.on_progress = [&control](const Progress& progress) { control.tell(progress); };
    settings.progress_interval = control.settings().progress_interval;
  }
  return settings;
}

bool RunGrace::over() {
  if (!outer_.stop_wanted()) {
    return false;
  }
  const auto now = RunControl::Clock::now();
  if (!asked_) {
    asked_ = now;
  }
  return now - *asked_ >= *time_;
}

}  // namespace changeover
