// Any bytes, read as JSON: a design that survives being written and read again, or one line that says
// what is wrong.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "changeover/core/error.hpp"
#include "changeover/io/json.hpp"

namespace {

using namespace changeover;

Design read(const std::string& text) { return read_json(*input_from_text(text)); }

std::string written(const Design& design) {
  StringSink sink;
  write_json(design, sink);
  return sink.take();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  std::string once;
  try {
    once = written(read(text));
  } catch (const BadInput& fault) {
    if (std::string_view(fault.what()).find('\n') != std::string_view::npos) {
      std::abort();
    }
    return 0;
  }
  if (written(read(once)) != once) {
    std::abort();
  }
  return 0;
}
