#include "changeover/io/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "changeover/core/error.hpp"
#include "changeover/core/transitions.hpp"
#include "changeover/io/tables.hpp"
#include "core/utf8.hpp"

namespace changeover {
namespace {

struct Colour {
  std::string_view hex;
  bool dark;  // letters on it are white
};

// Okabe and Ito without yellow, which is too pale for lines on white.
constexpr std::array<Colour, 7> palette = {{{"0072B2", true},
                                            {"D55E00", true},
                                            {"009E73", true},
                                            {"CC79A7", false},
                                            {"E69F00", false},
                                            {"56B4E9", false},
                                            {"000000", true}}};
constexpr std::size_t black = 6;

// What both kinds of picture and both formats come from.
struct Node {
  double angle = 0;   // in degrees, counter-clockwise from the right
  double radius = 1;  // in units of the circle's
  std::string name;
  std::optional<std::size_t> fill;  // a colour; white otherwise
};
struct Line {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t colour = 0;
  std::size_t dash = 0;  // 0: none
};
struct Picture {
  std::string title;
  std::string description;
  std::vector<Node> nodes;
  std::vector<Line> lines;
};

std::vector<Node> circle(std::size_t count, const std::vector<std::string>& names) {
  if (!names.empty() && names.size() != count) {
    throw BadInput(fmt::format("{} names for {} points; give one each", names.size(), count));
  }
  std::vector<Node> nodes(count);
  for (std::size_t i = 0; i < count; ++i) {
    nodes[i].name = names.empty() ? std::to_string(i) : names[i];
  }
  return nodes;
}

// Places the nodes for which `on_circle` holds clockwise from the top.
template <typename Predicate>
void place(std::vector<Node>& nodes, Predicate on_circle) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    count += on_circle(i) ? 1U : 0U;
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (on_circle(i)) {
      nodes[i].angle = 90.0 - 360.0 * static_cast<double>(next++) / static_cast<double>(count);
    } else {
      nodes[i].radius = 0;
    }
  }
}

Picture picture_of(const FactorFigure& figure) {
  if (figure.order < 2 || figure.order > 1000) {
    throw BadInput(fmt::format("order {}: a picture has 2 to 1000 vertices", figure.order));
  }
  if (figure.centre.value_or(0) >= figure.order) {
    throw BadInput(
        fmt::format("the centre {} is not a vertex of K_{}", *figure.centre, figure.order));
  }
  Picture picture;
  picture.title =
      figure.title.empty() ? fmt::format("1-factorization of K_{}", figure.order) : figure.title;
  picture.description =
      fmt::format("{} vertices on a circle{}; the edges of each of the {} factors have a colour.",
                  figure.order - (figure.centre ? 1U : 0U),
                  figure.centre ? " and one in its centre" : "", figure.factors.size());
  picture.nodes = circle(figure.order, figure.names);
  place(picture.nodes, [&](std::size_t i) { return figure.centre != i; });
  for (std::size_t i = 0; i < figure.factors.size(); ++i) {
    for (const auto& [x, y] : figure.factors[i]) {
      if (x >= figure.order || y >= figure.order || x == y) {
        throw BadInput(fmt::format("{{{},{}}} is no edge of K_{}", x, y, figure.order));
      }
      picture.lines.push_back({x, y, i % palette.size(), i / palette.size()});
    }
  }
  return picture;
}

std::string set_of(const Block& block, const std::vector<Node>& nodes) {
  std::string text;
  for (const Element x : block) {
    text += (text.empty() ? "{" : ",") + nodes[x].name;
  }
  return text + "}";
}

