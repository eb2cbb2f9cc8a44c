// The verbs, one file each.
#pragma once

#include "cli/cli.hpp"

namespace changeover::cli {

void add_design(Program& program);
void add_verify(Program& program);
void add_bounds(Program& program);
void add_explain(Program& program);
void add_search(Program& program);
void add_classify(Program& program);
void add_same(Program& program);
void add_minima(Program& program);
void add_table(Program& program);
void add_plan(Program& program);
void add_expand(Program& program);
void add_draw(Program& program);
void add_dossier(Program& program);
void add_factorize(Program& program);
void add_constructions(Program& program);
void add_paper(Program& program);
void add_loadorder(Program& program);
void add_serve(Program& program);
void add_catalog_show(Program& program);
void add_catalog_list(Program& program);
void add_catalog_history(Program& program);
void add_catalog_cite(Program& program);
void add_catalog_completeness(Program& program);
void add_catalog_add(Program& program);
void add_catalog_retract(Program& program);
void add_catalog_alias(Program& program);
void add_catalog_export(Program& program);
void add_catalog_import(Program& program);
void add_catalog_verify(Program& program);
void add_catalog_diff(Program& program);
void add_catalog_improve(Program& program);
void add_catalog_submit(Program& program);
void add_completion(Program& program);
void add_manual(Program& program);
void add_describe(Program& program);

}  // namespace changeover::cli
