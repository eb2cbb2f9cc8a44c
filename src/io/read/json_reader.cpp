#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "io/read/declared.hpp"
#include "io/read/recipe_handler.hpp"
#include "io/scan/json_events.hpp"

namespace changeover {
namespace {

using EventType = JsonEvent::Type;

// Calls visit(event) for each element of the blocks; knows only the shape.
class BlockFinder final : public JsonHandler {
 public:
  struct Found {
    std::size_t offset;
  };

  explicit BlockFinder(std::uint64_t element) : left_(element) {}

  void on(const JsonEvent& event) override {
    switch (event.type) {
      case EventType::begin_object:
      case EventType::begin_array:
        if (depth_ == 0 && event.type == EventType::begin_array) {
          in_blocks_ = true;
          blocks_depth_ = 0;
        }
        ++depth_;
        break;
      case EventType::end_object:
      case EventType::end_array:
        --depth_;
        break;
      case EventType::key:
        if (depth_ == 1) {
          in_blocks_ = event.text == "blocks";
          blocks_depth_ = 1;
        }
        break;
      default:
        if (in_blocks_ && depth_ == blocks_depth_ + 2 && left_-- == 0) {
          throw Found{event.offset};
        }
    }
  }

 private:
  std::uint64_t left_;
  std::size_t depth_ = 0;
  std::size_t blocks_depth_ = 0;
  bool in_blocks_ = false;
};

class DesignHandler final : public JsonHandler {
 public:
  explicit DesignHandler(const JsonText& json) : json_(&json) {}

  void on(const JsonEvent& event) override {
    if (recipe_handler_) {
      recipe_handler_->on(event);
      if (recipe_handler_->done()) {
        recipe_ = recipe_handler_->take();
        recipe_handler_.reset();
      }
    } else if (skipped_ > 0) {
      skip(event);
    } else if (where_ == Where::start) {
      start(event);
    } else if (where_ == Where::document) {
      on_document(event);
    } else if (where_ == Where::value) {
      where_ = Where::document;
      on_value(event);
    } else if (where_ == Where::labels) {
      on_label(event);
    } else if (where_ == Where::blocks) {
      on_blocks(event);
    } else {
      on_element(event);
    }
  }

  Design finish(const ReadOptions& options) {
    if (!has_blocks_) {
      json_->fail(end_, "no key \"blocks\"; add it, or name another file");
    }
    // Other programs count points from 1: then these are names, and all of them occur.
    const auto v = file_.v;
    const bool from_one =
        !is_ours_ && v && !options.v && !labels_ && least_ == 1 && greatest_ == *v;
    if (from_one) {
      file_.v.reset();
    }
    Collector::Context context{
        .name = json_->name,
        .declared = merged(json_->name, options, file_),
        .labels = std::move(labels_),
        .labels_place = json_->place(labels_offset_),
        .place = json_->place(start_),
        .named = false,
        .place_of_word = [this](std::uint64_t word) { return place_of_element(word); }};
    Design design = collector_.finish(context);
    if (from_one && design.parameters().v != *v) {
      json_->fail(start_,
                  fmt::format("points are counted from 1 to v={}, but only {} of them occur; "
                              "count them from 0, or correct v",
                              *v, design.parameters().v));
    }
    design.recipe = std::move(recipe_);
    return design;
  }

 private:
  enum class Where : std::uint8_t { start, document, value, labels, blocks, block };

  void skip(const JsonEvent& event) {
    if (event.type == EventType::begin_array || event.type == EventType::begin_object) {
      ++skipped_;
    } else if (event.type == EventType::end_array || event.type == EventType::end_object) {
      --skipped_;
    }
  }

  void start(const JsonEvent& event) {
    start_ = event.offset;
    if (event.type == EventType::begin_array) {
      bare_ = has_blocks_ = true;
      where_ = Where::blocks;
    } else if (event.type == EventType::begin_object) {
      where_ = Where::document;
    } else {
      json_->fail_expecting(event, "an object with the key \"blocks\"");
    }
  }

  void on_document(const JsonEvent& event) {
    if (event.type == EventType::key) {
      key_ = event.text;
      key_offset_ = event.offset;
      where_ = Where::value;
    } else {
      end_ = event.offset;  // of the object: nothing comes after it
    }
  }