Picture picture_of(const CircleFigure& figure) {
  if (figure.v < 1 || figure.v > 1000) {
    throw BadInput(fmt::format("v = {}: a picture has 1 to 1000 points", figure.v));
  }
  Picture picture;
  picture.title =
      figure.title.empty() ? fmt::format("Blocks on {} points", figure.v) : figure.title;
  picture.description = "Points on a circle; newly covered pairs in the colour of their block: ";
  picture.nodes = circle(static_cast<std::size_t>(figure.v), figure.names);
  place(picture.nodes, [](std::size_t) { return true; });
  for (std::size_t i = 0; i < figure.blocks.size(); ++i) {
    const DrawnBlock& block = figure.blocks[i];
    for (const Block* part : {&block.elements, &block.introduced}) {
      for (const Element x : *part) {
        if (x >= figure.v) {
          throw BadInput(fmt::format("element {} is not below v = {}", x, figure.v));
        }
      }
    }
    const std::size_t colour = i % black;
    const auto is_new = [&](Element x) {
      return std::find(block.introduced.begin(), block.introduced.end(), x) !=
             block.introduced.end();
    };
    for (std::size_t a = 0; a < block.elements.size(); ++a) {
      const Element x = block.elements[a];
      Node& node = picture.nodes[x];
      const bool kept = node.fill || (figure.blocks.size() == 1 && !is_new(x));
      node.fill = kept ? black : colour;
      for (std::size_t b = 0; b < a; ++b) {
        const Element y = block.elements[b];
        if (is_new(x) || is_new(y)) {
          picture.lines.push_back({y, x, colour, i / black});
        }
      }
    }
    picture.description += (i > 0 ? ", " : "") + set_of(block.elements, picture.nodes);
  }
  picture.description += ".";
  return picture;
}

std::string xml_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view piece = text.substr(0, point.bytes);
    text.remove_prefix(point.bytes);
    if (!is_printable(point) || point.value == 0xFFFE || point.value == 0xFFFF) {
      result += "\xEF\xBF\xBD";  // U+FFFD: XML cannot carry it, or no reader should obey it
    } else if (piece == "&") {
      result += "&amp;";
    } else if (piece == "<") {
      result += "&lt;";
    } else if (piece == ">") {
      result += "&gt;";
    } else if (piece == "\"") {
      result += "&quot;";
    } else {
      result += piece;
    }
  }
  return result;
}

// The distance of neighbours on a circle of radius 1, at most 1.
double spacing(const Picture& picture) {
  const auto around = static_cast<double>(std::max<std::size_t>(picture.nodes.size(), 6));
  return 2 * std::sin(std::numbers::pi / around);
}

std::string svg_of(const Picture& picture) {
  constexpr double size = 480, middle = size / 2, circle_radius = 205;
  const double node_radius = std::min(19.0, 0.42 * circle_radius * spacing(picture));
  const bool names_inside = node_radius >= 7;
  const double width = picture.lines.size() > 200 ? 1 : picture.lines.size() > 60 ? 1.6 : 2.6;
  const auto at = [&](const Node& node, double radius) {
    const double angle = node.angle * std::numbers::pi / 180;
    return std::pair(middle + radius * std::cos(angle), middle - radius * std::sin(angle));
  };

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{0}\" "
      "viewBox=\"0 0 {0} {0}\" role=\"img\">\n"
      "<title>{1}</title>\n<desc>{2}</desc>\n"
      "<rect width=\"{0}\" height=\"{0}\" fill=\"#FFFFFF\"/>\n"
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-width=\"{3}\">\n",
      size, xml_escaped(picture.title), xml_escaped(picture.description), width);
  for (const Line& line : picture.lines) {
    const Node& from = picture.nodes[line.from];
    const Node& to = picture.nodes[line.to];
    const auto [x1, y1] = at(from, from.radius * circle_radius);
    const auto [x2, y2] = at(to, to.radius * circle_radius);
    const std::string dash = line.dash == 0
                                 ? std::string()
                                 : fmt::format(" stroke-dasharray=\"{0} {0}\"", 4 * line.dash);
    svg += fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"#{}\"{}/>\n", x1,
        y1, x2, y2, palette[line.colour].hex, dash);
  }
  svg += fmt::format(
      "</g>\n<g stroke=\"#000000\" stroke-width=\"{}\" text-anchor=\"middle\" "
      "font-family=\"sans-serif\">\n",
      names_inside ? 1.5 : 0.5);
  for (const Node& node : picture.nodes) {
    const auto [x, y] = at(node, node.radius * circle_radius);
    svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"#{}\"/>\n", x, y,
                       node_radius, node.fill ? palette[*node.fill].hex : "FFFFFF");
    if (!names_inside && !node.fill && picture.nodes.size() > 60) {
      continue;  // there is no room for all names: those of the blocks must do
    }
    const auto letters = static_cast<double>(std::max<std::size_t>(2, display_width(node.name)));
    const double font = names_inside ? std::min(16.0, 2.6 * node_radius / letters) : 10;
    const auto [text_x, text_y] =
        names_inside ? std::pair(x, y) : at(node, circle_radius + node_radius + 9);
    const bool white = names_inside && node.fill && palette[*node.fill].dark;
    svg += fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.1f}\" stroke=\"none\" fill=\"#{}\">{}"
        "</text>\n",
        text_x, text_y + 0.35 * font, font, white ? "FFFFFF" : "000000", xml_escaped(node.name));
  }
  return svg + "</g>\n</svg>\n";
}

