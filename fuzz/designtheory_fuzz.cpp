// Any bytes, read as XML of designtheory.org, as text of the La Jolla repository, and as a design
// of whatever format.
#include <set>
#include <span>

#include "changeover/io/formats.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::designtheory_fuzz {
namespace {

const Target target("designtheory", [](const std::string& bytes) {
  const auto read_any = [](const std::string& text) { return read_design(input_from_text(text)); };
  read_write_read(
      bytes, [](const std::string& text) { return read_designtheory(*input_from_text(text)); },
      [](const Design& design, Sink& sink) { write_designtheory(design, sink); });
  read_write_read(bytes, read_any,
                  [](const Design& design, Sink& sink) { write_designtheory(design, sink); });
  // La Jolla's text says nothing of elements that are in no block.
  accepts([&] {
    const Design design = read_any(bytes);
    const std::span<const Element> there = design.elements();
    const std::set<Element> different(there.begin(), there.end());
    if (different.size() == design.v()) {
      const std::string once = written(design, write_ljcr);
      must(written(read_any(once), write_ljcr) == once,
           "what was written is read and written as it was");
    }
  });
});

}  // namespace
}  // namespace changeover::fuzz::designtheory_fuzz
