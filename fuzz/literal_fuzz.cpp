// Any bytes, read as GAP or Sage write designs.
#include "changeover/io/formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::literal_fuzz {
namespace {

const Target target("literal", [](const std::string& bytes) {
  const auto read = [](const std::string& text) { return read_literal(*input_from_text(text)); };
  read_write_read(bytes, read, [](const Design& design, Sink& sink) { write_gap(design, sink); });
  read_write_read(bytes, read, [](const Design& design, Sink& sink) { write_sage(design, sink); });
  // A reader that guesses the format right reads the same, or refuses comments that are not UTF-8.
  std::optional<Design> design;
  if (begins_like_a_literal(bytes) && accepts([&] { design = read(bytes); })) {
    accepts([&] {
      must(read_design(input_from_text(bytes)).blocks() == design->blocks(),
           "a literal is known by its content");
    });
  }
});

}  // namespace
}  // namespace changeover::fuzz::literal_fuzz
