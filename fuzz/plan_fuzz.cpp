// Any bytes, read as lists of parts, pairs and set-ups: an answer or one line, and what is written is read back.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"

namespace {

using namespace changeover;

template <typename Read>
void one_line_at_most(Read&& read) {
  try {
    read();
  } catch (const BadInput& fault) {
    if (std::string(fault.what()).find('\n') != std::string::npos) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> names{"Pump A", "Valve, large", "2", "slot_1", "part"};
  for (const Header header : {Header::guessed, Header::given, Header::none}) {
    one_line_at_most([&] {
      const PartList list = read_parts(*input_from_text(text), header);
      Block all;
      for (std::size_t x = 0; x < list.names.size(); ++x) {
        all.push_back(static_cast<Element>(x));
      }
      if (parse_parts(parts_text(all, list.names), list.names) != all) {
        std::abort();
      }
    });
  }
  one_line_at_most([&] { (void)read_pairs(*input_from_text(text), names); });
  one_line_at_most([&] { (void)read_slots(*input_from_text(text)); });
  one_line_at_most([&] { (void)read_setups(*input_from_text(text), names); });
  return 0;
}
