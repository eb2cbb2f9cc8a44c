// Pictures as TikZ.
#include <algorithm>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/draw/picture.hpp"
#include "changeover/io/tables.hpp"
#include "draw/write/number.hpp"

namespace changeover {
namespace {

constexpr double bp = 0.75;  // of a pixel

// What a mark looks like once the groups around it have had their say.
struct Look {
  Paint fill = Paint::Role::ink;
  Paint stroke = Paint::Role::none;
  double stroke_width = 1, dash = 0, font_size = 12;
  bool bold = false;
  Anchor anchor = Anchor::start;

  void take(const Style& style) {
    fill = style.fill.value_or(fill);
    stroke = style.stroke.value_or(stroke);
    stroke_width = style.stroke_width.value_or(stroke_width);
    dash = style.dash.value_or(dash);
    font_size = style.font_size.value_or(font_size);
    bold = style.bold.value_or(bold);
    anchor = style.anchor.value_or(anchor);
  }
};

// ∞, which names of elements have, is the one sign of ours that LaTeX does not know by itself.
std::string plain_words(std::string_view text) {
  constexpr std::string_view infinity = "∞";
  std::string words = latex_escaped(text);
  for (std::size_t at = 0; (at = words.find(infinity, at)) != std::string::npos;) {
    words.replace(at, infinity.size(), "$\\infty$");
  }
  return words;
}

class TikzWriter {
 public:
  explicit TikzWriter(Theme theme) : theme_(theme) {}

  std::string write(const Picture& picture) {
    if (theme_ == Theme::dark) {
      Look ground;
      ground.fill = Paint::Role::ground;
      put(Rectangle{.x = 0, .y = 0, .width = picture.width, .height = picture.height}, ground);
    }
    for (const Mark& mark : picture.marks) {
      put(mark, Look());
    }
    std::string title = picture.title;  // it becomes a comment
    std::ranges::replace(title, '\n', ' ');
    std::string head =
        fmt::format("% {}\n\\begin{{tikzpicture}}[x={}bp,y=-{}bp]\n", latex_escaped(title), bp, bp);
    for (const std::string& hex : colours_) {
      head += fmt::format("\\definecolor{{c{0}}}{{HTML}}{{{0}}}\n", hex);
    }
    // So the picture is as large as it says, whatever is in it.
    head += fmt::format("\\useasboundingbox (0,0) rectangle ({},{});\n", coordinate(picture.width),
                        coordinate(picture.height));
    return head + body_ + "\\end{tikzpicture}\n";
  }

 private:
  static std::string at(const Point& point) {
    return fmt::format("({},{})", coordinate(point.x), coordinate(point.y));
  }

  std::string colour(const Paint& paint) {
    const std::string hex = paint.hex(theme_).substr(1);
    colours_.insert(hex);
    return "c" + hex;
  }

  // "\path[draw=…, fill=…, …] "
  void begin(const Look& look, bool may_fill) {
    std::string options;
    const auto add = [&](const std::string& option) {
      options += (options.empty() ? "" : ",") + option;
    };
    if (may_fill && look.fill.role() != Paint::Role::none) {
      add("fill=" + colour(look.fill));
    }
    if (look.stroke.role() != Paint::Role::none) {
      add("draw=" + colour(look.stroke));
      add(fmt::format("line width={}bp", coordinate(bp * look.stroke_width)));
      if (look.dash > 0) {
        add(fmt::format("dash pattern=on {0}bp off {0}bp", coordinate(bp * look.dash)));
      }
    }
    body_ += "\\path[" + options + "] ";
  }

  void put(const Mark& mark, Look look) {
    look.take(mark.style);
    std::visit([&](const auto& shape) { put(shape, look); }, mark.shape);
  }

  void put(const Group& group, const Look& look) {
    for (const Mark& each : group.marks) {
      put(each, look);
    }
  }

  void put(const Rectangle& shape, const Look& look) {
    begin(look, true);
    body_ += shape.radius > 0
                 ? fmt::format("[rounded corners={}bp] ", coordinate(bp * shape.radius))
                 : std::string();
    body_ += fmt::format("{} rectangle {};\n", at({shape.x, shape.y}),
                         at({shape.x + shape.width, shape.y + shape.height}));
  }

  void put(const Segment& shape, const Look& look) {
    begin(look, false);
    body_ += fmt::format("{} -- {};\n", at(shape.from), at(shape.to));
  }

  void put(const Disc& shape, const Look& look) {
    begin(look, true);
    body_ +=
        fmt::format("{} circle[radius={}bp];\n", at(shape.centre), coordinate(bp * shape.radius));
  }

  void put(const Path& shape, const Look& look) {
    begin(look, true);
    for (const std::vector<Point>& part : shape.parts) {
      for (std::size_t i = 0; i < part.size(); ++i) {
        body_ += (i > 0 ? " -- " : "") + at(part[i]);
      }
      body_ += shape.closed ? " -- cycle " : " ";
    }
    body_.back() = ';';
    body_ += '\n';
  }

  void put(const Text& shape, const Look& look) {
    const std::string content = shape.element
                                    ? latex_element(shape.content, shape.introduced, shape.leaving)
                                    : plain_words(shape.content);
    const std::string_view anchor = look.anchor == Anchor::start    ? "base west"
                                    : look.anchor == Anchor::middle ? "base"
                                                                    : "base east";
    const std::string size = coordinate(bp * look.font_size);
    body_ += fmt::format(
        "\\node[anchor={},inner sep=0pt,text={},"
        "font=\\fontsize{{{}bp}}{{{}bp}}\\selectfont{}] at {} "
        "{{{}}};\n",
        anchor, colour(look.fill), size, size, look.bold ? "\\bfseries" : "", at(shape.at),
        content);
  }

  Theme theme_;
  std::set<std::string> colours_;
  std::string body_;
};

}  // namespace

std::string tikz(const Picture& picture, Theme theme) {
  const std::size_t marks = mark_count(picture);
  if (marks > most_marks_of_tikz) {
    throw BadInput(fmt::format(
        "a picture of {} marks is too large for TeX, which takes {}; draw a part with --from and "
        "--to, or write svg",
        marks, most_marks_of_tikz));
  }
  return TikzWriter(theme).write(picture);
}

}  // namespace changeover
