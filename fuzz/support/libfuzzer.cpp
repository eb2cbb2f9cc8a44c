// libFuzzer's door to the one target of this program.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "support/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace changeover::fuzz;
  try {
    Target::all().front()(std::string(data, data + size));
  } catch (const Broken& broken) {
    static_cast<void>(std::fprintf(stderr, "broken: %s\n", broken.promise.c_str()));
    std::abort();
  } catch (const std::exception& fault) {
    static_cast<void>(std::fprintf(stderr, "thrown: %s\n", fault.what()));
    std::abort();
  }
  return 0;
}
