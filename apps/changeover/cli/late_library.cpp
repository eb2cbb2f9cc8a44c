#include "cli/late_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "changeover/core/error.hpp"

namespace changeover::cli {

void* late_address(const char* library, const char* name) {
  // It stays, and is loaded once. What MPI loads itself looks for MPI among what all see.
  void* const loaded = ::dlopen(library, RTLD_LAZY | RTLD_GLOBAL);
  void* const address = loaded == nullptr ? nullptr : ::dlsym(loaded, name);
  if (address == nullptr) {
    throw MissingResource(
        fmt::format("a library cannot be loaded: {}; install it again", ::dlerror()));
  }
  return address;
}

}  // namespace changeover::cli
