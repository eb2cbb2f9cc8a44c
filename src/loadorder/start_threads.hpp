// Internal: threads that are all started, or none.
#pragma once

#include <fmt/format.h>

#include <system_error>
#include <thread>
#include <vector>

#include "changeover/core/error.hpp"

namespace changeover {

/// Starts `count` threads that run serve(). If the system has no more of them, end() must make
/// those that were started return. @throws MissingResource, with all threads joined.
template <typename Serve, typename End>
void start_threads(std::vector<std::thread>& threads, unsigned count, const Serve& serve,
                   const End& end) {
  try {
    threads.reserve(count);
    for (unsigned i = 0; i < count; ++i) {
      threads.emplace_back(serve);
    }
  } catch (const std::system_error& fault) {
    end();
    for (std::thread& thread : threads) {
      thread.join();
    }
    threads.clear();
    throw MissingResource(
        fmt::format("cannot start {} threads: {}; use fewer", count, fault.code().message()));
  } catch (...) {
    end();
    for (std::thread& thread : threads) {
      thread.join();
    }
    throw;
  }
}

}  // namespace changeover
