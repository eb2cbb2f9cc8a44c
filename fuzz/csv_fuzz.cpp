// Any bytes, read as CSV.
#include "changeover/io/formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::csv_fuzz {
namespace {

const Target target("csv", [](const std::string& bytes) {
  read_write_read(
      bytes, [](const std::string& text) { return read_csv(*input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_csv(design, sink); });
});

}  // namespace
}  // namespace changeover::fuzz::csv_fuzz
