// Shared libraries that few commands need, loaded when something of theirs is first used: what
// libmicrohttpd (TLS) and MPI bring along takes longer to load than most commands take.
#pragma once

#include <atomic>

namespace changeover::cli {

/// Where that is which `library`, a file as the loader knows it, calls `name`.
[[nodiscard]] void* late_address(const char* library, const char* name);

/// Is called as the function is.
template <typename Function>
class LateFunction {
 public:
  constexpr LateFunction(const char* library, const char* name) : library_(library), name_(name) {}

  // It is called as the function would be.
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions)
  operator Function*() const {
    void* address = address_.load(std::memory_order_relaxed);
    if (address == nullptr) {
      address = late_address(library_, name_);
      address_.store(address, std::memory_order_relaxed);
    }
    return reinterpret_cast<Function*>(address);
  }

 private:
  const char* library_;
  const char* name_;
  mutable std::atomic<void*> address_ = nullptr;
};

}  // namespace changeover::cli
