#include "changeover/draw/draw.hpp"

#include <fmt/format.h>

#include <array>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "draw/design/frame.hpp"

namespace changeover {
namespace {

// What to do about too many blocks.
constexpr std::string_view a_part = "draw a part of them with --from and --to";

}  // namespace

std::string_view to_string(PictureKind kind) {
  constexpr std::array<std::string_view, 5> names = {"array", "stays", "coverage", "circle",
                                                     "recipe"};
  return names.at(static_cast<std::size_t>(kind));
}

std::optional<PictureKind> picture_kind_from_string(std::string_view name) {
  return named(name, {PictureKind::array, PictureKind::stays, PictureKind::coverage,
                      PictureKind::circle, PictureKind::recipe});
}

std::string_view to_string(ElementOrder order) {
  constexpr std::array<std::string_view, 3> names = {"first", "stays", "given"};
  return names.at(static_cast<std::size_t>(order));
}

std::optional<ElementOrder> element_order_from_string(std::string_view name) {
  return named(name, {ElementOrder::first, ElementOrder::stays, ElementOrder::given});
}

std::string_view to_string(StayColour colour) {
  return colour == StayColour::length ? "length" : "ordinal";
}

std::optional<StayColour> stay_colour_from_string(std::string_view name) {
  return named(name, {StayColour::length, StayColour::ordinal});
}

std::optional<std::string> range_defect(const DrawOptions& options) {
  if (options.from < 1) {
    return "--from 0: blocks are counted from 1; give 1 or more";
  }
  if (options.to && *options.to < options.from) {
    return fmt::format(
        "--from {} --to {}: there is no block between; write the smaller number first",
        options.from, *options.to);
  }
  return std::nullopt;
}

std::optional<std::string> draw_defect(const Parameters& p, std::uint64_t b,
                                       const DrawOptions& options) {
  if (auto defect = range_defect(options)) {
    return defect;
  }
  const std::uint64_t last = std::min(b, options.to.value_or(b));
  const std::uint64_t drawn = last < options.from ? 0 : last - options.from + 1;
  const std::string_view name = to_string(options.picture);
  const auto elements = [&](std::uint64_t most) -> std::optional<std::string> {
    if (p.v > most) {
      return fmt::format(
          "a picture of kind {} has at most {} elements, not v = {}; draw another kind", name, most,
          p.v);
    }
    return std::nullopt;
  };
  switch (options.picture) {
    case PictureKind::array:
      if (drawn > most_drawn_blocks ||
          drawn > most_drawn_elements / std::max<std::uint64_t>(1, p.k)) {
        return fmt::format("{} of {} elements are too many for one picture; {}",
                           count_of(drawn, "block"), p.k, a_part);
      }
      return elements(max_elements_in_memory);
    case PictureKind::stays:
      if (drawn > most_drawn_blocks) {
        return fmt::format("{} are too many for one picture; {}", count_of(drawn, "block"), a_part);
      }
      return elements(most_drawn_rows);
    case PictureKind::coverage:
      return elements(most_drawn_lines);
    case PictureKind::circle:
      if (b > most_read_elements / std::max<std::uint64_t>(1, p.k)) {
        return fmt::format("{} of {} elements are too many to look for a rotation in them",
                           count_of(b, "block"), p.k);
      }
      return elements(most_drawn_points);
    case PictureKind::recipe:
      return std::nullopt;
  }
  return std::nullopt;
}

std::string Drawing::set(const std::vector<Element>& elements) const {
  std::string text = "{";
  for (const Element x : elements) {
    text += (text.size() > 1 ? "," : "") + name(x);
  }
  return text + "}";
}

Heading Drawing::heading() const {
  std::string headline = options.name.empty() ? changeover::name(parameters()) : options.name;
  const std::optional<std::uint64_t> b = source.block_count();
  if (options.name.empty() && b) {
    headline += ", " + count_of(*b, "block");
  }
  const bool to_the_end = !options.to || (b && *options.to >= *b);
  if (options.from > 1 || !to_the_end) {
    headline += to_the_end ? fmt::format(", from block {}", options.from)
                           : fmt::format(", blocks {} to {}", options.from, *options.to);
  }
  return {.headline = headline, .note = options.note};
}

std::string Drawing::summary() const {
  return fmt::format("{}, blocks of {}", count_of(parameters().v, "element"), parameters().k);
}

void Drawing::require_range(std::uint64_t last) const {
  if (last == 0 && options.from == 1) {
    throw BadInput("there is no block to draw");
  }
  if (last < options.from) {
    throw BadOption(
        fmt::format("--from {}: there are fewer blocks; give a smaller number", options.from));
  }
  if (options.to && last < *options.to) {
    throw BadOption(fmt::format("--to {}: there are only {}; give a smaller number", *options.to,
                                count_of(last, "block")));
  }
}

void Drawing::require_fits(std::uint64_t drawn) const {
  const std::uint64_t last = options.from - 1 + drawn;
  if (const auto defect = draw_defect(parameters(), last, options)) {
    throw BadInput(*defect);
  }
}

Picture draw(BlockSource& source, const DrawOptions& options,
             const std::vector<std::string>& labels) {
  if (!labels.empty() && labels.size() != source.parameters().v) {
    throw BadInput(fmt::format("{} for {}; give one each", count_of(labels.size(), "name"),
                               count_of(source.parameters().v, "element")));
  }
  if (const auto defect = range_defect(options)) {
    throw BadOption(*defect);
  }
  if (const auto defect =
          draw_defect(source.parameters(), source.block_count().value_or(0), options)) {
    throw BadInput(*defect);
  }
  const Drawing drawing{source, options, labels};
  switch (options.picture) {
    case PictureKind::array:
      return draw_array(drawing);
    case PictureKind::stays:
      return draw_stays(drawing);
    case PictureKind::coverage:
      return draw_coverage(drawing);
    case PictureKind::circle:
      return draw_design_circle(drawing);
    case PictureKind::recipe:
      break;
  }
  throw BadInput("the design has no recipe to draw; draw another picture");
}

Picture draw(const Design& design, const DrawOptions& options) {
  if (options.picture == PictureKind::recipe && design.recipe) {
    return draw_recipe(*design.recipe, Registry::standard(), options.note);
  }
  DesignSource source(design);
  return draw(source, options, design.labels());
}

}  // namespace changeover
