#include "cli/team.hpp"
#include "cli/terminal.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

int main(int argc, char** argv) {
  using namespace changeover::cli;
  prepare_process();
  const Watched watched;
  Program program;
  add_design(program);
  add_verify(program);
  add_bounds(program);
  add_explain(program);
  add_search(program);
  add_classify(program);
  add_same(program);
  add_table(program);
  add_minima(program);
  add_plan(program);
  add_expand(program);
  add_draw(program);
  add_dossier(program);
  add_factorize(program);
  add_constructions(program);
  add_paper(program);
  add_loadorder(program);
  add_serve(program);
  program.add_group("catalog", "browse and extend the catalog of known designs");
  add_catalog_show(program);
  add_catalog_list(program);
  add_catalog_history(program);
  add_catalog_cite(program);
  add_catalog_completeness(program);
  add_catalog_add(program);
  add_catalog_retract(program);
  add_catalog_alias(program);
  add_catalog_export(program);
  add_catalog_import(program);
  add_catalog_verify(program);
  add_catalog_diff(program);
  add_catalog_improve(program);
  add_catalog_submit(program);
  add_completion(program);
  add_manual(program);
  add_describe(program);
  const int code = program.run(argc, argv);
  Team::leave(code);
  return code;
}