std::string tikz_of(const Picture& picture) {
  constexpr double circle_radius = 2.7;  // cm
  const double node_size = std::min(0.6, 0.84 * circle_radius * spacing(picture));
  const bool names_inside = node_size >= 0.25;
  const double width = picture.lines.size() > 200 ? 0.15 : picture.lines.size() > 60 ? 0.25 : 0.4;

  std::string title = picture.title;  // it becomes a comment
  std::replace(title.begin(), title.end(), '\n', ' ');
  title = latex_escaped(title);
  std::string text = fmt::format("% {}\n\\begin{{tikzpicture}}\n", title);
  for (std::size_t i = 0; i < palette.size(); ++i) {
    text += fmt::format("\\definecolor{{factor{}}}{{HTML}}{{{}}}\n", i, palette[i].hex);
  }
  for (std::size_t i = 0; i < picture.nodes.size(); ++i) {
    const Node& node = picture.nodes[i];
    text += fmt::format("\\coordinate (p{}) at ({:.3f}:{:.3f}cm);\n", i, node.angle,
                        node.radius * circle_radius);
  }
  for (const Line& line : picture.lines) {
    const std::string dash = line.dash == 0
                                 ? std::string()
                                 : fmt::format(", dash pattern=on {0}pt off {0}pt", 2 * line.dash);
    text += fmt::format("\\draw[line cap=round, line width={}mm, factor{}{}] (p{}) -- (p{});\n",
                        width, line.colour, dash, line.from, line.to);
  }
  for (std::size_t i = 0; i < picture.nodes.size(); ++i) {
    const Node& node = picture.nodes[i];
    std::string style =
        fmt::format("circle, draw, inner sep=0pt, minimum size={:.2f}cm", node_size);
    if (node.fill) {
      style += fmt::format(", fill=factor{}{}", *node.fill,
                           names_inside && palette[*node.fill].dark ? ", text=white" : "");
    } else {
      style += ", fill=white";
    }
    const std::string name = latex_element(node.name);
    if (names_inside) {
      const bool small = display_width(node.name) > 2 || node_size < 0.5;
      text += fmt::format("\\node[{}, font=\\{}] at (p{}) {{{}}};\n", style,
                          small ? "tiny" : "small", i, name);
    } else {
      text += fmt::format("\\node[{}] at (p{}) {{}};\n", style, i);
      if (node.fill || picture.nodes.size() <= 60) {
        text += fmt::format("\\node[font=\\tiny] at ({:.3f}:{:.3f}cm) {{{}}};\n", node.angle,
                            circle_radius + 0.25, name);
      }
    }
  }
  return text + "\\end{tikzpicture}\n";
}

}  // namespace

CircleFigure circle_figure(const Design& design, std::uint64_t first, std::uint64_t count) {
  CircleFigure figure{.v = design.v(), .names = design.labels()};
  DesignSource source(design);
  for (Transitions steps(source); steps.next() && figure.blocks.size() < count;) {
    if (steps.index() >= first) {
      figure.blocks.push_back({Block(steps.block().begin(), steps.block().end()),
                               Block(steps.introduced().begin(), steps.introduced().end())});
    }
  }
  return figure;
}

std::string to_svg(const FactorFigure& figure) { return svg_of(picture_of(figure)); }
std::string to_svg(const CircleFigure& figure) { return svg_of(picture_of(figure)); }
std::string to_tikz(const FactorFigure& figure) { return tikz_of(picture_of(figure)); }
std::string to_tikz(const CircleFigure& figure) { return tikz_of(picture_of(figure)); }

}  // namespace changeover
