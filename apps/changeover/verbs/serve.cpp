// changeover serve [FILE…]: the explorer, pages for a browser.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "answer/answer.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/io/input.hpp"
#include "changeover/run/control.hpp"
#include "cli/status_line.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "request/catalog_request.hpp"
#include "request/parameters.hpp"
#include "request/run_request.hpp"
#include "serve/explorer_server.hpp"
#include "serve/export/addresses.hpp"
#include "serve/export/site.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ServeRequest {
  std::vector<std::string> files;
  std::optional<std::uint64_t> port;
  std::string host = "127.0.0.1";
  std::optional<std::uint64_t> threads;
  bool open = false;
  bool no_write = false;
  bool verbose = false;
  std::string assets;
  std::string site;
  std::string k, v;
  std::string address, sources;
  std::optional<std::uint64_t> change;
  CatalogRequest catalog;
};

// Signals that end the server are waited for, by the threads that it starts too.
class SignalsWaitedFor {
 public:
  SignalsWaitedFor() {
    ::sigemptyset(&set_);
    for (const int signal : {SIGINT, SIGTERM}) {
      ::sigaddset(&set_, signal);
      // One that is ignored never comes, and a shell's background jobs ignore SIGINT.
      std::signal(signal, SIG_DFL);
    }
    struct sigaction action {};
    ::sigaction(SIGHUP, nullptr, &action);
    if (action.sa_handler != SIG_IGN) {  // as it is under nohup
      ::sigaddset(&set_, SIGHUP);
    }
    ::pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  ~SignalsWaitedFor() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWaitedFor(const SignalsWaitedFor&) = delete;
  SignalsWaitedFor& operator=(const SignalsWaitedFor&) = delete;

  void wait() const {
    int signal = 0;
    while (::sigwait(&set_, &signal) != 0) {
    }
  }

  [[nodiscard]] const sigset_t& before() const { return before_; }

 private:
  sigset_t set_{};
  sigset_t before_{};
};

// Shows an address in the user's browser, without a shell and without waiting.
void open_browser(const std::string& address, const sigset_t& signals) {
  const pid_t child = ::fork();
  if (child == 0) {
    // A child of this child leaves no zombie.
    if (::fork() != 0) {
      ::_exit(0);
    }
    ::pthread_sigmask(SIG_SETMASK, &signals, nullptr);
    const char* const program = "xdg-open";
    ::execlp(program, program, address.c_str(), static_cast<char*>(nullptr));
    ::_exit(1);
  }
  if (child > 0) {
    ::waitpid(child, nullptr, 0);
  }
}

std::vector<serve::GivenFile> read_files(const std::vector<std::string>& paths) {
  std::vector<serve::GivenFile> files;
  files.reserve(paths.size());
  for (const std::string& path : paths) {
    files.push_back({printable(path), read_design(path)});
  }
  return files;
}

Answer write_site(const ServeRequest& request) {
  serve::SiteRange range;
  range.k = request.k.empty() ? range.k : range_of("--k", request.k, 2);
  range.v = request.v.empty() ? range.v : range_of("--v", request.v, range.k.from);
  if (request.change) {
    range.changes = {*request.change};
  }
  const serve::SiteLinks links{
      .address = request.address.empty() ? "" : serve::site_address(request.address),
      .sources = request.sources.empty() ? "" : serve::sources_address(request.sources)};
  const serve::Pages pages(request.assets);
  const Catalog& catalog = request.catalog.open();
  const auto running = std::make_shared<Running>(RunRequest(), OutputRequest());
  try {
    const serve::SiteSummary site =
        serve::export_site(request.site, range, links, pages, catalog, running->control());
    running->finish();
    if (site.kept) {
      status_line().say(fmt::format(
          "changeover: the site is there; what could not be removed of the earlier one is in {}",
          printable(*site.kept)));
    }
    return text_answer(
        fmt::format("{}: {} with {:.1f} MB, {} and {}\n", printable(request.site),
                    count_of(site.files, "file"), static_cast<double>(site.bytes) / 1e6,
                    count_of(site.cells, "cell"), count_of(site.designs, "design")),
        {});
  } catch (const Stopped&) {
    running->finish();
    status_line().say("changeover: stopped before the site was whole; nothing was changed");
    return {.code = exit_code::limit_reached};
  }
}

Answer run(const ServeRequest& request) {
  if (!request.site.empty()) {
    return write_site(request);
  }
  serve::ExplorerSettings settings;
  settings.host = request.host;
  settings.port = static_cast<std::uint16_t>(request.port.value_or(0));
  settings.threads = static_cast<unsigned>(request.threads.value_or(0));
  settings.may_write = !request.no_write;
  settings.prepare = true;
  settings.assets = request.assets;
  settings.files = read_files(request.files);
  settings.complain = [](const std::string& line) {
    status_line().say("changeover: " + printable(line));
  };
  if (request.verbose) {
    settings.log = [](const std::string& line) { status_line().say(line); };
  }
  const SignalsWaitedFor signals;  // first: opening a catalog takes a moment
  Catalog& catalog = request.catalog.open();
  auto server = std::make_unique<serve::ExplorerServer>(std::move(settings), catalog);
  if (!server->is_local()) {
    status_line().say(fmt::format(
        "changeover: --host {}: others on the network can reach this server, and anyone with the "
        "token of the address can start searches and add to your catalog",
        printable(request.host)));
  }
  if (request.open) {
    open_browser(server->address(), signals.before());
  }
  write_file("-", [&](OutputFile& out) { out.write(server->address() + "\n"); });
  signals.wait();
  constexpr std::chrono::milliseconds patience{800};
  if (!server->stop(patience)) {
    // Some answer does not listen; nothing of it is worth waiting for, and files appear whole or
    // not at all.
    remove_unfinished_outputs();
    ::_exit(exit_code::done);
  }
  return {};
}

}  // namespace

