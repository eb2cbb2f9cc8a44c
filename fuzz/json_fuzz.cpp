// Any bytes, read as JSON.
#include "changeover/io/formats.hpp"

#include "read_write_read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace changeover;
  return fuzz::read_write_read(
      data, size, [](const std::string& text) { return read_json(*input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_json(design, sink); });
}
