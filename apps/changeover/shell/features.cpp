#include "shell/features.hpp"

#include <expat.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <xlsxwriter.h>
#include <zip.h>
#include <zlib.h>

#include <CLI/Version.hpp>
#include <bliss/defs.hh>
#include <cadical.hpp>
#include <string_view>

#include "answer/converter.hpp"
#include "catalog/store/database.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "construct/shipped_catalog.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "serve/http/microhttpd.hpp"
#include "serve/pages/pages.hpp"
#include "shell/build_information.hpp"

namespace changeover::cli {
namespace {

// CaDiCaL as a library says what it calls itself, and no number that could be looked up.
std::string cadical_version() {
  const std::string own = CaDiCaL::Solver::version();
  const std::string package(build_information().cadical);
  return package.empty() ? own : package + " (calls itself " + own + ")";
}

// The version of a library that is loaded late. If it is missing, the report must still list the
// others.
template <typename Version>
std::string late_version(const Version& version) {
  try {
    return version();
  } catch (const MissingResource&) {
    return "cannot be loaded";
  }
}

std::vector<std::pair<std::string, std::string>> libraries() {
  return {{"bliss", bliss::version},
          {"CaDiCaL", cadical_version()},
          {"CLI11", CLI11_VERSION},
          {"expat", std::string(XML_ExpatVersion()).substr(std::string_view("expat_").size())},
          {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                              FMT_VERSION % 100)},
          {"libmicrohttpd", late_version(serve::MHD_get_version)},
          {"libxlsxwriter", late_version(lxw_version)},
          {"libzip", late_version(zip_libzip_version)},
          {"nlohmann_json", std::string(build_information().nlohmann_json)},
          {"SQLite", sqlite3_libversion()},
          {"zlib", zlibVersion()}};
}

}  // namespace

Features features() {
  const BuildInformation& build = build_information();
  Features all;
  all.compiler = build.compiler;
  all.build_type = build.build_type;
  all.sanitizers = build.sanitizers;
#ifdef CHANGEOVER_WITH_MPI
  all.mpi = true;
#endif
  all.libraries = libraries();
  const Database catalog = Database::of_image(shipped_catalog());
  all.designs = catalog.integer("SELECT count(*) FROM design");
  all.catalog_shape = catalog.integer("PRAGMA user_version");
  all.explorer = !serve::embedded_pages().empty();
  all.rsvg_convert = converter_path();
  return all;
}

std::string features_text(const Features& features) {
  std::string text = fmt::format("changeover {}\n", version);
  const auto line = [&](std::string_view what, const std::string& words) {
    text += fmt::format("{:<13}{}\n", what, words);
  };
  line("built", fmt::format("{}, {}, {}, {} MPI", features.compiler, features.build_type,
                            features.sanitizers.empty() ? "no sanitizers"
                                                        : "sanitizers " + features.sanitizers,
                            features.mpi ? "with" : "without"));
  std::string_view what = "libraries";
  for (const auto& [name, number] : features.libraries) {
    line(what, fmt::format("{} {}", name, number));
    what = "";
  }
  line("catalog", fmt::format("{}, tables of version {}", count_of(features.designs, "design"),
                              features.catalog_shape));
  line("explorer", features.explorer ? "its pages are in the program"
                                     : "without pages: the server answers with data only");
  line("PDF and PNG", features.rsvg_convert.empty()
                          ? "rsvg-convert is not found: install the Debian package librsvg2-bin"
                          : "by " + features.rsvg_convert);
  return text;
}

std::string features_json(const Features& features) {
  JsonWriter json;
  json.begin_object().key("version").value(version).key("compiler").value(features.compiler);
  json.key("build_type").value(features.build_type).key("sanitizers");
  json.value_or_null(features.sanitizers);
  json.key("mpi").value(features.mpi).key("libraries").begin_object();
  for (const auto& [name, number] : features.libraries) {
    json.key(name).value(number);
  }
  json.end_object().key("catalog").begin_object().key("designs").value(features.designs);
  json.key("shape").value(features.catalog_shape).end_object();
  json.key("explorer").value(features.explorer).key("rsvg_convert");
  return json.value_or_null(features.rsvg_convert).end_object().take() + "\n";
}

}  // namespace changeover::cli
