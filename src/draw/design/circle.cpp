// Points on a circle: base blocks with their differences, or the first blocks of a list.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/draw/figures.hpp"
#include "draw/design/pictures.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_blocks = 12;  // more lines than that say nothing
constexpr double list_width = 330;
constexpr double font = 12;
constexpr double line_height = 17;

// What a block newly covers, in words: ∞ for a pair with the fixed element.
std::vector<std::string> differences_of(const DrawnBlock& block, std::uint64_t n) {
  const auto is_new = [&](Element x) {
    return std::find(block.introduced.begin(), block.introduced.end(), x) != block.introduced.end();
  };
  std::vector<std::uint64_t> differences;
  std::size_t with_fixed = 0;
  for (std::size_t a = 1; a < block.elements.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Element x = block.elements[a];
      const Element y = block.elements[b];
      if (!is_new(x) && !is_new(y)) {
        continue;
      }
      if (x >= n || y >= n) {
        ++with_fixed;
        continue;
      }
      const std::uint64_t apart = x > y ? x - y : y - x;
      differences.push_back(std::min(apart, n - apart));
    }
  }
  std::sort(differences.begin(), differences.end());
  std::vector<std::string> words = {"new differences:"};
  for (const std::uint64_t difference : differences) {
    words.push_back(std::to_string(difference));
  }
  words.insert(words.end(), with_fixed, "∞");
  return words;
}

// Words in lines that fit.
std::vector<std::string> lines_of(const std::vector<std::string>& words, double width) {
  std::vector<std::string> lines = {""};
  for (const std::string& word : words) {
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && text_width(longer, font) > width) {
      lines.push_back(word);
    } else {
      line = longer;
    }
  }
  return lines;
}

class BlockList {
 public:
  explicit BlockList(double left) : left_(left) {}

  void headline(const std::string& text) { line(text, false, 0); }
  void line(const std::string& text, bool soft, double indent = 18) {
    y_ += line_height;
    Mark mark{.shape = Text{.at = {left_ + indent, y_},
                            .content = fitted(text, list_width - indent, font)}};
    if (soft) {
      mark.style.fill = Paint(Paint::Role::soft);
    }
    list_.marks.push_back(std::move(mark));
  }
  void lines(const std::vector<std::string>& words, bool soft) {
    for (const std::string& each : lines_of(words, list_width - 18)) {
      line(each, soft);
    }
  }
  void block(const Paint& paint, const std::vector<std::string>& words) {
    y_ += 6;
    list_.marks.push_back(
        {.shape = Rectangle{.x = left_, .y = y_ + line_height - 10, .width = 11, .height = 11},
         .style = {.fill = paint}});
    lines(words, false);
  }

  double height() const { return y_ + line_height; }
  Mark take() {
    return {.shape = std::move(list_), .kind = "blocks", .style = {.font_size = font}};
  }

 private:
  double left_, y_ = 0;
  Group list_;
};

}  // namespace

Picture draw_design_circle(const Drawing& drawing) {
  Design design = read_all(drawing.source);
  design.set_labels(drawing.labels);
  drawing.require_blocks(design.block_count());
  std::optional<FoundRotation> rotation;
  if (drawing.is_whole()) {
    rotation = find_rotation(design);
    if (rotation && rotation->base_blocks.size() > most_blocks) {
      rotation.reset();
    }
  }
  const std::uint64_t first = drawing.options.from - 1;
  const std::uint64_t base_blocks = rotation ? rotation->base_blocks.size() : 0;
  const std::uint64_t named =
      drawing.options.to ? *drawing.options.to - first : std::max<std::uint64_t>(2, base_blocks);
  CircleFigure figure = circle_figure(design, first, std::min(named, most_blocks));
  drawing.require_blocks(figure.blocks.size());
  if (rotation && rotation->n < design.v()) {
    figure.centre = static_cast<std::uint32_t>(rotation->n);
  }

  Picture content = draw_circle(figure);
  BlockList list(content.width + 10);
  if (rotation) {
    list.headline(fmt::format("{} base block{} over Z_{}, developed by +{}", base_blocks,
                              base_blocks == 1 ? "" : "s", rotation->n, rotation->shift));
    if (figure.centre) {
      list.headline(fmt::format("{} stays where it is (∞)", drawing.name(*figure.centre)));
    }
  } else {
    list.headline(fmt::format("blocks {} to {} and what they newly cover", first + 1,
                              first + figure.blocks.size()));
  }
  for (std::size_t i = 0; i < figure.blocks.size(); ++i) {
    const DrawnBlock& block = figure.blocks[i];
    std::vector<std::string> words = {fmt::format("B{} =", first + i + 1)};
    for (const Element x : block.elements) {
      const bool is_new =
          std::find(block.introduced.begin(), block.introduced.end(), x) != block.introduced.end();
      words.push_back(drawing.name(x) + (is_new ? "*" : ""));
    }
    list.block(Paint::series(i % (Paint::series_length - 1)), words);
    if (rotation && i < base_blocks) {
      list.lines(differences_of(block, rotation->n), true);
    }
  }
  content.width += 10 + list_width;
  content.height = std::max(content.height, list.height());
  content.add(list.take());
  content.title = drawing.heading().headline;
  return framed(drawing.heading(), std::move(content),
                {remark("* introduced; lines join newly covered pairs")});
}

}  // namespace changeover
