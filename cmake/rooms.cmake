# The rooms of the library, lowest first, and which rooms each one may include. This is the only
# place that says so: the libraries are linked from it, and tests/architecture holds the includes
# to it. A room's public headers are include/changeover/<room>/, all the rest of it is src/<room>/.

set(CHANGEOVER_ROOMS core run verify bounds io catalog construct draw paper proof isomorphism search
  curator loadorder plan)

# Rooms that are built with the others but are no part of the installed library.
set(CHANGEOVER_ROOMS_OF_THE_HOUSE paper)

set(CHANGEOVER_KNOWS_core)
set(CHANGEOVER_KNOWS_run core)
set(CHANGEOVER_KNOWS_verify core run)
set(CHANGEOVER_KNOWS_bounds core run)
set(CHANGEOVER_KNOWS_io core run verify bounds)
set(CHANGEOVER_KNOWS_catalog core run verify bounds io)
set(CHANGEOVER_KNOWS_construct core run verify bounds io catalog)
set(CHANGEOVER_KNOWS_draw core run verify bounds io catalog construct)
set(CHANGEOVER_KNOWS_paper core run verify bounds io catalog construct draw)
set(CHANGEOVER_KNOWS_proof core)
set(CHANGEOVER_KNOWS_isomorphism core run)
set(CHANGEOVER_KNOWS_search core run verify bounds io catalog construct proof isomorphism)
set(CHANGEOVER_KNOWS_curator core run verify bounds io catalog construct isomorphism search)
set(CHANGEOVER_KNOWS_plan core run verify bounds io catalog construct search)
set(CHANGEOVER_KNOWS_loadorder core run verify bounds io catalog construct search)

# Rooms whose speed does not matter at run time (cmake/cold.cmake), or which of their sources;
# WARM: as fast with fewer passes of the compiler.
set(CHANGEOVER_COLD_catalog COLD UNLESS "catalog/entry/")
set(CHANGEOVER_COLD_construct WARM)
set(CHANGEOVER_COLD_curator COLD)
set(CHANGEOVER_COLD_io COLD ONLY "io/(workbook|request)/")
set(CHANGEOVER_COLD_paper COLD)
set(CHANGEOVER_COLD_plan COLD ONLY
  "plan/(job|sheet|request)/|plan/model/(read_|pict_rules|model_(text|names))|plan/diagnosis/diagnosis_formats")

# Third-party libraries, always used in sources only: no public header includes one.
foreach(room IN LISTS CHANGEOVER_ROOMS)
  set(CHANGEOVER_LIBRARIES_${room} fmt::fmt)
endforeach()
list(APPEND CHANGEOVER_LIBRARIES_io nlohmann_json::nlohmann_json EXPAT::EXPAT LibZip::LibZip
  XlsxWriter::XlsxWriter)
list(APPEND CHANGEOVER_LIBRARIES_catalog SQLite::SQLite3)
list(APPEND CHANGEOVER_LIBRARIES_isomorphism Bliss::Bliss)
list(APPEND CHANGEOVER_LIBRARIES_run Threads::Threads)
list(APPEND CHANGEOVER_LIBRARIES_search CaDiCaL::CaDiCaL Threads::Threads)
list(APPEND CHANGEOVER_LIBRARIES_loadorder Threads::Threads)
list(APPEND CHANGEOVER_LIBRARIES_plan Threads::Threads)
