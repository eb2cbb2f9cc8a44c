// A recipe from the events of its JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "io/scan/json_events.hpp"

namespace changeover {

/// Takes the events of one recipe, from its begin_object to its end_object.
class RecipeHandler final : public JsonHandler {
 public:
  /// Without `all_keys` missing arguments and inputs are empty.
  enum class Needs : std::uint8_t { some_keys, all_keys };

  explicit RecipeHandler(const JsonText& json, Needs needs = Needs::some_keys);

  void on(const JsonEvent& event) override;

  [[nodiscard]] bool done() const { return started_ && frames_.empty(); }
  [[nodiscard]] Recipe take() { return std::move(result_); }

 private:
  enum class Where : std::uint8_t { keys, value, arguments, argument, inputs, blocks, block };
  struct Frame {
    Recipe recipe;
    Where where = Where::keys;
    std::string key;
    std::string argument;
    std::vector<std::string> seen;  // keys
    std::size_t offset = 0;
  };

  void on_key(Frame& frame, const JsonEvent& event);
  void on_value(Frame& frame, const JsonEvent& event);
  void on_argument(Frame& frame, const JsonEvent& event);
  void finish_frame(const JsonEvent& event);

  const JsonText* json_;
  std::size_t needed_keys_;
  std::vector<Frame> frames_;  // the recipe and, below it, the input that is being read, …
  Recipe result_;
  bool started_ = false;
};

}  // namespace changeover
