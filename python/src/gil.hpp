// The lock of Python's interpreter, taken such that nothing breaks if Python ends meanwhile.
//
// When Python ends, a thread that asks for the lock is ended where it asks (before Python 3.14):
// its stack is unwound, and what that destroys belongs to Python, which another thread takes apart
// just then. Such a thread sleeps here instead, until the process is gone.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>
#include <type_traits>

#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

namespace changeover::python {

[[noreturn]] inline void sleep_for_ever() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

/// What call() returns, unless Python ends this thread in it: then it sleeps. Nothing of Python's
/// may be destroyed when call() is left, so it is one function of Python's C interface.
template <typename Call>
#ifdef __GLIBCXX__
__attribute__((no_sanitize("undefined")))  // The reference that is caught refers to nothing.
#endif
std::invoke_result_t<Call>
unless_python_ends(Call&& call) {
#ifdef __GLIBCXX__
  try {
    return call();
  } catch (const abi::__forced_unwind&) {
    sleep_for_ever();
  }
#else
  return call();
#endif
}

/// A new reference to what a function of Python's C interface returns. @throws error_already_set if
/// it is nothing.
template <typename Call>
pybind11::object made_by_python(const Call& call) {
  PyObject* const made = unless_python_ends(call);
  if (made == nullptr) {
    throw pybind11::error_already_set();
  }
  return pybind11::reinterpret_steal<pybind11::object>(made);
}

/// Lets this thread, which Python need not know, run what is Python's, from here to the end of its
/// life.
class GilHeld {
 public:
  GilHeld() : state_(unless_python_ends([] { return PyGILState_Ensure(); })) {}
  ~GilHeld() { PyGILState_Release(state_); }
  GilHeld(const GilHeld&) = delete;
  GilHeld& operator=(const GilHeld&) = delete;

 private:
  PyGILState_STATE state_;
};

/// Lets other threads of Python run, from here to the end of its life.
class GilReleased {
 public:
  GilReleased() : state_(PyEval_SaveThread()) {}
  ~GilReleased() {
    unless_python_ends([this] { PyEval_RestoreThread(state_); });
  }
  GilReleased(const GilReleased&) = delete;
  GilReleased& operator=(const GilReleased&) = delete;

 private:
  PyThreadState* state_;
};

}  // namespace changeover::python
