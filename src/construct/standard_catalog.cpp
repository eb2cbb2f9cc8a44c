#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "changeover/core/error.hpp"
#include "construct/shipped_catalog.hpp"

namespace changeover {
namespace {

std::optional<std::string>& chosen() {
  static std::optional<std::string> path;
  return path;
}

std::atomic<bool> catalog_was_asked = false;

std::optional<std::string> variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

}  // namespace

void choose_catalog(std::string path) {
  if (catalog_was_asked) {
    throw BadOption("choose_catalog() must be called before the catalog is first used");
  }
  chosen() = std::move(path);
}

std::string standard_catalog_file() {
  if (chosen()) {
    return *chosen();
  }
  if (auto path = variable("CHANGEOVER_CATALOG")) {
    return *std::move(path);
  }
  std::filesystem::path folder(variable("XDG_DATA_HOME").value_or(""));
  if (!folder.is_absolute()) {  // As the rules for such folders have it.
    const std::string home = variable("HOME").value_or("");
    if (home.empty()) {
      return "";
    }
    folder = std::filesystem::path(home) / ".local" / "share";
  }
  return folder / "changeover" / "catalog.db";
}

bool is_stored_cell(const Parameters& p) {
  return p.strength == 2 && p.change >= 1 && p.change <= 3 && p.k >= 3 && p.k <= 40 && p.v <= 160;
}

std::string standard_catalog_problem() {
  return catalog_was_asked ? standard_catalog().problem() : "";
}

std::string standard_catalog_remark() {
  return catalog_was_asked ? standard_catalog().remark() : "";
}

Catalog& standard_catalog() {
  catalog_was_asked = true;
  // A process that was forked may not close SQLite's files: at the time of the fork another thread
  // may have held its lock, which is then never released.
  struct Owner {
    std::unique_ptr<Catalog> catalog;
    pid_t process = ::getpid();
    ~Owner() {
      if (process != ::getpid()) {
        static_cast<void>(catalog.release());
      }
    }
  };
  static Owner owner{std::make_unique<Catalog>(
      Catalog::Files{.shipped = shipped_catalog(), .user = standard_catalog_file()})};
  return *owner.catalog;
}

}  // namespace changeover