  void on_value(const JsonEvent& event) {
    if (event.type == EventType::null) {
      return;
    }
    if (key_ == "format") {
      is_ours_ = true;
      if (event.type != EventType::string || event.text != "changeover-design/1") {
        json_->fail(event.offset,
                    "format is not \"changeover-design/1\"; this is another kind of "
                    "file, or of a later version");
      }
    } else if (key_ == "t" && !is_ours_ && event.type == EventType::natural) {
      key_ = "strength";  // as repositories of coverings call it
      declare(event);
    } else if (key_ == "v" || key_ == "k" || key_ == "change" || key_ == "strength") {
      if (event.type != EventType::natural && event.type != EventType::other_number) {
        json_->fail_expecting(event, "a number for " + key_);
      }
      declare(event);
    } else if (key_ == "kind") {
      if (event.type != EventType::string) {
        json_->fail_expecting(event, "\"linear\" or \"circular\" for kind");
      }
      declare(event);
    } else if (key_ == "labels") {
      begin_list(event, labels_.has_value());
      labels_.emplace();
      labels_offset_ = event.offset;
      where_ = Where::labels;
    } else if (key_ == "blocks") {
      begin_list(event, has_blocks_);
      has_blocks_ = true;
      where_ = Where::blocks;
    } else if (key_ == "recipe") {
      if (event.type != EventType::begin_object) {
        json_->fail_expecting(event, "an object for recipe");
      }
      if (recipe_) {
        given_twice();
      }
      recipe_handler_.emplace(*json_);
      recipe_handler_->on(event);
    } else {
      skip(event);
    }
  }

  void declare(const JsonEvent& event) {
    if (const auto defect = changeover::declare(file_, key_, event.text)) {
      json_->fail(event.offset, *defect);
    }
  }

  void begin_list(const JsonEvent& event, bool again) {
    if (event.type != EventType::begin_array) {
      json_->fail_expecting(event, "an array for " + key_);
    }
    if (again) {
      given_twice();
    }
  }

  [[noreturn]] void given_twice() const {
    json_->fail(key_offset_, fmt::format("{} is given twice; give it once", key_));
  }

  void on_label(const JsonEvent& event) {
    if (event.type == EventType::end_array) {
      where_ = Where::document;
      return;
    }
    if (event.type != EventType::string && event.type != EventType::natural) {
      json_->fail_expecting(event, "a label in quotes");
    }
    if (const auto defect = add_label(known_labels_, event.text)) {
      json_->fail(event.offset, *defect);
    }
    labels_->emplace_back(event.text);
  }

  void on_blocks(const JsonEvent& event) {
    if (event.type == EventType::begin_array) {
      where_ = Where::block;
    } else if (event.type == EventType::end_array) {
      where_ = Where::document;
      end_ = event.offset;
    } else {
      json_->fail_expecting(event, "an array of elements, a block");
    }
  }

  void on_element(const JsonEvent& event) {
    std::optional<std::string> defect;
    if (event.type == EventType::natural) {
      least_ = std::min(least_, event.natural);
      greatest_ = std::max(greatest_, event.natural);
      defect = collector_.add(event.text == "-0" ? "0" : event.text);
    } else if (event.type == EventType::string) {
      quoted_.assign(1, '"').append(event.text);
      defect = collector_.add(quoted_);
    } else if (event.type == EventType::end_array) {
      where_ = Where::blocks;
      defect = collector_.end_block();
    } else if (event.type == EventType::other_number && plain_number(event.text)) {
      defect = collector_.add(event.text);  // too large for a machine word, not for a name
    } else if (event.type == EventType::other_number) {
      defect = fmt::format("element {} is not a whole number; write 0 or more", shown(event.text));
    } else {
      json_->fail_expecting(event, "an element, a number or a label in quotes");
    }
    if (defect) {
      json_->fail(event.offset, *defect);
    }
  }

  Place place_of_element(std::uint64_t element) const {
    BlockFinder finder(element);
    try {
      parse_json(*json_, finder);
    } catch (const BlockFinder::Found& found) {
      return json_->place(found.offset);
    }
    throw InternalError("an element of a design in JSON was lost");
  }

  const JsonText* json_;
  Where where_ = Where::start;
  bool bare_ = false;
  bool has_blocks_ = false;
  std::size_t skipped_ = 0;  // depth within a value that is ignored
  std::size_t start_ = 0, end_ = 0;
  std::string key_;
  std::size_t key_offset_ = 0;
  std::string quoted_;
  ReadOptions file_;
  bool is_ours_ = false;
  std::uint64_t least_ = UINT64_MAX;  // of the elements that are numbers
  std::uint64_t greatest_ = 0;
  std::optional<std::vector<std::string>> labels_;
  std::size_t labels_offset_ = 0;
  TokenTable known_labels_;
  Collector collector_;
  std::optional<Recipe> recipe_;
  std::optional<RecipeHandler> recipe_handler_;
};

}  // namespace

Design read_json(Input& input, const ReadOptions& options) {
  const std::string text = read_to_end(input);
  const JsonText json{without_byte_order_mark(text), input.name()};
  DesignHandler handler(json);
  parse_json(json, handler);
  return handler.finish(options);
}

Recipe recipe_from_json(std::string_view json, const std::string& name) {
  return recipe_at(json, name, {});
}

}  // namespace changeover
