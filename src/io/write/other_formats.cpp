// Designs as other programs read them.
#include "changeover/io/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

namespace changeover {
namespace {

// Writes block after block, its points in increasing order, through one buffer.
void put_blocks(const Design& design, Sink& sink, const std::function<std::string(Element)>& point,
                std::string_view open, std::string_view between, std::string_view close,
                std::string_view after) {
  std::string text;
  Block sorted;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    const auto block = design.block(i);
    sorted.assign(block.begin(), block.end());
    std::ranges::sort(sorted);
    text += open;
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      text += j == 0 ? "" : between;
      text += point(sorted[j]);
    }
    text += close;
    text += i + 1 < design.block_count() ? after : "";
    text += '\n';
    constexpr std::size_t enough = std::size_t{1} << 18;
    if (text.size() > enough) {
      sink.write(text);
      text.clear();
    }
  }
  sink.write(text);
}

std::string labels_words(const Design& design) {
  std::string text = "labels:";
  for (const std::string& label : design.labels()) {
    text += " " + label;
  }
  return text;
}

void put_literal(const Design& design, Sink& sink, std::string_view before, std::uint32_t first,
                 std::string_view after) {
  const Parameters& p = design.parameters();
  sink.write(fmt::format("# {}\n{}({}, [\n", header_words(p), before, p.v));
  put_blocks(
      design, sink, [&](Element x) { return std::to_string(x + first); }, "[", ",", "]", ",");
  sink.write(fmt::format("]){}\n", after));
  if (!design.labels().empty()) {
    sink.write("# " + labels_words(design) + "\n");
  }
}

// No "?>" in an instruction.
std::string with_marks(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '?' ? "&#63;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

}  // namespace

void write_gap(const Design& design, Sink& sink) {
  put_literal(design, sink, "D := BlockDesign", 1, ";");
}

void write_sage(const Design& design, Sink& sink) {
  put_literal(design, sink, "D = IncidenceStructure", 0, "");
}

void write_designtheory(const Design& design, Sink& sink) {
  const Parameters& p = design.parameters();
  sink.write(fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<?{}?>\n", header_words(p)));
  if (!design.labels().empty()) {
    sink.write("<?changeover " + with_marks(labels_words(design)) + "?>\n");
  }
  sink.write(fmt::format(
      "<list_of_designs\n design_type=\"block_design\"\n dtrs_protocol=\"2.0\"\n no_designs=\"1\"\n"
      " pairwise_nonisomorphic=\"true\"\n xmlns=\"http://designtheory.org/xml-namespace\">\n"
      " <designs>\n  <block_design\n   b=\"{}\"\n   id=\"v{}-b{}-k{}-0\"\n   v=\"{}\">\n"
      "   <blocks ordered=\"true\">\n",
      design.block_count(), p.v, design.block_count(), p.k, p.v));
  put_blocks(
      design, sink, [](Element x) { return fmt::format("<z>{}</z>", x); }, "    <block>", "",
      "</block>", "");
  sink.write("   </blocks>\n  </block_design>\n </designs>\n</list_of_designs>\n");
}

void write_ljcr(const Design& design, Sink& sink) {
  put_blocks(
      design, sink, [](Element x) { return std::to_string(x + 1); }, "", " ", "", "");
}

}  // namespace changeover
