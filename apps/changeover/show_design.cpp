#include "show_design.hpp"

#include <algorithm>

#include "changeover/io/csv.hpp"
#include "changeover/io/figures.hpp"
#include "changeover/io/latex.hpp"
#include "changeover/io/table.hpp"

namespace changeover::cli {
namespace {

Design in_memory(BlockSource& source, const Exhibit& exhibit) {
  Design design = read_all(source);
  design.set_labels(exhibit.header.labels);
  return design;
}

}  // namespace

const std::vector<std::string>& design_formats() {
  static const std::vector<std::string> formats{"table", "text", "json", "csv",
                                                "latex", "svg",  "tikz"};
  return formats;
}

void show_design(BlockSource& source, const Exhibit& exhibit, const OutputRequest& output) {
  const std::string format = output.chosen();
  OutputFile out(output.path);
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
  out.commit();
}

}  // namespace changeover::cli
