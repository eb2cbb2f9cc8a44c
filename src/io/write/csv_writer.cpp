#include <fmt/format.h>

#include <algorithm>

#include "changeover/io/formats.hpp"
#include "io/scan/token_table.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/element_text.hpp"

namespace changeover {
namespace {

// The words of the elements are names, not the numbers 0, …, v−1 in some order.
bool are_names(const std::vector<std::string>& labels) {
  return !labels.empty() && !element_set(labels).labels.empty();
}

}  // namespace

std::uint64_t write_csv(BlockSource& source, Sink& sink, const std::vector<std::string>& labels) {
  const Parameters& p = source.parameters();
  std::vector<std::string> cells(labels);
  std::transform(cells.begin(), cells.end(), cells.begin(), csv_cell);
  ElementText text(sink, p.v, cells, ',');
  text.put("block,");
  for (std::uint64_t i = 1; i <= p.k; ++i) {
    text.put("element_");
    text.put_number(i);
    text.put(',');
  }
  text.put("v,change,kind");
  std::string tail = fmt::format("{},{},{}", p.v, p.change, to_string(p.kind));
  if (p.strength != 2) {
    text.put(",strength");
    tail += fmt::format(",{}", p.strength);
  }
  if (are_names(labels)) {
    text.put(",elements");
    tail += ",labels";
  }
  text.put('\n');
  tail += '\n';
  std::uint64_t blocks = 0;
  for_each_block(source, [&](std::span<const Element> block) {
    text.put_number(++blocks);
    text.put(',');
    text.elements(block, ',');
    text.put(tail);
  });
  text.flush();
  return blocks;
}

void write_csv(const Design& design, Sink& sink) {
  DesignSource source(design);
  write_csv(source, sink, design.labels());
}

}  // namespace changeover
