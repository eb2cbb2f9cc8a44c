#include "changeover/draw/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr std::size_t colours = Paint::series_length;
constexpr std::size_t unchanged_colour = colours - 1;  // of the unchanged subset

// What both kinds of picture come from.
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
struct Round {
  std::string title;
  std::string description;
  std::vector<Node> nodes;
  std::vector<Line> lines;
};

std::vector<Node> circle(std::size_t count, const std::vector<std::string>& names) {
  if (!names.empty() && names.size() != count) {
    throw BadInput(fmt::format("{} for {}; give one each", count_of(names.size(), "name"),
                               count_of(count, "point")));
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

Round round_of(const FactorFigure& figure) {
  if (figure.order < 2 || figure.order > 1000) {
    throw BadInput(fmt::format("order {}: a picture has 2 to 1000 vertices", figure.order));
  }
  if (figure.centre.value_or(0) >= figure.order) {
    throw BadInput(
        fmt::format("the centre {} is not a vertex of K_{}", *figure.centre, figure.order));
  }
  Round round;
  round.title =
      figure.title.empty() ? fmt::format("1-factorization of K_{}", figure.order) : figure.title;
  round.description = fmt::format(
      "{} on a circle{}; {}, each with a colour for its edges.",
      count_of(figure.order - (figure.centre ? 1U : 0U), "vertex", "vertices"),
      figure.centre ? " and one in its centre" : "", count_of(figure.factors.size(), "factor"));
  round.nodes = circle(figure.order, figure.names);
  place(round.nodes, [&](std::size_t i) { return figure.centre != i; });
  for (std::size_t i = 0; i < figure.factors.size(); ++i) {
    for (const auto& [x, y] : figure.factors[i]) {
      if (x >= figure.order || y >= figure.order || x == y) {
        throw BadInput(fmt::format("{{{},{}}} is not an edge of K_{}", x, y, figure.order));
      }
      round.lines.push_back({x, y, i % colours, i / colours});
    }
  }
  return round;
}

std::string set_of(const Block& block, const std::vector<Node>& nodes) {
  std::string text;
  for (const Element x : block) {
    text += (text.empty() ? "{" : ",") + nodes[x].name;
  }
  return text + "}";
}

Round round_of(const CircleFigure& figure) {
  if (figure.v < 1 || figure.v > 1000) {
    throw BadInput(fmt::format("v = {}: a picture has 1 to 1000 points", figure.v));
  }
  Round round;
  round.title = figure.title.empty() ? fmt::format("Blocks on {}", count_of(figure.v, "point"))
                                     : figure.title;
  round.description = "Points on a circle; newly covered pairs in the colour of their block: ";
  round.nodes = circle(static_cast<std::size_t>(figure.v), figure.names);
  place(round.nodes, [&](std::size_t i) { return figure.centre != i; });
  for (std::size_t i = 0; i < figure.blocks.size(); ++i) {
    const DrawnBlock& block = figure.blocks[i];
    for (const Block* part : {&block.elements, &block.introduced}) {
      for (const Element x : *part) {
        if (x >= figure.v) {
          throw BadInput(fmt::format("element {} is not below v = {}", x, figure.v));
        }
      }
    }
    const std::size_t colour = i % unchanged_colour;
    const auto is_new = [&](Element x) {
      return std::ranges::find(block.introduced, x) != block.introduced.end();
    };
    for (std::size_t a = 0; a < block.elements.size(); ++a) {
      const Element x = block.elements[a];
      Node& node = round.nodes[x];
      const bool kept = node.fill || (figure.blocks.size() == 1 && !is_new(x));
      node.fill = kept ? unchanged_colour : colour;
      for (std::size_t b = 0; b < a; ++b) {
        const Element y = block.elements[b];
        if (is_new(x) || is_new(y)) {
          round.lines.push_back({y, x, colour, i / unchanged_colour});
        }
      }
    }
    round.description += (i > 0 ? ", " : "") + set_of(block.elements, round.nodes);
  }
  round.description += ".";
  return round;
}

// The distance of neighbours on a circle of radius 1, at most 1.
double spacing(const Round& round) {
  const auto around = static_cast<double>(std::max<std::size_t>(round.nodes.size(), 6));
  return 2 * std::sin(std::numbers::pi / around);
}

// Where texts stand already, by their middles on the baseline.
class Taken {
 public:
  // Whether a text has room there; if so, it is taken from now on.
  bool has_room(const Point& middle, double width, double height) {
    const Rectangle mine{.x = middle.x - width / 2 - 1,
                         .y = middle.y - height,
                         .width = width + 2,
                         .height = height};
    for (const Rectangle& other : taken_) {
      if (mine.x < other.x + other.width && other.x < mine.x + mine.width &&
          mine.y < other.y + other.height && other.y < mine.y + mine.height) {
        return false;
      }
    }
    taken_.push_back(mine);
    return true;
  }

 private:
  std::vector<Rectangle> taken_;
};

Picture laid_out(const Round& round) {
  constexpr double size = 480, middle = size / 2, circle_radius = 205;
  const double node_radius = std::min(19.0, 0.42 * circle_radius * spacing(round));
  const bool names_inside = node_radius >= 7;
  const auto at = [&](const Node& node, double radius) {
    const double angle = node.angle * std::numbers::pi / 180;
    return Point{middle + radius * std::cos(angle), middle - radius * std::sin(angle)};
  };

  Picture picture{
      .width = size, .height = size, .title = round.title, .description = round.description};
  Group lines;
  for (const Line& line : round.lines) {
    const Node& from = round.nodes[line.from];
    const Node& to = round.nodes[line.to];
    Mark mark{
        .shape = Segment{at(from, from.radius * circle_radius), at(to, to.radius * circle_radius)},
        .kind = "pair",
        .title = fmt::format("{{{},{}}}", from.name, to.name),
        .style = {.stroke = Paint::series(line.colour)}};
    if (line.dash > 0) {
      mark.style.dash = 4.0 * static_cast<double>(line.dash);
    }
    lines.marks.push_back(std::move(mark));
  }
  const std::size_t count = round.lines.size();
  picture.add({.shape = std::move(lines),
               .kind = "pairs",
               .style = {.stroke_width = count > 200  ? 1
                                         : count > 60 ? 1.6
                                                      : 2.6}});

  Group nodes;
  Group names;
  Taken names_beside;
  for (const Node& node : round.nodes) {
    const Paint fill = node.fill ? Paint::series(*node.fill) : Paint(Paint::Role::ground);
    nodes.marks.push_back({.shape = Disc{at(node, node.radius * circle_radius), node_radius},
                           .kind = "point",
                           .title = node.name,
                           .style = {.fill = fill}});
    if (!names_inside && !node.fill && round.nodes.size() > 60) {
      continue;  // there is no room for all names: those of the blocks must do
    }
    const double usual = names_inside ? std::min(16.0, 0.95 * node_radius) : 10;
    const double room = names_inside ? 1.8 * node_radius : middle - circle_radius - 4;
    const double name_font =
        std::clamp(usual * room / text_width(node.name, usual), std::min(usual, 6.0), usual);
    Point place = names_inside ? at(node, node.radius * circle_radius)
                               : at(node, circle_radius + node_radius + 9);
    place.y += 0.35 * name_font;
    const std::string name = fitted(node.name, room, name_font);
    if (!names_inside && !names_beside.has_room(place, text_width(name, name_font), name_font)) {
      continue;  // who points at the point is told its name
    }
    names.marks.push_back(
        {.shape = Text{.at = place, .content = name, .element = true},
         .style = {.fill = names_inside && node.fill ? Paint::upon(fill) : Paint(Paint::Role::ink),
                   .font_size = name_font}});
  }
  picture.add(
      {.shape = std::move(nodes),
       .kind = "points",
       .style = {.stroke = Paint(Paint::Role::ink), .stroke_width = names_inside ? 1.5 : 0.5}});
  picture.add({.shape = std::move(names), .kind = "names", .style = {.anchor = Anchor::middle}});
  return picture;
}

}  // namespace

FactorFigure factor_figure(const OneFactorization& factorization,
                           std::optional<std::uint32_t> centre) {
  FactorFigure figure{.order = factorization.order, .centre = centre};
  for (const OneFactor& factor : factorization.factors) {
    auto& edges = figure.factors.emplace_back();
    for (const Edge& edge : factor) {
      edges.emplace_back(edge.a, edge.b);
    }
  }
  return figure;
}

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

Picture draw_factors(const FactorFigure& figure) { return laid_out(round_of(figure)); }
Picture draw_circle(const CircleFigure& figure) { return laid_out(round_of(figure)); }

}  // namespace changeover
