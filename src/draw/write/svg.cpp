// Pictures as SVG.

#include "changeover/draw/picture.hpp"
#include "core/printable.hpp"
#include "draw/text/measure.hpp"
#include "draw/write/number.hpp"

namespace changeover {
namespace {

std::string escaped(std::string_view text) {
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

class Writer {
 public:
  explicit Writer(Theme theme) : theme_(theme) {}

  std::string write(const Picture& picture) {
    const std::string width = coordinate(picture.width);
    const std::string height = coordinate(picture.height);
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" role=\"img\" class=\"changeover {2}\" fill=\"{3}\" "
        "font-size=\"12\" font-family=\"'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\">\n",
        width, height, to_string(theme_), Paint(Paint::Role::ink).hex(theme_));
    out_ += fmt::format("<title>{}</title>\n", escaped(picture.title));
    if (!picture.description.empty()) {
      out_ += fmt::format("<desc>{}</desc>\n", escaped(picture.description));
    }
    out_ += fmt::format("<rect class=\"ground\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", width,
                        height, Paint(Paint::Role::ground).hex(theme_));
    for (const Mark& mark : picture.marks) {
      put(mark, 12);
    }
    return std::move(out_) + "</svg>\n";
  }

 private:
  void number(std::string_view name, double value) {
    out_ += fmt::format(" {}=\"{}\"", name, coordinate(value));
  }

  void paint(std::string_view name, const std::optional<Paint>& paint) {
    if (paint) {
      const std::string hex = paint->hex(theme_);
      out_ += fmt::format(" {}=\"{}\"", name, hex.empty() ? "none" : hex);
    }
  }

  void attributes(const Mark& mark) {
    if (!mark.kind.empty()) {
      out_ += fmt::format(" class=\"{}\"", escaped(mark.kind));
    }
    for (const auto& [name, value] : mark.data) {
      out_ += fmt::format(" data-{}=\"{}\"", name, escaped(value));
    }
    const Style& style = mark.style;
    paint("fill", style.fill);
    paint("stroke", style.stroke);
    if (style.stroke_width) {
      number("stroke-width", *style.stroke_width);
    }
    if (style.dash) {
      out_ += *style.dash > 0
                  ? fmt::format(" stroke-dasharray=\"{0} {0}\"", coordinate(*style.dash))
                  : " stroke-dasharray=\"none\"";
    }
    if (style.font_size) {
      number("font-size", *style.font_size);
    }
    if (style.bold) {
      out_ += *style.bold ? " font-weight=\"bold\"" : " font-weight=\"normal\"";
    }
    if (style.anchor) {
      out_ += fmt::format(" text-anchor=\"{}\"", *style.anchor == Anchor::start    ? "start"
                                                 : *style.anchor == Anchor::middle ? "middle"
                                                                                   : "end");
    }
  }

  void put(const Mark& mark, double font_size) {
    font_size = mark.style.font_size.value_or(font_size);
    std::visit([&](const auto& shape) { put(mark, shape, font_size); }, mark.shape);
  }

  // Ends a mark that has nothing in it but its title.
  void end(const Mark& mark, std::string_view name) {
    out_ += mark.title.empty()
                ? "/>\n"
                : fmt::format("><title>{}</title></{}>\n", escaped(mark.title), name);
  }

  void put(const Mark& mark, const Group& group, double font_size) {
    out_ += "<g";
    attributes(mark);
    out_ += ">\n";
    if (!mark.title.empty()) {
      out_ += fmt::format("<title>{}</title>\n", escaped(mark.title));
    }
    for (const Mark& each : group.marks) {
      put(each, font_size);
    }
    out_ += "</g>\n";
  }

  void put(const Mark& mark, const Rectangle& shape, double /*font_size*/) {
    out_ += "<rect";
    attributes(mark);
    number("x", shape.x);
    number("y", shape.y);
    number("width", shape.width);
    number("height", shape.height);
    if (shape.radius > 0) {
      number("rx", shape.radius);
    }
    end(mark, "rect");
  }

  void put(const Mark& mark, const Segment& shape, double /*font_size*/) {
    out_ += "<line";
    attributes(mark);
    number("x1", shape.from.x);
    number("y1", shape.from.y);
    number("x2", shape.to.x);
    number("y2", shape.to.y);
    end(mark, "line");
  }

  void put(const Mark& mark, const Disc& shape, double /*font_size*/) {
    out_ += "<circle";
    attributes(mark);
    number("cx", shape.centre.x);
    number("cy", shape.centre.y);
    number("r", shape.radius);
    end(mark, "circle");
  }

  void put(const Mark& mark, const Path& shape, double /*font_size*/) {
    out_ += "<path";
    attributes(mark);
    out_ += " d=\"";
    for (const std::vector<Point>& part : shape.parts) {
      for (std::size_t i = 0; i < part.size(); ++i) {
        const std::string x = coordinate(part[i].x);
        const std::string y = coordinate(part[i].y);
        if (i == 0) {
          out_ += fmt::format("M{} {}", x, y);
        } else if (part[i].y == part[i - 1].y) {
          out_ += "H" + x;
        } else if (part[i].x == part[i - 1].x) {
          out_ += "V" + y;
        } else {
          out_ += fmt::format("L{} {}", x, y);
        }
      }
      out_ += shape.closed ? "Z" : "";
    }
    out_ += "\"";
    end(mark, "path");
  }

  void put(const Mark& mark, const Text& shape, double font_size) {
    out_ += "<text";
    attributes(mark);
    number("x", shape.at.x);
    number("y", shape.at.y);
    out_ += ">";
    if (!mark.title.empty()) {
      out_ += fmt::format("<title>{}</title>", escaped(mark.title));
    }
    // One underscore with something on both sides makes a subscript, as in TeX.
    const std::size_t under = shape.content.find('_');
    const bool subscript = shape.element && under != std::string::npos && under > 0 &&
                           under + 1 < shape.content.size() && shape.content.rfind('_') == under;
    out_ += escaped(shape.content.substr(0, subscript ? under : std::string::npos));
    double level = 0;  // below the baseline, in units of the font size
    const auto piece = [&](const std::string& text, double size, double down) {
      out_ +=
          fmt::format("<tspan font-size=\"{}\" dy=\"{}\">{}</tspan>", coordinate(size * font_size),
                      coordinate((down - level) * font_size), text);
      level = down;
    };
    if (subscript) {
      piece(escaped(shape.content.substr(under + 1)), 0.75, 0.22);
    }
    // A star stands high in its line already, so one below goes down by more than one above goes
    // up.
    if (shape.introduced) {
      piece("*", star_size, -0.15);
    }
    if (shape.leaving) {
      piece("*", star_size, 0.6);
    }
    out_ += "</text>\n";
  }

  Theme theme_;
  std::string out_;
};

std::size_t count(const std::vector<Mark>& marks) {
  std::size_t number = 0;
  for (const Mark& mark : marks) {
    const auto* const group = std::get_if<Group>(&mark.shape);
    number += group == nullptr ? 1 : count(group->marks);
  }
  return number;
}

}  // namespace

std::size_t mark_count(const Picture& picture) { return count(picture.marks); }

std::string svg(const Picture& picture, Theme theme) { return Writer(theme).write(picture); }

}  // namespace changeover
