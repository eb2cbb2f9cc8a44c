#include "serve/api/routes.hpp"

#include <utility>

namespace changeover::serve {

std::function<Lane(const Request&)> always(Lane lane) {
  return [lane](const Request&) { return lane; };
}

Route question(Explorer& explorer, std::string path, std::vector<std::string> parameters,
               Again again, std::function<Response(const Request&)> answer) {
  Route route;
  route.path = std::move(path);
  route.parameters = std::move(parameters);
  route.answer = [&explorer, again, answer = std::move(answer)](const Request& request) {
    return answered(explorer, request, again, [&] { return answer(request); });
  };
  return route;
}

Route posted(Explorer& explorer, std::string path, std::vector<std::string> parameters, Body body,
             std::function<Response(const Request&)> answer) {
  Route route = question(explorer, std::move(path), std::move(parameters), Again::made_anew,
                         std::move(answer));
  route.method = "POST";
  route.body = body;
  route.most_bytes = body == Body::any    ? explorer.limits.body_bytes
                     : body == Body::json ? explorer.limits.json_bytes
                                          : 0;
  route.lane = always(Lane::slow);
  return route;
}

Route changing(Explorer& explorer, std::string path, std::vector<std::string> parameters, Body body,
               Lane lane, std::function<Response(const Request&)> answer) {
  Route route = posted(explorer, std::move(path), std::move(parameters), body,
                       [&explorer, answer = std::move(answer)](const Request& request) {
                         if (!explorer.may_write) {
                           throw Refusal{403,
                                         "the server was started with --no-write: it searches "
                                         "nothing and keeps nothing"};
                         }
                         return answer(request);
                       });
  route.action = Action::changes;
  route.lane = always(lane);
  return route;
}

void add_pages(Router& router, const Pages& pages) {
  Route route;
  route.parameters = {"token", "cell", "design"};  // The page reads what it is to show.
  route.lane = always(Lane::here);
  route.answer = [&pages](const Request& request) {
    auto page = pages.find(request.path);
    if (!page && request.path.empty()) {
      throw Refusal{404, "this program was built without pages; give --assets DIR"};
    }
    if (!page) {
      throw Refusal{404, "there is nothing at this address; the pages begin at /"};
    }
    return *std::move(page);
  };
  router.add(route);  // "", which says so if there are no pages
  router.add_elsewhere(std::move(route),
                       [&pages](const std::string& path) { return pages.find(path).has_value(); });
}

std::shared_ptr<const Router> routes(Explorer& explorer, const Pages& pages) {
  auto router = std::make_shared<Router>();
  add_pages(*router, pages);
  add_about(*router, explorer);
  add_cells(*router, explorer);
  add_atlas(*router, explorer);
  add_designs(*router, explorer);
  add_searches(*router, explorer);
  add_verify(*router, explorer);
  add_pictures(*router, explorer);
  add_plans(*router, explorer);
  add_loads(*router, explorer);
  return router;
}

}  // namespace changeover::serve
