#include "io/scan/json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace changeover {
namespace {

class Builder final : public JsonHandler {
 public:
  explicit Builder(const JsonText& json) : json_(json) {}

  void on(const JsonEvent& event) override {
    using Type = JsonEvent::Type;
    if (event.type == Type::end_object || event.type == Type::end_array) {
      open_.pop_back();
      keys_.pop_back();
      return;
    }
    if (event.type == Type::key) {
      key_ = event.text;
      if (!keys_.back().insert(key_).second) {
        json_.fail(event.offset, fmt::format("the key {} is given twice; remove one", shown(key_)));
      }
      return;
    }
    JsonNode node{.type = event.type,
                  .text = std::string(event.text),
                  .natural = event.natural,
                  .offset = event.offset,
                  .members = {}};
    JsonNode* place = &root_;
    if (!open_.empty()) {
      JsonNode& parent = *open_.back();
      parent.members.emplace_back(parent.is_object() ? key_ : std::string(), std::move(node));
      place = &parent.members.back().second;
    } else {
      root_ = std::move(node);
    }
    if (place->is_object() || place->is_array()) {
      // Only the last member of each open node grows, so these pointers stay valid.
      open_.push_back(place);
      keys_.emplace_back();
    }
  }

  [[nodiscard]] JsonNode take() { return std::move(root_); }

 private:
  const JsonText& json_;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  std::vector<std::set<std::string>> keys_;  // of each open node
  std::string key_;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == key; });
  return found == members.end() ? nullptr : &found->second;
}

JsonNode json_tree(const JsonText& json) {
  Builder builder(json);
  parse_json(json, builder);
  return builder.take();
}

}  // namespace changeover
