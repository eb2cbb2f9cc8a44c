#include "answer/design/show_design.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/tables.hpp"
#include "cli/terminal.hpp"
#include "core/words.hpp"

namespace changeover::cli {
namespace {

Design in_memory(BlockSource& source, const Exhibit& exhibit) {
  Design design = read_all(source);
  design.set_labels(exhibit.header.labels);
  return design;
}

// Formats of other programs.
bool is_for_others(const std::string& format) {
  return format == "gap" || format == "sage" || format == "designtheory" || format == "ljcr";
}

void write_table_of(BlockSource& source, const Exhibit& exhibit, OutputFile& out) {
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

}  // namespace

void write_design(BlockSource& source, const Exhibit& exhibit, const std::string& format,
                  Sink& out) {
  if (format == "text") {
    write_text(source, out, exhibit.header);
  } else if (format == "json") {
    write_json(source, out, exhibit.header,
               [&] { return std::optional<DesignVerdict>(exhibit.judgement.verdict); });
  } else if (format == "csv") {
    write_csv(source, out, exhibit.header.labels);
  } else if (is_for_others(format)) {
    const Design design = in_memory(source, exhibit);
    (format == "gap"    ? write_gap
     : format == "sage" ? write_sage
     : format == "ljcr" ? write_ljcr
                        : write_designtheory)(design, out);
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
    const Picture picture =
        draw_circle(circle_figure(design, 0, std::min<std::uint64_t>(drawn, design.block_count())));
    out.write(format == "svg" ? svg(picture) : tikz(picture));
  } else {
    throw InternalError("a design has no format " + format + " but on a terminal");
  }
}

const std::vector<std::string>& design_formats() {
  static const std::vector<std::string> formats{"table", "text",         "json", "csv",
                                                "latex", "svg",          "tikz", "gap",
                                                "sage",  "designtheory", "ljcr"};
  return formats;
}

std::optional<std::string> format_defect(const Parameters& p, std::uint64_t b,
                                         const std::string& format) {
  constexpr std::uint64_t most_blocks = 1'000'000;
  constexpr std::uint64_t most_elements = 20'000'000;
  constexpr std::uint64_t most_points = 1000;
  if (format == "text" || format == "json" || format == "csv") {
    return std::nullopt;
  }
  if ((format == "svg" || format == "tikz") && p.v > most_points) {
    return fmt::format(
        "--format {}: a picture has at most {} points, not v = {}; use --format text", format,
        most_points, p.v);
  }
  if (b > most_blocks || b > most_elements / p.k) {
    return fmt::format("--format {}: {} of {} are too many to lay out; use --format text -o FILE",
                       format, count_of(b, "block"), count_of(p.k, "element"));
  }
  return std::nullopt;
}

const std::vector<std::string>& formats_of_marks() {
  static const std::vector<std::string> formats{"table", "latex"};
  return formats;
}

Answer show_design(std::shared_ptr<BlockSource> source, Exhibit exhibit,
                   const OutputRequest& output, int code) {
  Answer answer{.code = code, .output = output};
  std::string format = output.format();
  if (const auto b = source->block_count()) {
    const auto defect = format_defect(source->parameters(), *b, format);
    if (defect && !output.precious) {
      throw UsageError{*defect};
    }
    if (defect) {  // What a search found is not lost for its size, nor in a file of another format.
      format = "text";
      if (!output.name_allows(format)) {
        answer.output.path += ".txt";
        answer.fault = std::make_exception_ptr(MissingResource(
            fmt::format("{}; the design was written as text to {}", *defect, answer.output.path)));
      }
    }
  }
  const auto write = [source = std::move(source), exhibit = std::move(exhibit), format,
                      begun = false](OutputFile& out) mutable {
    if (begun && !source->rewind()) {
      throw InternalError("a design that cannot be read twice");
    }
    begun = true;
    if (format == "table") {
      write_table_of(*source, exhibit, out);
    } else {
      write_design(*source, exhibit, format, out);
    }
  };
  answer.write = write;
  return answer;
}

Answer show_design(const Design& design, Exhibit exhibit, const OutputRequest& output, int code) {
  struct Owned {
    Design design;
    DesignSource source{design};
  };
  const auto owned = std::make_shared<Owned>(Owned{design});
  owned->source = DesignSource(owned->design);
  return show_design({owned, &owned->source}, std::move(exhibit), output, code);
}

bool can_be_judged_while_written(const OutputRequest& output) {
  const std::string format = output.format();
  const bool to_file = !output.path.empty() && output.path != "-";
  return format == "text" || format == "json" || (format == "csv" && to_file);
}

Answer show_design_while_judging(std::shared_ptr<BlockSource> source, const Offer& promise,
                                 const Exhibit& exhibit, const OutputRequest& output) {
  const auto write = [source = std::move(source), promise, exhibit,
                      format = output.format()](OutputFile& out) {
    JudgedWhileRead judged(*source, promise);
    const auto verdict = [&] { return std::optional(judged.judgement().verdict); };
    if (format == "json") {
      write_json(judged, out, exhibit.header, verdict);
    } else if (format == "csv") {
      write_csv(judged, out, exhibit.header.labels);
    } else {
      if (out.is_standard_output()) {
        out.write("# verified while it is written: the last line says how it ended\n");
      }
      write_text(judged, out, exhibit.header);
      if (out.is_standard_output()) {
        const Judgement& judgement = judged.judgement();
        out.write(fmt::format("# verified: {}; {}\n", judgement.certificate, quality(judgement)));
      }
    }
  };
  return {.code = exit_code::done, .output = output, .write = write};
}

}  // namespace changeover::cli
