// Points on a circle: base blocks with their differences, or the first blocks of a list.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "changeover/draw/draw.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"
#include "draw/text/measure.hpp"

namespace changeover {
namespace {

constexpr double list_width = 330;
constexpr double font = 12;
constexpr double list_line = 17;

// What a block newly covers, in words: "5" between elements of the only cycle, "0:5" of cycle 0,
// "0-1:5" from cycle 0 to cycle 1, ∞ for a pair with a fixed element.
std::vector<std::string> differences_of(const DrawnBlock& block, const Automorphism& pi) {
  const auto is_new = [&](Element x) {
    return std::ranges::find(block.introduced, x) != block.introduced.end();
  };
  std::vector<std::array<std::uint64_t, 3>> differences;  // two cycles and the difference
  std::size_t with_fixed = 0;
  for (std::size_t a = 1; a < block.elements.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto [x, y] = std::minmax(block.elements[a], block.elements[b]);
      if (!is_new(x) && !is_new(y)) {
        continue;
      }
      if (!pi.moves(y)) {
        ++with_fixed;
        continue;
      }
      const std::uint64_t apart = (pi.residue(y) + pi.n - pi.residue(x)) % pi.n;
      const bool pure = pi.cycle(x) == pi.cycle(y);
      differences.push_back(
          {pi.cycle(x), pi.cycle(y), pure ? std::min(apart, pi.n - apart) : apart});
    }
  }
  std::ranges::sort(differences);
  std::vector<std::string> words = {"new differences:"};
  for (const auto& [from, to, apart] : differences) {
    words.push_back(pi.cycles == 1 ? fmt::format("{}", apart)
                    : from == to   ? fmt::format("{}:{}", from, apart)
                                   : fmt::format("{}-{}:{}", from, to, apart));
  }
  words.insert(words.end(), with_fixed, "∞");
  return words;
}

// Words in lines that fit.
std::vector<std::string> lines_of(const std::vector<std::string>& words, double width) {
  std::vector<std::string> lines = {""};
  for (const std::string& word : words) {
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
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
    y_ += list_line;
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
        {.shape = Rectangle{.x = left_, .y = y_ + list_line - 10, .width = 11, .height = 11},
         .style = {.fill = paint}});
    lines(words, false);
  }

  double height() const { return y_ + list_line; }
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
  drawing.require_range(design.block_count());
  std::optional<FoundRotation> rotation;
  if (drawing.is_whole()) {
    rotation = find_rotation(design);
    if (rotation && rotation->base_blocks.size() > most_circle_blocks) {
      rotation.reset();
    }
  }
  const std::uint64_t first = drawing.options.from - 1;
  const std::uint64_t base_blocks = rotation ? rotation->base_blocks.size() : 0;
  const std::uint64_t named =
      drawing.options.to ? *drawing.options.to - first : std::max<std::uint64_t>(2, base_blocks);
  CircleFigure figure = circle_figure(design, first, std::min(named, most_circle_blocks));
  if (rotation && rotation->pi.cycles == 1 && rotation->pi.fixed == 1) {
    figure.centre = static_cast<std::uint32_t>(rotation->pi.n);
  }

  Picture content = draw_circle(figure);
  BlockList list(content.width + 10);
  if (rotation) {
    const Automorphism& pi = rotation->pi;
    const std::string developed = count_of(base_blocks, "base block");
    if (pi.cycles == 1) {
      list.headline(
          fmt::format("{} over Z_{}, developed by +{}", developed, pi.n, rotation->shift));
    } else {
      list.headline(fmt::format("{}, {} cycles of length {}", developed, pi.cycles, pi.n));
      list.headline("o:d within cycle o, o-p:d from cycle o to cycle p");
    }
    if (pi.fixed > 0) {
      const std::string fixed = joined(std::views::iota(pi.moved(), pi.v()), [&](std::uint64_t x) {
        return drawing.name(static_cast<Element>(x));
      });
      list.headline(fmt::format("{} {} (∞)", fixed,
                                pi.fixed == 1 ? "stays where it is" : "stay where they are"));
    }
  } else {
    list.headline(fmt::format("blocks {} to {} and what they newly cover", first + 1,
                              first + figure.blocks.size()));
  }
  for (std::size_t i = 0; i < figure.blocks.size(); ++i) {
    const DrawnBlock& block = figure.blocks[i];
    std::vector<std::string> words = {fmt::format("B{} =", first + i + 1)};
    for (const Element x : block.elements) {
      const bool is_new = std::ranges::find(block.introduced, x) != block.introduced.end();
      words.push_back(drawing.name(x) + (is_new ? "*" : ""));
    }
    list.block(Paint::series(i % (Paint::series_length - 1)), words);
    if (rotation && i < base_blocks) {
      list.lines(differences_of(block, rotation->pi), true);
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
