// One kind of input from outside, and what must be true whatever it is.
//
//     const Target parts("parts", [](const std::string& bytes) { … must(b == a, "it changed"); });
//
// Each NAME_fuzz.cpp has one, called NAME. With libFuzzer it is a separate program
// (libfuzzer.cpp); tests/fuzz holds all of them in one program that feeds them fuzz/corpus/NAME.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace changeover::fuzz {

class Target {
 public:
  using Take = std::function<void(const std::string& bytes)>;

  /// Every target of this program is in all().
  Target(std::string name, Take take);

  [[nodiscard]] const std::string& name() const { return name_; }
  void operator()(const std::string& bytes) const { take_(bytes); }

  [[nodiscard]] static const std::vector<Target>& all();

 private:
  std::string name_;
  Take take_;
};

/// What is thrown by must(): no fault of the library derives from the same class, so no other code
/// catches
/// it.
struct Broken {
  std::string promise;
};

/// @throws Broken
void must(bool kept, const std::string& promise);

}  // namespace changeover::fuzz
