// Designs at random, for properties of readers and writers.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover {

using namespace std::string_view_literals;

/// Names as people give them: letters, subscripts, numbers, words of other scripts.
inline std::vector<std::string> random_labels(std::uint64_t v, std::mt19937& random) {
  const std::vector<std::string> stems = {"a", "∞_s", "x'", "0_l", "Ünïcode",
                                          "-", "1.5", "B",  "a;b", "longer-than-a-slot",
                                          "=", "漢",  "[",  "\\x"};
  const bool only_numbers = random() % 4 == 0;
  std::vector<std::string> labels;
  for (std::uint64_t i = 0; i < v; ++i) {
    const std::string number = std::to_string(i * (random() % 3 == 0 ? 1000 : 1) + i);
    labels.push_back(only_numbers ? std::to_string((i * 7 + 3) % (v * 7))
                                  : stems[random() % stems.size()] + number);
  }
  if (random() % 8 == 0) {  // a permutation of 0 … v−1
    for (std::uint64_t i = 0; i < v; ++i) {
      labels[i] = std::to_string(i);
    }
    std::shuffle(labels.begin(), labels.end(), random);
  }
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  std::shuffle(labels.begin(), labels.end(), random);
  for (std::uint64_t i = 0; labels.size() < v; ++i) {
    labels.push_back("filler" + std::to_string(i));
  }
  return labels;
}

inline Recipe random_recipe(std::mt19937& random, int depth = 0) {
  Recipe recipe;
  recipe.construction = random() % 2 == 0 ? "cyclic-paper" : "a \"quoted\"\\ name\n∞";
  recipe.parameters = {.v = random() % 100,
                       .k = random() % 9,
                       .change = random() % 4,
                       .kind = random() % 2 == 0 ? Kind::linear : Kind::circular,
                       .strength = 2 + static_cast<std::uint32_t>(random() % 2)};
  recipe.arguments["c"] = static_cast<std::int64_t>(random());
  recipe.arguments["shift"] = -static_cast<std::int64_t>(random());
  for (auto i = depth < 3 ? random() % 3 : 0; i > 0; --i) {
    recipe.inputs.push_back(random_recipe(random, depth + 1));
  }
  if (random() % 3 == 0) {
    recipe.blocks = {{0, 1, 2}, {1, 4'000'000'000, 3}};
  }
  return recipe;
}

inline Design random_design(std::uint32_t seed) {
  std::mt19937 random(seed);
  Parameters p;
  p.v = 2 + random() % (random() % 5 == 0 ? 2000 : 20);
  p.k = 2 + random() % (std::min<std::uint64_t>(p.v, 9) - 1);
  p.change = 1 + random() % p.k;
  p.kind = random() % 2 == 0 ? Kind::linear : Kind::circular;
  p.strength = 2 + static_cast<std::uint32_t>(random() % (std::min<std::uint64_t>(p.k, 4) - 1));
  Design design(p);
  Block all(p.v);
  std::iota(all.begin(), all.end(), Element{0});
  for (std::uint64_t b = 1 + random() % 20; b > 0; --b) {
    std::shuffle(all.begin(), all.end(), random);
    design.append(std::span(all).first(p.k));
  }
  if (random() % 2 == 0) {
    design.set_labels(random_labels(p.v, random));
  }
  if (random() % 3 == 0) {
    design.recipe = random_recipe(random);
  }
  return design;
}

/// A file with some of its bytes changed, removed, doubled or cut off.
inline std::string mutated(std::string text, std::mt19937& random) {
  const std::string_view odd = "\0\n\r\t #,;\"'{}[]:0123456789aB*\\&\x7f\xff\xc3\xe2-+.eE"sv;
  for (auto changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
    const std::size_t at = random() % text.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 12, text.size() - at);
    switch (random() % 5) {
      case 0:
        text[at] = odd[random() % odd.size()];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      case 3:
        text.insert(at, 1, odd[random() % odd.size()]);
        break;
      default:
        text.resize(random() % 3 == 0 ? at : text.size());
    }
  }
  return text;
}

/// Such a file gives a design that is written and read back the same, or one line with a place. The
/// functions are read(text), of a file named f, and written(design).
template <typename Read, typename Written>
void read_mutated_file(std::uint32_t seed, Read&& read, Written&& written) {
  std::mt19937 random(seed);
  const std::string text = mutated(written(random_design(seed)), random);
  try {
    const Design design = read(text);
    RC_ASSERT(written(read(written(design))) == written(design));
  } catch (const BadInput& fault) {
    const std::string line = fault.what();
    RC_ASSERT(line.starts_with("f:"));
    RC_ASSERT(line.find('\n') == std::string::npos);
  }
}

}  // namespace changeover
