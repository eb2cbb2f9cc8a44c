#include "changeover/run/control.hpp"

namespace changeover {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): the scope of a thread
thread_local RunControl* innermost = nullptr;

}  // namespace

RunScope::RunScope(RunControl& control) : outer_(innermost) { innermost = &control; }

RunScope::~RunScope() { innermost = outer_; }

RunControl* RunScope::current() { return innermost; }

void stop_if_asked() {
  if (innermost != nullptr && innermost->stop_wanted()) {
    throw Stopped(innermost->why_stopped());
  }
}

void require_memory(std::uint64_t bytes, std::string_view what) {
  if (innermost != nullptr) {
    innermost->require_memory(bytes, what);
  }
}

bool progress_due() { return innermost != nullptr && innermost->progress_due(); }

void report_progress(const Progress& progress) {
  if (innermost != nullptr) {
    innermost->tell(progress);
  }
}

}  // namespace changeover
