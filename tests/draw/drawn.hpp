// Pictures read back, by a parser that shares nothing with their writers: expat for SVG, braces for
// TikZ.
#pragma once

#include <expat.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/draw/picture.hpp"
#include "core/printable.hpp"
#include "message_of.hpp"

namespace changeover {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) {
    ++number;
  }
  return number;
}

using Attributes = std::map<std::string, std::string>;

struct DrawnMark {
  std::string name;  // of the XML element
  Attributes attributes = {};
  std::string title = {};
  std::vector<std::string> within = {};  // the classes of the groups around it
};

/// A text with the room that it takes, as far as that can be known without its font.
struct DrawnText {
  std::string content;
  Attributes attributes;  // with what it inherits
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// What an SVG file shows.
struct Page {
  std::string title, description;
  double width = 0, height = 0;
  std::vector<DrawnMark> marks;
  std::vector<DrawnText> texts;
  std::string fault;  // empty: well-formed, and with nothing in it that a strict policy refuses

  [[nodiscard]] std::size_t count(const std::string& kind) const {
    return static_cast<std::size_t>(
        std::count_if(marks.begin(), marks.end(), [&](const auto& mark) {
          const auto found = mark.attributes.find("class");
          return found != mark.attributes.end() && found->second == kind;
        }));
  }
  [[nodiscard]] std::vector<DrawnMark> all(const std::string& kind) const {
    std::vector<DrawnMark> some;
    for (const DrawnMark& mark : marks) {
      const auto found = mark.attributes.find("class");
      if (found != mark.attributes.end() && found->second == kind) {
        some.push_back(mark);
      }
    }
    return some;
  }
  [[nodiscard]] std::size_t count_with(const std::string& kind, const std::string& name,
                                       const std::string& value) const {
    std::size_t number = 0;
    for (const DrawnMark& mark : all(kind)) {
      const auto found = mark.attributes.find(name);
      number += found != mark.attributes.end() && found->second == value ? 1U : 0U;
    }
    return number;
  }

