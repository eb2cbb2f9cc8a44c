#include "serve/explorer_server.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "answer/known/known_table.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "serve/api/atlas.hpp"
#include "serve/api/routes.hpp"
#include "serve/jobs/search_jobs.hpp"
#include "serve/plans/plan_jobs.hpp"
#include "serve/plans/run_store.hpp"

namespace changeover::serve {
namespace {

std::uint64_t an_eighth_of_the_memory() {
  constexpr std::uint64_t least = 256'000'000;
  constexpr std::uint64_t most = 2'000'000'000;
  constexpr std::uint64_t part = 8;
  const auto pages = ::sysconf(_SC_PHYS_PAGES);
  const auto page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? std::clamp(static_cast<std::uint64_t>(pages) *
                                                static_cast<std::uint64_t>(page) / part,
                                            least, most)
                               : least;
}

// Beside the user's designs.
std::string folder_of_runs(const std::string& user_path) {
  return user_path.empty() ? std::string()
                           : (std::filesystem::absolute(user_path).parent_path() / "runs").string();
}

// The names that the server goes by.
std::vector<std::string> names_of(const std::string& host, std::uint16_t port) {
  std::vector<std::string> names{with_port("127.0.0.1", port), with_port("localhost", port),
                                 with_port("::1", port), with_port(lower_case(host), port)};
  constexpr std::uint16_t usual_port = 80;
  if (port == usual_port) {
    names.insert(names.end(), {"127.0.0.1", "localhost", "[::1]", lower_case(host)});
  }
  return names;
}

// What the map of the catalog shows comes with the program, but for the user's own designs. Then it
// is made while nothing is asked, so that the first who asks does not wait for it. Those of the
// change number that the pages begin with come first and are as urgent as an answer; the others
// give way to all that answers.
void prepare_tables(Explorer& explorer) {
  RunControl::Settings settings;
  settings.memory_bytes = explorer.limits.memory_bytes;
  settings.interrupted = &explorer.stopping;
  RunControl control(std::move(settings));
  const RunScope scope(control);
  try {
    for (const std::uint64_t change : {2U, 1U, 3U}) {
      for (const Kind kind : {Kind::circular, Kind::linear}) {
        cli::TableRange range = atlas_range(change, 2);
        range.kind = kind;
        static_cast<void>(explorer.tables.of(range, explorer.generation(), Haste::sometime));
      }
      constexpr int gives_way = 10;
      static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), gives_way));
    }
  } catch (const std::exception&) {
    // A request for it says what is wrong.
  }
}

}  // namespace

struct ExplorerServer::State {
  std::string host;
  Listening listening;
  Pages pages;
  Explorer explorer;
  std::shared_ptr<const Guard> guard = {};
  std::unique_ptr<Server> server = {};
  std::jthread preparing = {};
  bool stopped = false;

  State(const std::string& address, std::uint16_t port, const std::string& assets, Catalog& catalog)
      : host(address), listening(), pages(assets), explorer(catalog) {
    listening = listen_on(host, port);
  }
};

ExplorerServer::ExplorerServer(ExplorerSettings settings, Catalog& catalog)
    : state_(std::make_unique<State>(settings.host, settings.port, settings.assets, catalog)) {
  Explorer& explorer = state_->explorer;
  explorer.files = std::move(settings.files);
  explorer.limits = settings.limits;
  if (explorer.limits.memory_bytes == 0) {
    explorer.limits.memory_bytes = an_eighth_of_the_memory();
  }
  explorer.may_write = settings.may_write;
  explorer.jobs = std::make_shared<SearchJobs>(
      catalog, explorer.events,
      SearchJobs::Settings{.at_once = explorer.limits.searches,
                           .memory_bytes = explorer.limits.memory_bytes});
  explorer.plans = std::make_shared<PlanJobs>(
      explorer.events, PlanJobs::Settings{.at_once = explorer.limits.plans,
                                          .memory_bytes = explorer.limits.memory_bytes,
                                          .answer_bytes = explorer.limits.plan_bytes,
                                          .remembered_bytes = explorer.limits.remembered_bytes});
  explorer.runs = std::make_shared<RunStore>(folder_of_runs(catalog.user_path()), explorer.events);
  state_->guard =
      std::make_shared<const Guard>(names_of(state_->host, state_->listening.port), make_token());
  constexpr unsigned fewest = 2;
  constexpr unsigned most = 16;
  const unsigned threads = settings.threads != 0
                               ? settings.threads
                               : std::clamp(std::thread::hardware_concurrency(), fewest, most);
  Server::Settings served;
  served.listening = state_->listening;
  served.router = routes(explorer, state_->pages);
  served.guard = state_->guard;
  served.lanes = {.quick = threads, .slow = std::max(2U, threads / 2)};
  served.deadlines = settings.deadlines;
  served.most_untaken = explorer.limits.untaken_bytes;
  served.log = std::move(settings.log);
  served.complain = std::move(settings.complain);
  state_->server = std::make_unique<Server>(std::move(served));
  if (settings.prepare && !explorer.generation().empty()) {
    state_->preparing = std::jthread([&explorer] { prepare_tables(explorer); });
  }
}

ExplorerServer::~ExplorerServer() {
  state_->explorer.stopping = true;
  if (!state_->stopped) {
    static_cast<void>(stop(std::chrono::hours(1)));
  }
}

std::string ExplorerServer::address() const {
  return "http://" + with_port(state_->host, port()) + "/?token=" + token();
}

std::uint16_t ExplorerServer::port() const { return state_->listening.port; }
const std::string& ExplorerServer::token() const { return state_->guard->token(); }
bool ExplorerServer::is_local() const { return state_->listening.loopback; }
std::size_t ExplorerServer::connections() const { return state_->server->open_connections(); }
std::size_t ExplorerServer::listeners() const { return state_->explorer.events.listeners(); }

bool ExplorerServer::stop(std::chrono::duration<double> patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  Explorer& explorer = state_->explorer;
  explorer.stopping = true;
  explorer.events.close();
  const auto left = [&] {
    return std::max<std::chrono::duration<double>>(end - std::chrono::steady_clock::now(),
                                                   std::chrono::milliseconds(0));
  };
  static_cast<void>(explorer.plans->stop_all(std::chrono::seconds(0)));  // All stop together.
  if (!explorer.jobs->stop_all(left()) || !explorer.plans->stop_all(left()) ||
      !state_->server->stop(left())) {
    return false;
  }
  state_->stopped = true;
  return true;
}

}  // namespace changeover::serve
