#include "io/read/recipe_handler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "changeover/core/parameters.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"

namespace changeover {

using Type = JsonEvent::Type;

namespace {

// The first five are always needed, the first seven in a complete recipe.
constexpr std::array<std::string_view, 10> keys_of_recipe = {
    "construction", "v",      "k",        "change", "kind",
    "arguments",    "inputs", "strength", "blocks", "provenance"};
constexpr std::size_t always_needed = 5;
constexpr std::size_t complete = 7;

}  // namespace

RecipeHandler::RecipeHandler(const JsonText& json, Needs needs)
    : json_(&json), needed_keys_(needs == Needs::all_keys ? complete : always_needed) {}

void RecipeHandler::on(const JsonEvent& event) {
  if (frames_.empty()) {
    if (event.type != Type::begin_object) {
      json_->fail_expecting(event, "a recipe, {…}");
    }
    started_ = true;
    frames_.emplace_back().offset = event.offset;
    return;
  }
  Frame& frame = frames_.back();
  switch (frame.where) {
    case Where::keys:
      if (event.type == Type::key) {
        on_key(frame, event);
      } else {
        finish_frame(event);
      }
      break;
    case Where::value:
      frame.where = Where::keys;
      on_value(frame, event);
      break;
    case Where::arguments:
      if (event.type == Type::key) {
        frame.argument = event.text;
        frame.where = Where::argument;
      } else {
        frame.where = Where::keys;
      }
      break;
    case Where::argument:
      frame.where = Where::arguments;
      on_argument(frame, event);
      break;
    case Where::inputs:
      if (event.type == Type::end_array) {
        frame.where = Where::keys;
      } else if (event.type == Type::begin_object) {
        frames_.emplace_back().offset = event.offset;
      } else {
        json_->fail_expecting(event, "a recipe, {…}");
      }
      break;
    case Where::blocks:
      if (event.type == Type::end_array) {
        frame.where = Where::keys;
      } else if (event.type == Type::begin_array) {
        frame.recipe.blocks.emplace_back();
        frame.where = Where::block;
      } else {
        json_->fail_expecting(event, "an array of numbers, a block");
      }
      break;
    case Where::block:
      if (event.type == Type::end_array) {
        frame.where = Where::blocks;
      } else if (event.type == Type::natural &&
                 event.natural <= std::numeric_limits<Element>::max()) {
        frame.recipe.blocks.back().push_back(static_cast<Element>(event.natural));
      } else {
        json_->fail_expecting(event, "an element, a number below 2^32");
      }
      break;
  }
}

void RecipeHandler::on_key(Frame& frame, const JsonEvent& event) {
  frame.key = event.text;
  if (std::ranges::find(keys_of_recipe, frame.key) == keys_of_recipe.end()) {
    json_->fail(event.offset,
                fmt::format("unknown key {} in the recipe; remove it, or use a newer program",
                            shown(frame.key)));
  }
  if (std::ranges::find(frame.seen, frame.key) != frame.seen.end()) {
    json_->fail(event.offset, fmt::format("{} is given twice; give it once", shown(frame.key)));
  }
  frame.seen.push_back(frame.key);
  frame.where = Where::value;
}

void RecipeHandler::on_value(Frame& frame, const JsonEvent& event) {
  const std::string& key = frame.key;
  Parameters& p = frame.recipe.parameters;
  const auto number = [&](std::uint64_t most) {
    if (event.type != Type::natural || event.natural > most) {
      json_->fail_expecting(event, fmt::format("a number up to {} for {}", most, key));
    }
    return event.natural;
  };
  const auto begin = [&](Type type, Where where) {
    if (event.type != type) {
      json_->fail_expecting(
          event, type == Type::begin_array ? "an array for " + key : "an object for " + key);
    }
    frame.where = where;
  };
  constexpr std::uint64_t most = std::numeric_limits<Element>::max();
  if (key == "construction") {
    if (event.type != Type::string || event.text.empty()) {
      json_->fail_expecting(event, "the name of a construction in quotes");
    }
    frame.recipe.construction = event.text;
  } else if (key == "provenance") {
    if (event.type != Type::string) {
      json_->fail_expecting(event, "a string for provenance");
    }
    frame.recipe.provenance = event.text;
  } else if (key == "v") {
    p.v = number(most);
  } else if (key == "k") {
    p.k = number(most);
  } else if (key == "change") {
    p.change = number(most);
  } else if (key == "strength") {
    p.strength = static_cast<std::uint32_t>(number(max_strength));
  } else if (key == "kind") {
    const auto kind =
        event.type == Type::string ? kind_from_string(event.text) : std::optional<Kind>();
    if (!kind) {
      json_->fail_expecting(event, "\"linear\" or \"circular\" for kind");
    }
    p.kind = *kind;
  } else if (key == "arguments") {
    begin(Type::begin_object, Where::arguments);
  } else if (key == "inputs") {
    begin(Type::begin_array, Where::inputs);
  } else if (key == "blocks") {
    begin(Type::begin_array, Where::blocks);
  }
}

void RecipeHandler::on_argument(Frame& frame, const JsonEvent& event) {
  if (event.type != Type::natural && event.type != Type::other_number) {
    json_->fail_expecting(event, "a whole number");
  }
  const auto value = parsed<std::int64_t>(event.text);
  if (!value) {
    json_->fail(event.offset, fmt::format("argument {} = {} is not a whole number of 64 bits; "
                                          "correct the recipe",
                                          shown(frame.argument), shown(event.text)));
  }
  if (!frame.recipe.arguments.emplace(frame.argument, *value).second) {
    json_->fail(event.offset,
                fmt::format("argument {} is given twice; give it once", shown(frame.argument)));
  }
}

void RecipeHandler::finish_frame(const JsonEvent& event) {
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  for (const std::string_view needed : std::span(keys_of_recipe).first(needed_keys_)) {
    if (std::ranges::find(frame.seen, needed) == frame.seen.end()) {
      json_->fail(event.offset, fmt::format("the recipe lacks {}; add it", needed));
    }
  }
  if (frames_.empty()) {
    result_ = std::move(frame.recipe);
  } else {
    frames_.back().recipe.inputs.push_back(std::move(frame.recipe));
  }
}

Recipe recipe_at(std::string_view json, const std::string& name, Place origin) {
  const JsonText text{json, name, origin};
  RecipeHandler handler(text);
  parse_json(text, handler);
  return handler.take();
}

}  // namespace changeover