  /// Two texts that overlap, or one that leaves the page; "" if there is none.
  [[nodiscard]] std::string overlap() const {
    std::vector<const DrawnText*> in_order;
    for (const DrawnText& text : texts) {
      in_order.push_back(&text);
      constexpr double slack = 0.5;
      if (text.left < -slack || text.top < -slack || text.right > width + slack ||
          text.bottom > height + slack) {
        return fmt::format("'{}' leaves the page: {} to {}, {} to {}", text.content, text.left,
                           text.right, text.top, text.bottom);
      }
    }
    std::sort(in_order.begin(), in_order.end(),
              [](const auto* a, const auto* b) { return a->top < b->top; });
    for (std::size_t i = 0; i < in_order.size(); ++i) {
      const DrawnText& a = *in_order[i];
      for (std::size_t j = i + 1; j < in_order.size() && in_order[j]->top < a.bottom; ++j) {
        const DrawnText& b = *in_order[j];
        if (a.left < b.right && b.left < a.right) {
          return fmt::format("'{}' and '{}' overlap at {}, {}", a.content, b.content, b.left,
                             b.top);
        }
      }
    }
    return "";
  }
};

/// Reads a page and fails the test if it is not well-formed or has what it must not have.
inline Page read_svg(const std::string& text) {
  struct State {
    Page page;
    std::vector<DrawnMark> open;
    std::vector<Attributes> inherited = {{}};
    std::string text;
    static void start(void* self, const XML_Char* name, const XML_Char** attributes) {
      static_cast<State*>(self)->begin(name, attributes);
    }
    static void finish(void* self, const XML_Char* /*name*/) { static_cast<State*>(self)->end(); }
    static void letters(void* self, const XML_Char* letters, int length) {
      static_cast<State*>(self)->text.append(letters, static_cast<std::size_t>(length));
    }

    void begin(const std::string& name, const XML_Char** attributes) {
      static const std::vector<std::string> allowed = {"svg",  "title", "desc",   "g",    "rect",
                                                       "line", "path",  "circle", "text", "tspan"};
      if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
        page.fault = "an element " + name;
      }
      DrawnMark mark{.name = name};
      Attributes all = inherited.back();
      for (const XML_Char** at = attributes; *at != nullptr; at += 2) {
        const std::string attribute = at[0];
        if (attribute == "style" || attribute == "id" || attribute.starts_with("on") ||
            attribute.find("href") != std::string::npos) {
          page.fault = "an attribute " + attribute;
        }
        mark.attributes[attribute] = at[1];
        all[attribute] = at[1];
      }
      for (const DrawnMark& around : open) {
        if (around.attributes.contains("class")) {
          mark.within.push_back(around.attributes.at("class"));
        }
      }
      if (name != "title" && name != "tspan") {
        text.clear();
      }
      if (name == "title" || name == "desc") {
        text.clear();
      }
      open.push_back(mark);
      inherited.push_back(all);
    }

    void end() {
      const DrawnMark mark = open.back();
      const Attributes all = inherited.back();
      open.pop_back();
      inherited.pop_back();
      if (mark.name == "title") {
        (open.size() == 1 ? page.title : open.back().title) = text;
        text.clear();
      } else if (mark.name == "desc") {
        page.description = text;
      } else if (mark.name == "text") {
        add_text(all);
      } else if (mark.name == "svg") {
        page.width = std::stod(mark.attributes.at("width"));
        page.height = std::stod(mark.attributes.at("height"));
        if (mark.attributes.at("role") != "img" || !mark.attributes.contains("viewBox")) {
          page.fault = "the root";
        }
      }
      if (mark.name != "title" && mark.name != "tspan") {
        page.marks.push_back(mark);
      }
    }

    void add_text(const Attributes& all) {
      const double size = std::stod(all.at("font-size"));
      double width = 0;
      for (std::string_view rest = text; !rest.empty();) {
        const CodePoint point = first_code_point(rest);
        rest.remove_prefix(point.bytes);
        const bool narrow = point.value == '*' || point.value == ',' || point.value == '.' ||
                            point.value == ' ' || point.value == '1';
        width += (point.value > 0x2E00 ? 1.0 : narrow ? 0.4 : 0.58) * size;
      }
      const bool bold = all.contains("font-weight") && all.at("font-weight") == "bold";
      width *= bold ? 1.08 : 1;
      const std::string anchor = all.contains("text-anchor") ? all.at("text-anchor") : "start";
      const double x = std::stod(all.at("x"));
      const double y = std::stod(all.at("y"));
      const double left = anchor == "start" ? x : anchor == "end" ? x - width : x - width / 2;
      page.texts.push_back({text, all, left, y - 0.74 * size, left + width, y + 0.1 * size});
    }
  };
  State state;
  XML_Parser parser = XML_ParserCreate("UTF-8");
  XML_SetUserData(parser, &state);
  XML_SetElementHandler(parser, State::start, State::finish);
  XML_SetCharacterDataHandler(parser, State::letters);
  if (XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) != XML_STATUS_OK) {
    state.page.fault = XML_ErrorString(XML_GetErrorCode(parser));
  }
  XML_ParserFree(parser);
  EXPECT_EQ(state.page.fault, "");
  EXPECT_NE(state.page.title, "");
  return state.page;
}

inline void check_tikz(const std::string& text) {
  EXPECT_TRUE(text.find("\n\\begin{tikzpicture}") != std::string::npos);
  EXPECT_TRUE(text.ends_with("\\end{tikzpicture}\n"));
  int depth = 0;
  int brackets = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    brackets += depth > 0 ? 0 : text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    ASSERT_GE(depth, 0);
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(brackets, 0);
}

/// No text overlaps another or leaves the page, light or dark, and TeX would take it.
inline void expect_legible(const Picture& picture) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    EXPECT_EQ(read_svg(svg(picture, theme)).overlap(), "") << picture.title;
  }
  check_tikz(tikz(picture));
}

}  // namespace changeover
