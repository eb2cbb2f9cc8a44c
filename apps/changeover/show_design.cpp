#include "show_design.hpp"

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/io/csv.hpp"
#include "changeover/io/figures.hpp"
#include "changeover/io/latex.hpp"
#include "changeover/io/table.hpp"
#include "terminal.hpp"

namespace changeover::cli {
namespace {

Design in_memory(BlockSource& source, const Exhibit& exhibit) {
  Design design = read_all(source);
  design.set_labels(exhibit.header.labels);
  return design;
}

void write_design(BlockSource& source, const Exhibit& exhibit, const std::string& format,
                  OutputFile& out) {
  if (format == "text") {
    write_text(source, out, exhibit.header);
  } else if (format == "json") {
    write_json(source, out, exhibit.header,
               [&] { return std::optional<DesignVerdict>(exhibit.judgement.verdict); });
  } else if (format == "csv") {
    write_csv(source, out, exhibit.header.labels);
  } else if (format == "latex") {
    LatexOptions options;
    options.leaving = exhibit.leaving;
    options.positions = exhibit.positions;
    options.names.base_blocks = exhibit.base_blocks;
    write_latex(in_memory(source, exhibit), out, options);
  } else if (format == "svg" || format == "tikz") {
    // The first round of base blocks and the block after it, as the paper draws them.
    const std::uint64_t drawn = exhibit.base_blocks.value_or(1) + 1;
    const Design design = in_memory(source, exhibit);
    const CircleFigure figure =
        circle_figure(design, 0, std::min<std::uint64_t>(drawn, design.block_count()));
    out.write(format == "svg" ? to_svg(figure) : to_tikz(figure));
  } else {
    TableOptions options;
    options.width = terminal_width(out);
    options.leaving = exhibit.leaving;
    options.colour = may_colour(out);
    options.positions = exhibit.positions;
    options.names.base_blocks = exhibit.base_blocks;
    const Design design = in_memory(source, exhibit);
    out.write(exhibit.title + "\n\n");
    write_table(design, out, options);
  }
}

}  // namespace

const std::vector<std::string>& design_formats() {
  static const std::vector<std::string> formats{"table", "text", "json", "csv",
                                                "latex", "svg",  "tikz"};
  return formats;
}

void show_design(BlockSource& source, const Exhibit& exhibit, const OutputRequest& output) {
  bool begun = false;
  deliver(output, [&](OutputFile& out) {
    if (begun && !source.rewind()) {
      throw InternalError("a design that cannot be read twice");
    }
    begun = true;
    write_design(source, exhibit, output.chosen(), out);
  });
}

}  // namespace changeover::cli
