#include "support/target.hpp"

#include <utility>

namespace changeover::fuzz {
namespace {

std::vector<Target>& known() {
  static std::vector<Target> targets;
  return targets;
}

}  // namespace

Target::Target(std::string name, Take take) : name_(std::move(name)), take_(std::move(take)) {
  known().push_back(*this);
}

const std::vector<Target>& Target::all() { return known(); }

void must(bool kept, const std::string& promise) {
  if (!kept) {
    throw Broken{promise};
  }
}

}  // namespace changeover::fuzz
