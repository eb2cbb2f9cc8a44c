#include <fmt/format.h>

#include "changeover/io/formats.hpp"
#include "io/write/element_text.hpp"

namespace changeover {

std::string header_words(const Parameters& p) {
  return fmt::format("changeover design v={} k={} change={} kind={}{}", p.v, p.k, p.change,
                     to_string(p.kind),
                     p.strength == 2 ? std::string() : fmt::format(" strength={}", p.strength));
}

namespace {

void put_header(ElementText& text, const Parameters& p, const std::vector<std::string>& labels,
                const std::optional<Recipe>& recipe) {
  text.put("# " + header_words(p) + "\n");
  if (!labels.empty()) {
    text.put("# labels:");
    for (const std::string& label : labels) {
      text.put(' ');
      text.put(label);
    }
    text.put('\n');
  }
  if (recipe) {
    text.put("# recipe: " + recipe_to_json(*recipe) + "\n");
  }
}

}  // namespace

std::uint64_t write_text(BlockSource& source, Sink& sink, const TextHeader& header) {
  const Parameters& p = source.parameters();
  ElementText text(sink, p.v, header.labels, ' ');
  put_header(text, p, header.labels, header.recipe);
  const auto k = static_cast<std::size_t>(p.k);
  std::uint64_t elements = 0;
  for_each_batch(source, [&](std::span<const Element> blocks) {
    text.blocks(blocks, k, '\n');
    elements += blocks.size();
  });
  text.flush();
  return elements / k;
}

void write_text(const Design& design, Sink& sink) {
  DesignSource source(design);
  write_text(source, sink, {design.labels(), design.recipe});
}

}  // namespace changeover
