// Any bytes, read as JSON.
#include "changeover/io/formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::json_fuzz {
namespace {

const Target target("json", [](const std::string& bytes) {
  read_write_read(
      bytes, [](const std::string& text) { return read_json(*input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_json(design, sink); });
});

}  // namespace
}  // namespace changeover::fuzz::json_fuzz
