// The addresses of the server, a file a group of them.
#pragma once

#include <memory>

#include "serve/api/explorer.hpp"
#include "serve/http/router.hpp"
#include "serve/pages/pages.hpp"

namespace changeover::serve {

/// All addresses. What is given must outlive the router.
[[nodiscard]] std::shared_ptr<const Router> routes(Explorer& explorer, const Pages& pages);

void add_about(Router& router,
               Explorer& explorer);  ///< about, completeness, constructions, theorems, references
void add_cells(Router& router, Explorer& explorer);     ///< table, cell, bounds, explain
void add_atlas(Router& router, Explorer& explorer);     ///< atlas, groups
void add_designs(Router& router, Explorer& explorer);   ///< design, download, cite
void add_searches(Router& router, Explorer& explorer);  ///< search, events, what is kept
void add_verify(Router& router, Explorer& explorer);    ///< verify, repair
void add_pictures(Router& router, Explorer& explorer);  ///< draw, heatmap
void add_plans(Router& router, Explorer& explorer);     ///< plans and runs
void add_loads(Router& router, Explorer& explorer);     ///< load orders
void add_pages(Router& router, const Pages& pages);

/// A GET that is answered within the limits.
[[nodiscard]] Route question(Explorer& explorer, std::string path,
                             std::vector<std::string> parameters, Again again,
                             std::function<Response(const Request&)> answer);

/// The same for a POST with a body of that kind.
[[nodiscard]] Route posted(Explorer& explorer, std::string path,
                           std::vector<std::string> parameters, Body body,
                           std::function<Response(const Request&)> answer);

/// The same for what changes something, in that lane: refused with 403 if the server was started
/// with --no-write.
[[nodiscard]] Route changing(Explorer& explorer, std::string path,
                             std::vector<std::string> parameters, Body body, Lane lane,
                             std::function<Response(const Request&)> answer);

/// A constant lane.
[[nodiscard]] std::function<Lane(const Request&)> always(Lane lane);

}  // namespace changeover::serve
