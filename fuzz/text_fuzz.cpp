// Any bytes, read as text.
#include "changeover/io/formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::text_fuzz {
namespace {

const Target target("text", [](const std::string& bytes) {
  read_write_read(
      bytes, [](const std::string& text) { return read_text(input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_text(design, sink); });
});

}  // namespace
}  // namespace changeover::fuzz::text_fuzz
