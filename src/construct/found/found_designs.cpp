#include "construct/found/found_designs.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "changeover/core/error.hpp"
#include "core/lines.hpp"

namespace changeover {
namespace {

/// One file, line by line.
class Reader {
 public:
  explicit Reader(const FoundFile& file) : file_(file) {}

  FoundDesign read() {
    while (lines_.next()) {
      take(lines_.line());
    }
    Recipe& recipe = design_.recipe;
    if (recipe.parameters.v == 0 || recipe.provenance.empty() || recipe.blocks.empty()) {
      fail("parameters, provenance or blocks are missing");
    }
    recipe.construction = developed_ ? "developed" : "literal";
    design_.b = recipe.blocks.size() *
                (developed_ ? static_cast<std::uint64_t>(recipe.arguments.at("n")) : 1);
    return std::move(design_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw InternalError(
        fmt::format("found design {}, line {}: {}", file_.name, lines_.number(), what));
  }

  static std::optional<std::string_view> after(std::string_view line, std::string_view prefix) {
    return line.starts_with(prefix) ? std::optional(line.substr(prefix.size())) : std::nullopt;
  }

  void take(std::string_view line) {
    Recipe& recipe = design_.recipe;
    if (const auto header = after(line, "# changeover design ")) {
      const auto words = pairs(*header);
      const auto kind = kind_from_string(word(words, "kind"));
      if (!kind) {
        fail("the kind is neither linear nor circular");
      }
      recipe.parameters = {.v = number(word(words, "v")),
                           .k = number(word(words, "k")),
                           .change = number(word(words, "change")),
                           .kind = *kind};
      if (words.contains("strength")) {
        recipe.parameters.strength = static_cast<std::uint32_t>(number(word(words, "strength")));
      }
    } else if (const auto provenance = after(line, "# provenance: ")) {
      recipe.provenance = *provenance;
    } else if (const auto development = after(line, "# developed: ")) {
      developed_ = true;
      for (const auto& [name, value] : pairs(*development)) {
        recipe.arguments[std::string(name)] = static_cast<std::int64_t>(number(value));
      }
      if (!recipe.arguments.contains("n")) {
        fail("the length n of the cycles is missing");
      }
    } else if (!line.empty() && !line.starts_with('#')) {
      recipe.blocks.push_back(block(line));
    }
  }

  [[nodiscard]] std::map<std::string_view, std::string_view> pairs(std::string_view text) const {
    std::map<std::string_view, std::string_view> result;
    for (const std::string_view item : words(text)) {
      const std::size_t equals = item.find('=');
      if (equals == std::string_view::npos) {
        fail("a word without '='");
      }
      result.emplace(item.substr(0, equals), item.substr(equals + 1));
    }
    return result;
  }

  [[nodiscard]] std::string_view word(const std::map<std::string_view, std::string_view>& words,
                                      std::string_view name) const {
    const auto found = words.find(name);
    if (found == words.end()) {
      fail(fmt::format("{} is missing", name));
    }
    return found->second;
  }

  [[nodiscard]] Block block(std::string_view line) const {
    Block elements;
    for (const std::string_view item : words(line)) {
      elements.push_back(static_cast<Element>(number(item)));
    }
    return elements;
  }

  static std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> result;
    while (!text.empty()) {
      const std::size_t end = text.find(' ');
      if (end != 0) {
        result.push_back(text.substr(0, end));
      }
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return result;
  }

  [[nodiscard]] std::uint64_t number(std::string_view text) const {
    std::uint32_t value = 0;
    const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || rest != text.data() + text.size()) {
      fail(fmt::format("'{}' is no number", text));
    }
    return value;
  }

  FoundFile file_;
  Lines lines_{file_.text};
  FoundDesign design_;
  bool developed_ = false;
};

}  // namespace

std::vector<FoundDesign> read_found_designs(std::span<const FoundFile> files) {
  std::vector<FoundDesign> designs;
  for (const FoundFile& file : files) {
    designs.push_back(Reader(file).read());
  }
  return designs;
}

}  // namespace changeover
