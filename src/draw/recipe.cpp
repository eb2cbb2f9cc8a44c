// The tree of a recipe.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/draw/draw.hpp"
#include "construct/references.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr double line_font = 12, small_line_font = 11;
constexpr double padding = 10;
constexpr double most_room = 560;  // of a line in a node
constexpr double between = 24, between_levels = 36;
constexpr double node_height = 68;

struct DrawnNode {
  std::vector<std::string> lines;  // name, blocks, construction, work and theorem
  std::string title;
  std::string construction;
  std::uint64_t b = 0;
  std::vector<DrawnNode> inputs;
  double own_width = 0;
  double width = 0;  // of the whole tree below it
};

// "Chafee and Stevens 2025, Theorem 3" for those who read; files are no reference for them.
std::string cited(const Citation& citation, bool whole) {
  std::string place = citation.place.starts_with("src/") ? "" : citation.place;
  constexpr std::string_view ours = "docs/theorems.md";
  for (std::size_t at = place.find(ours); at != std::string::npos; at = place.find(ours)) {
    place.replace(at, ours.size(), "Changeover");
  }
  const Work* const work = find_work(citation.key);
  const std::string words = work == nullptr ? "" : whole ? work->text : work->name;
  return words + (words.empty() || place.empty() ? "" : ", ") + place;
}

DrawnNode node_of(const Recipe& recipe, const Registry& registry) {
  const Construction& construction = registry.construction_of(recipe);
  DrawnNode node;
  node.construction = recipe.construction;
  node.b = registry.build(recipe)->block_count().value_or(0);
  node.lines = {name(recipe.parameters), count_of(node.b, "block"), recipe.construction};
  node.title = construction.explain(recipe);
  if (const std::string by = cited(construction.citation(), false); !by.empty()) {
    node.lines.push_back(by);
    node.title += " " + cited(construction.citation(), true);
  }
  for (const Recipe& input : recipe.inputs) {
    node.inputs.push_back(node_of(input, registry));
  }
  for (std::size_t i = 0; i < node.lines.size(); ++i) {
    node.lines[i] = fitted(node.lines[i], most_room, i == 0 ? line_font : small_line_font, i == 0);
    node.own_width = std::max(
        node.own_width,
        text_width(node.lines[i], i == 0 ? line_font : small_line_font, i == 0) + 2 * padding);
  }
  double inputs = 0;
  for (const DrawnNode& input : node.inputs) {
    inputs += (inputs > 0 ? between : 0) + input.width;
  }
  node.width = std::max(node.own_width, inputs);
  return node;
}

std::size_t depth(const DrawnNode& node) {
  std::size_t deepest = 0;
  for (const DrawnNode& input : node.inputs) {
    deepest = std::max(deepest, depth(input));
  }
  return deepest + 1;
}

// A node with its tree below it, in a strip of node.width from `left`.
void add(Picture& picture, const DrawnNode& node, double left, double top) {
  const double middle = left + node.width / 2;
  double inputs = -between;
  for (const DrawnNode& input : node.inputs) {
    inputs += input.width + between;
  }
  double x = middle - inputs / 2;
  for (const DrawnNode& input : node.inputs) {
    const double to = x + input.width / 2;
    const double bend = top + node_height + between_levels / 2;
    picture.add({.shape = Path{.parts = {{{to, top + node_height + between_levels},
                                          {to, bend},
                                          {middle, bend},
                                          {middle, top + node_height}}}},
                 .kind = "edge",
                 .style = {.fill = Paint(Paint::Role::none),
                           .stroke = Paint(Paint::Role::soft),
                           .stroke_width = 1.5}});
    // The design goes up into what is made of it.
    picture.add({.shape = Path{.parts = {{{middle - 5, top + node_height + 8},
                                          {middle, top + node_height},
                                          {middle + 5, top + node_height + 8}}},
                               .closed = true},
                 .style = {.fill = Paint(Paint::Role::soft)}});
    add(picture, input, x, top + node_height + between_levels);
    x += input.width + between;
  }
  Group group;
  group.marks.push_back(
      {.shape = Rectangle{.x = middle - node.own_width / 2,
                          .y = top,
                          .width = node.own_width,
                          .height = node_height,
                          .radius = 6},
       .style = {
           .fill = Paint(Paint::Role::ground), .stroke = Paint::series(0), .stroke_width = 1.5}});
  double y = top + 4 + (4 - static_cast<double>(node.lines.size())) * 7.5;
  for (std::size_t i = 0; i < node.lines.size(); ++i) {
    y += i == 0 ? 13 : 15;
    Mark line{.shape = Text{.at = {middle, y}, .content = node.lines[i]}};
    if (i == 0) {
      line.style.bold = true;
      line.style.font_size = line_font;
    } else if (i > 1) {
      line.style.fill = Paint(Paint::Role::soft);
    }
    group.marks.push_back(std::move(line));
  }
  picture.add({.shape = std::move(group),
               .kind = "node",
               .title = node.title,
               .data = {{"construction", node.construction}, {"b", std::to_string(node.b)}},
               .style = {.font_size = small_line_font, .anchor = Anchor::middle}});
}

}  // namespace

Picture draw_recipe(const Recipe& recipe, const Registry& registry, const std::string& note) {
  const DrawnNode root = node_of(recipe, registry);
  Picture content;
  content.width = root.width;
  const auto levels = static_cast<double>(depth(root));
  content.height = levels * node_height + (levels - 1) * between_levels;
  content.description =
      "The constructions that make the design, the last one on top; an arrow leads from a design "
      "to what is made of it.";
  add(content, root, 0, 0);
  return framed({.headline = fmt::format("How {} is made", name(recipe.parameters)), .note = note},
                std::move(content));
}

}  // namespace changeover
