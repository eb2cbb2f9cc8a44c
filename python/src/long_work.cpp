#include "long_work.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "gil.hpp"

namespace changeover::python {
namespace {

namespace py = pybind11;

py::dict as_dict(const Progress& progress) {
  py::dict said;
  said["phase"] = progress.phase;
  said["steps"] = progress.steps;
  said["unit"] = std::string(progress.unit);
  said["best"] = progress.best;
  said["lower_bound"] = progress.lower_bound;
  said["missing"] = progress.missing;
  said["elapsed"] = progress.elapsed.count();
  said["left"] = progress.left ? py::cast(progress.left->count()) : py::none();
  return said;
}

// What was said last, at a later time.
Progress later(Progress said, std::chrono::duration<double> elapsed) {
  if (said.left) {
    const auto zero = std::chrono::duration<double>::zero();
    said.left = std::max(zero, *said.left - (elapsed - said.elapsed));
  }
  said.elapsed = elapsed;
  return said;
}

// What both threads see.
struct Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<Progress> latest;
  std::exception_ptr fault;
  bool done = false;
};

RunControl::Settings settings_of(const LongOptions& options, Shared& shared) {
  RunControl::Settings settings;
  if (options.seconds) {
    settings.time = std::chrono::duration<double>(*options.seconds);
  }
  settings.threads = static_cast<unsigned>(options.threads);
  settings.seed = options.seed;
  settings.share = options.share;
  if (!options.progress.is_none()) {
    settings.on_progress = [&shared](const Progress& progress) {
      const std::lock_guard lock(shared.mutex);
      shared.latest = progress;
      shared.changed.notify_one();
    };
  }
  return settings;
}

// The work of all threads.
class AllWork {
 public:
  static AllWork& instance() { return *all(); }

  // In a forked process there is no work yet, whatever its parent does. What the parent left is not
  // destroyed: a thread that is not here may hold its mutex.
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): on purpose
  static void begin_anew() { all() = new AllWork; }

  void begin(RunControl& control) {
    sleep_if_python_ends();
    const std::lock_guard lock(mutex_);
    running_.insert(&control);
  }

  void end(RunControl& control) {
    const std::lock_guard lock(mutex_);
    running_.erase(&control);
    changed_.notify_all();
  }

  // Then threads that are not waited for do not work any more. The thread that ends Python does,
  // and those that it starts and waits for: what is registered to be done at the end.
  void sleep_if_python_ends() {
    {
      const std::lock_guard lock(mutex_);
      if (!ender_ || *ender_ == std::this_thread::get_id()) {
        return;
      }
    }
    if (nobody_waits()) {
      const GilReleased released;
      sleep_for_ever();
    }
  }

  void stop_and_wait() {
    std::unique_lock lock(mutex_);
    ender_ = std::this_thread::get_id();
    for (RunControl* const control : running_) {
      control->stop(WhyStopped::interrupted);
    }
    // No longer for functions of the caller that do not return.
    constexpr auto most = std::chrono::seconds(2);
    changed_.wait_for(lock, most, [this] { return running_.empty(); });
  }

 private:
  static AllWork*& all() {
    static auto* work = new AllWork;  // never destroyed: threads outlive what is
    return work;
  }

  static bool nobody_waits() {
    try {
      const py::object current = py::module_::import("threading").attr("current_thread");
      const py::object thread = made_by_python([&] { return PyObject_CallNoArgs(current.ptr()); });
      return thread.attr("daemon").cast<bool>();
    } catch (py::error_already_set&) {
      return true;
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<RunControl*> running_;
  std::optional<std::thread::id> ender_;
};

}  // namespace

void stop_long_work_at_the_end() {
  pthread_atfork(nullptr, nullptr, AllWork::begin_anew);
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    const GilReleased released;
    AllWork::instance().stop_and_wait();
  }));
}

LongWork::LongWork(LongOptions options) : options_(std::move(options)) {
  if (options_.seconds && !(*options_.seconds >= 0 && *options_.seconds <= most_seconds)) {
    throw BadInput(fmt::format("time is a number of seconds, 0 to {}", most_seconds));
  }
  if (options_.threads < 1 || options_.threads > most_threads) {
    throw BadInput(fmt::format("threads is a number from 1 to {}", most_threads));
  }
}

void LongWork::run(const std::function<void(RunControl&)>& work) {
  constexpr auto between_looks = std::chrono::milliseconds(50);
  constexpr auto between_words = std::chrono::seconds(1);
  Shared shared;
  RunControl control(settings_of(options_, shared));
  AllWork::instance().begin(control);
  std::thread worker;
  struct EndWithUs {  // whatever is thrown here
    RunControl& control;
    std::thread& worker;
    pid_t process;
    ~EndWithUs() {
      if (worker.joinable() && process != getpid()) {
        worker.detach();  // It is the parent's: a callback forked.
      } else if (worker.joinable()) {
        control.stop(WhyStopped::interrupted);
        worker.join();
      }
      AllWork::instance().end(control);
      AllWork::instance().sleep_if_python_ends();
    }
  };
  const EndWithUs end{control, worker, getpid()};
  try {
    worker = std::thread([&] {
      std::exception_ptr fault;
      try {
        const RunScope scope(control);
        work(control);
      } catch (...) {
        fault = std::current_exception();
      }
      const std::lock_guard lock(shared.mutex);
      shared.fault = fault;
      shared.done = true;
      shared.changed.notify_one();
    });
  } catch (const std::system_error&) {
    throw MissingResource(
        "a thread cannot be started; end other programs or raise the limit of processes");
  }
  std::exception_ptr raised;       // by a signal or the callback
  std::optional<Progress> before;  // what was said last
  for (bool done = false; !done;) {
    std::optional<Progress> latest;
    {
      const GilReleased released;
      std::unique_lock lock(shared.mutex);
      shared.changed.wait_for(lock, between_looks, [&] { return shared.done || shared.latest; });
      done = shared.done;
      latest = std::exchange(shared.latest, std::nullopt);
    }
    // Some work says nothing for long: then time goes on, at least.
    if (!latest && !done && before && control.elapsed() - before->elapsed >= between_words) {
      latest = later(*before, control.elapsed());
    }
    before = latest ? latest : before;
    try {
      if (latest && !raised && !interrupted_) {
        const py::dict said = as_dict(*latest);
        made_by_python([&] { return PyObject_CallOneArg(options_.progress.ptr(), said.ptr()); });
        if (end.process != getpid()) {
          throw MissingResource(
              "this process was forked by a progress function; the work is its parent's");
        }
      }
      if (!raised && PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
      }
    } catch (py::error_already_set& signal) {
      if (end.process != getpid()) {
        throw;
      }
      if (options_.keeps_best && signal.matches(PyExc_KeyboardInterrupt)) {
        interrupted_ = true;
      } else {
        raised = std::current_exception();
      }
      control.stop(WhyStopped::interrupted);
    }
  }
  worker.join();
  if (raised) {
    std::rethrow_exception(raised);
  }
  if (shared.fault) {
    try {
      std::rethrow_exception(shared.fault);
    } catch (const Stopped&) {
      if (interrupted_) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
      } else {
        PyErr_SetString(PyExc_TimeoutError, "the time was up before there was an answer");
      }
      throw py::error_already_set();
    }
  }
}

}  // namespace changeover::python
