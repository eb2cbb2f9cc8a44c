// Any bytes, read as a table of minima.
#include "changeover/search/exact.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::minima_fuzz {
namespace {

const Target target("minima", [](const std::string& bytes) {
  std::vector<MinimaRow> rows;
  if (!accepts([&] { rows = read_minima(*input_from_text(bytes)); })) {
    return;
  }
  const auto text = [](const std::vector<MinimaRow>& table) {
    return written(table, [](const auto& all, Sink& sink) { write_minima(all, sink); });
  };
  const std::string once = text(rows);
  must(text(read_minima(*input_from_text(once))) == once, "a table is read and written as it was");
  must(is_plain_json(minima_json(rows)), "a table of minima is JSON");
  must(is_plain(minima_markdown(rows)), "a table of minima is plain text");
});

}  // namespace
}  // namespace changeover::fuzz::minima_fuzz
