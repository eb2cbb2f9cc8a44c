#include "changeover/io/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "changeover/core/parameters.hpp"
#include "core/printable.hpp"
#include "io/write/element_text.hpp"

namespace changeover {
namespace {

constexpr std::string_view infinity = "∞";

bool all_of(std::string_view text, std::string_view allowed) {
  return text.find_first_not_of(allowed) == std::string_view::npos;
}

// The text of a label within math mode: ∞ becomes \infty, all else looks as it does in text.
std::string in_math(std::string_view text, bool subscript) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string result;
  while (!text.empty()) {
    const std::size_t next = std::min(text.find(infinity), text.size());
    const std::string_view plain = text.substr(0, next);
    if (all_of(plain, "0123456789") || (plain.size() == 1 && all_of(plain, letters))) {
      result += plain;
    } else if (all_of(plain, letters)) {
      result += "\\mathrm{" + std::string(plain) + "}";
    } else {
      result += (subscript ? "\\mbox{\\scriptsize " : "\\mbox{") + latex_escaped(plain) + "}";
    }
    text.remove_prefix(next);
    if (!text.empty()) {
      text.remove_prefix(infinity.size());
      // A letter must not run into the command's name.
      result += !text.empty() && all_of(text.substr(0, 1), letters) ? "\\infty " : "\\infty";
    }
  }
  return result;
}

std::string default_caption(const Design& design) {
  // "circular DCCD(6,4)" with the number of blocks, as the field writes it.
  std::string name = changeover::name(design.parameters());
  const std::size_t end = name.find(')');
  name.insert(end, fmt::format(",{}", design.block_count()));
  return "A " + latex_escaped(name);
}

// What stands around the columns, and ends a line of them: a table that floats, or one that goes on
// over pages; small where 12 columns would be wider than a page of the class article.
struct Environment {
  std::string begin;
  std::string end_of_line;
  std::string before_caption;
  std::string end;
};

Environment environment_of(const Design& design, const LatexOptions& options, std::size_t blocks,
                           std::size_t band) {
  constexpr std::size_t most_lines_of_a_float = 48;
  constexpr double line_width = 345;  // points, of that class, and so are those of letters
  constexpr double letter = 5;
  constexpr double small_letter = 4;  // of an index
  constexpr double between = 12;
  std::size_t longest = 0;
  for (Element x = 0; x < design.parameters().v; ++x) {
    longest = std::max(longest, design.label(x).size());
  }
  const std::size_t name = blocks == 0 ? 0 : block_name(options.names, blocks - 1).size();
  const double column = std::max(letter * (static_cast<double>(longest) + 1),
                                 letter * 1.5 + small_letter * static_cast<double>(name)) +
                        between;
  const bool wide = column * static_cast<double>(band) > line_width;
  const std::string narrow = wide ? "\\small\\setlength{\\tabcolsep}{3pt}\n" : "";
  const std::size_t bands = (blocks + band - 1) / band;
  if (bands * (design.parameters().k + 1) <= most_lines_of_a_float) {
    return {.begin = "\\begin{table}[ht!]\n\\centering\n" + narrow + "\\begin{tabular}{",
            .end_of_line = " \\\\\n",
            .before_caption = "\n\\end{tabular}\n",
            .end = "\\end{table}\n"};
  }
  return {.begin = "% \\usepackage{longtable}\n\\begingroup\n" + narrow + "\\begin{longtable}{",
          .end_of_line = " \\\\*\n",  // a page does not end within a band
          .before_caption = " \\\\\n",
          .end = "\\end{longtable}\n\\endgroup\n"};
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '<':
        result += "\\textless{}";
        break;
      case '>':
        result += "\\textgreater{}";
        break;
      case '|':
        result += "\\textbar{}";
        break;
      case '-':
      case '`':
      case '\'':
      case ',':  // Two in a row would be one sign, and so would ?` and !`.
        if (result.ends_with(c) || (c == '`' && (result.ends_with('?') || result.ends_with('!')))) {
          result += "{}";
        }
        result += c;
        break;
      case '{':
      case '}':
      case '$':
      case '&':
      case '#':
      case '_':
      case '%':
        result += '\\';
        [[fallthrough]];
      default:
        result += c;
    }
  }
  return result;
}

std::string latex_element(std::string_view label, bool introduced, bool leaving) {
  // One underscore with something on both sides makes a subscript.
  const std::size_t under = label.find('_');
  const bool subscript = under != std::string_view::npos && under > 0 && under + 1 < label.size() &&
                         label.rfind('_') == under;
  if (!subscript && label.find(infinity) == std::string_view::npos) {
    std::string result = latex_escaped(label);
    if (introduced || leaving) {
      result += fmt::format("${}{}$", introduced ? "^*" : "", leaving ? "_*" : "");
    }
    // A bracket at the start of a row would be read as an argument of the line break before it.
    return label.starts_with('[') || label.starts_with('*') ? "{" + result + "}" : result;
  }
  const std::string base = in_math(subscript ? label.substr(0, under) : label, false);
  const std::string below =
      (subscript ? in_math(label.substr(under + 1), true) : "") + (leaving ? "*" : "");
  return fmt::format("${}{}{}$", base, below.empty() ? "" : "_{" + below + "}",
                     introduced ? "^{*}" : "");
}

void write_latex(const Design& design, Sink& sink, const LatexOptions& options) {
  const std::unordered_set<std::uint64_t> positions(options.positions.begin(),
                                                    options.positions.end());
  const bool marks = !positions.empty();
  const std::vector<AlignedBlock> blocks = aligned_rows(design);
  const std::size_t band = std::max<std::size_t>(
      1, std::min<std::size_t>(options.columns, std::max<std::size_t>(1, blocks.size())));

  const Environment environment = environment_of(design, options, blocks.size(), band);
  std::string text = environment.begin;
  if (marks) {
    text += "c@{}";
  }
  for (std::size_t i = 0; i < band; ++i) {
    text += marks ? "lc@{}" : "l";
  }
  text += "}\n";
  for (std::size_t start = 0; start < blocks.size(); start += band) {
    const std::size_t stop = std::min(start + band, blocks.size());
    if (start > 0) {
      text += " \\\\ \\hline\n";
    }
    const auto row = [&](const auto& cell, bool last) {
      if (marks) {
        text += last && start == 0 && positions.contains(0) ? "$_{\\land}$ & " : "& ";
      }
      for (std::size_t i = start; i < stop; ++i) {
        text += i > start ? " & " : "";
        text += cell(i);
        if (marks) {
          text += last && positions.contains(i + 1) ? " & $_{\\land}$" : " &";
        }
      }
      text += last ? "" : environment.end_of_line;
    };
    row([&](std::size_t i) { return "$B_{" + block_name(options.names, i) + "}$"; }, false);
    const std::size_t k = blocks[start].size();
    for (std::size_t r = 0; r < k; ++r) {
      row(
          [&](std::size_t i) {
            const MarkedElement& cell = blocks[i][r];
            return latex_element(design.label(cell.element), options.introduced && cell.introduced,
                                 options.leaving && cell.leaving);
          },
          r + 1 == k);
    }
    sink.write(text);
    text.clear();
  }
  const std::string caption = options.caption.value_or(default_caption(design));
  text += environment.before_caption;
  if (!caption.empty()) {
    text += "\\caption{" + caption + "}\n";
  }
  if (!options.label.empty()) {
    text += "\\label{" + options.label + "}\n";
  }
  text += environment.end;
  sink.write(text);
}

}  // namespace changeover
