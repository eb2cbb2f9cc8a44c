// What this program was built with, and what it can do here: `changeover --version`.
//
//     changeover 1.0.0
//     built        GNU 12.2.0, Release, with MPI
//     …
//
// The first line stays as it is for ever: scripts read it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace changeover::cli {

struct Features {
  std::string compiler;    ///< "GNU 12.2.0"
  std::string build_type;  ///< "Release"
  std::string sanitizers;  ///< as for -fsanitize; empty: none
  bool mpi = false;        ///< mpirun may start several processes of one search
  std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version that runs
  std::uint64_t designs = 0;                                   ///< that come with the program
  std::uint64_t catalog_shape = 0;                             ///< version of the database's tables
  bool explorer = false;                                       ///< its pages are in the program
  std::string rsvg_convert;  ///< path of what writes PDF and PNG; empty: not found
};

/// Looks at the program and at PATH; the user's catalog is not opened. @throws std::bad_alloc
[[nodiscard]] Features features();

[[nodiscard]] std::string features_text(const Features& features);

/// {"version","compiler","build_type","sanitizers"|null,"mpi","libraries":{name: version},
/// "catalog":{"designs","shape"},"explorer","rsvg_convert"|null}
[[nodiscard]] std::string features_json(const Features& features);

}  // namespace changeover::cli
