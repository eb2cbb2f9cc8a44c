// Any bytes, read as XML of designtheory.org, as text of the La Jolla repository, and as a design of whatever format.
#include "changeover/io/other_formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz {
namespace {

const Target target("designtheory", [](const std::string& bytes) {
  const auto read_any = [](const std::string& text) { return read_design(input_from_text(text)); };
  read_write_read(
      bytes, [](const std::string& text) { return read_designtheory(*input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_designtheory(design, sink); });
  read_write_read(bytes, read_any,
                  [](const Design& design, Sink& sink) { write_designtheory(design, sink); });
  read_write_read(bytes, read_any,
                  [](const Design& design, Sink& sink) { write_ljcr(design, sink); });
});

}  // namespace
}  // namespace changeover::fuzz