void add_serve(Program& program) {
  auto [verb, request] = program.add<ServeRequest>(
      "serve", "serve the explorer, the pages for a browser: catalog, designs, searches", run);
  verb.positional("FILE", request.files,
                  "designs to look at: text, JSON, CSV, GAP, Sage, XML, sets {A,B}", false);
  verb.option("--port", request.port, "N", "listen on this port (default 0: one that is free)");
  verb.option("--host", request.host, "NAME",
              "listen on this address of the machine (default 127.0.0.1)");
  verb.option("--threads", request.threads, "N",
              "threads that answer (default: as many as the machine has, 2 to 16)");
  verb.flag("--open", request.open, "show it in the browser");
  verb.flag("--no-write", request.no_write, "disable searches and additions to the catalog");
  verb.flag("--verbose", request.verbose, "print a line per request on stderr");
  verb.option("--assets", request.assets, "DIR",
              "pages from this folder instead of those in the program, for work on them");
  verb.option("--export", request.site, "DIR",
              "write the pages with what is known as files for any web server, and end");
  verb.option("--address", request.address, "URL",
              "where these files will be, for a sitemap and a feed of what is new");
  verb.option("--sources", request.sources, "URL",
              "download address of the program, for a link on pages that need it");
  verb.option("--k", request.k, "A..B", "block sizes of these files (default 3..40)");
  verb.option("--v", request.v, "C..D", "their numbers of elements (default 4..160)");
  verb.option("-m,--change", request.change, "M", "their change number (default 1, 2 and 3)");
  request.catalog.add_to(verb);
  verb.only_with({"--k", "--v", "--change", "--address", "--sources"}, {"--export"});
  verb.never_with({"--port", "--host", "--threads", "--open", "--no-write", "--verbose"},
                  {"--export"});
  verb.require([&asked = request] {
    constexpr std::uint64_t most_ports = 65'535;
    constexpr std::uint64_t most_threads = 256;
    if (!asked.site.empty() && !asked.files.empty()) {
      throw UsageError{"FILE has no meaning with --export; leave it out"};
    }
    if (asked.port.value_or(0) > most_ports) {
      throw UsageError{fmt::format("--port {}: give 0 to {}", *asked.port, most_ports)};
    }
    if (asked.threads && (*asked.threads < 1 || *asked.threads > most_threads)) {
      throw UsageError{fmt::format("--threads {}: give 1 to {}", *asked.threads, most_threads)};
    }
  });
  verb.examples({"changeover serve --open", "changeover serve mine.txt --port 8080",
                 "changeover serve --export public --address https://example.org/designs/",
                 "changeover serve --export public --k 3..6 --v 4..30 --change 2",
                 "Ctrl-C ends it"});
  verb.outcomes({{exit_code::done, "ended by Ctrl-C or SIGTERM, or the files are written"},
                 {exit_code::limit_reached,
                  "--export was stopped before the site was whole; nothing was changed"}});
}

}  // namespace changeover::cli
