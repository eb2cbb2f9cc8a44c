// Small models of all sorts, as texts.
#pragma once

#include <string>
#include <vector>

#include "run/random.hpp"
#include "some_models.hpp"

namespace changeover::test {

namespace random_model {

struct Shape {
  std::vector<bool> numeric;          // by parameter
  std::vector<std::uint32_t> values;  // how many
};

inline std::string value(const Shape& shape, std::size_t p, std::uint32_t i) {
  return shape.numeric[p] ? std::to_string(static_cast<int>(i) * 3 - 1)
                          : std::string(1, static_cast<char>('a' + i));
}

inline std::string constant(const Shape& shape, std::size_t p, Random& random) {
  const std::string word = value(shape, p, random.below(shape.values[p]));
  return shape.numeric[p] ? word : "\"" + word + "\"";
}

inline std::string name(std::size_t p) { return "[P" + std::to_string(p) + "]"; }

inline std::string condition(const Shape& shape, Random& random, unsigned depth) {
  const auto parameters = static_cast<std::uint32_t>(shape.values.size());
  const std::size_t p = random.below(parameters);
  const auto any_of = [&](const std::vector<std::string>& words) {
    return words[random.below(static_cast<std::uint32_t>(words.size()))];
  };
  const std::vector<std::string> relations{" = ", " <> ", " < ", " <= ", " > ", " >= "};
  switch (random.below(depth > 2 ? 5 : 9)) {
    case 0:
    case 1:
      return name(p) + any_of(relations) + constant(shape, p, random);
    case 2:
      return name(p) + any_of({" IN {", " NOT IN {"}) + constant(shape, p, random) + ", " +
             constant(shape, p, random) + "}";
    case 3: {
      const std::size_t q = random.below(parameters);
      return p != q && shape.numeric[p] == shape.numeric[q]
                 ? name(p) + any_of(relations) + name(q)
                 : name(p) + " = " + constant(shape, p, random);
    }
    case 4:
      return shape.numeric[p]
                 ? any_of({"IsNegative(P0)", "IsPositive()", "NOT IsNegative()"})
                 : name(p) + any_of({" LIKE \"a*\"", " NOT LIKE \"?\"", " LIKE \"b\""});
    case 5:
      return "NOT " + condition(shape, random, depth + 1);
    case 6:
      return "(" + condition(shape, random, depth + 1) + ")";
    default:
      return "(" + condition(shape, random, depth + 1) + any_of({" AND ", " OR "}) +
             condition(shape, random, depth + 1) + ")";
  }
}

inline std::string rule(const Shape& shape, Random& random) {
  const std::string first = condition(shape, random, 0);
  switch (random.below(3)) {
    case 0:
      return first + " OR " + condition(shape, random, 1) + ";\n";
    case 1:
      return "IF " + first + " THEN " + condition(shape, random, 1) + ";\n";
    default:
      return "IF " + first + " THEN " + condition(shape, random, 1) + " ELSE " +
             condition(shape, random, 1) + ";\n";
  }
}

}  // namespace random_model

/// A model of at most so many parameters with at most so many values each that has a test. Always
/// the same for a seed.
inline std::string random_model_text(std::uint64_t seed, std::uint32_t parameters,
                                     std::uint32_t values, bool negatives = true) {
  for (std::uint64_t turn = 0;; ++turn) {
    Random random(seed, turn);
    random_model::Shape shape;
    std::string text;
    const std::uint32_t count = 2 + random.below(parameters - 1);
    for (std::uint32_t p = 0; p < count; ++p) {
      shape.numeric.push_back(random.one_in_two());
      shape.values.push_back(1 + random.below(values));
      text += "P" + std::to_string(p) + ": ";
      for (std::uint32_t i = 0; i < shape.values[p]; ++i) {
        const bool negative = negatives && i > 0 && random.below(5) == 0;
        text += std::string(i > 0 ? ", " : "") + (negative ? "~" : "") +
                random_model::value(shape, p, i);
      }
      text += "\n";
    }
    for (std::uint32_t i = random.below(4); i > 0; --i) {
      text += random_model::rule(shape, random);
    }
    if (!all_tests(model_of(text)).empty()) {
      return text;
    }
  }
}

}  // namespace changeover::test
