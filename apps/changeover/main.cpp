#include "cli/team.hpp"
#include "cli/terminal.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

int main(int argc, char** argv) {
  using namespace changeover::cli;
  prepare_process();
  const Watched watched;
  Program program;
  for (AddVerb* const add :
       {add_design, add_verify, add_bounds, add_explain, add_search, add_classify, add_same,
        add_table, add_minima, add_plan, add_expand, add_draw, add_dossier, add_factorize,
        add_constructions, add_paper, add_loadorder, add_serve}) {
    add(program);
  }
  program.add_group("catalog", "browse and extend the catalog of known designs");
  for (AddVerb* const add :
       {add_catalog_show, add_catalog_list, add_catalog_history, add_catalog_cite,
        add_catalog_completeness, add_catalog_add, add_catalog_retract, add_catalog_alias,
        add_catalog_export, add_catalog_import, add_catalog_verify, add_catalog_diff,
        add_catalog_improve, add_catalog_submit, add_completion, add_manual, add_describe}) {
    add(program);
  }
  const int code = program.run(argc, argv);
  Team::leave(code);
  return code;
}
