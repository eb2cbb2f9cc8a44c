// The explorer as a whole: pages, answers and searches, served on an address of this machine.
//
//     ExplorerServer server({.port = 0}, standard_catalog());
//     server.address();                          // "http://127.0.0.1:40123/?token=…"
//     …
//     server.stop(900ms);
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "serve/api/explorer.hpp"
#include "serve/http/server.hpp"

namespace changeover::serve {

struct ExplorerSettings {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: any that is free
  unsigned threads = 0;    ///< that answer; 0: as many as the machine has, 2 to 16
  bool may_write = true;   ///< searches, and what they find into the user's catalog
  bool prepare = false;  ///< the tables of the catalog's map are made before anything asks for them
  std::string assets = {};  ///< a folder of pages instead of those in the program
  Limits limits = {};       ///< memory 0: an eighth of the machine's, 256 MB to 2 GB
  Deadlines::Settings deadlines = {};
  std::vector<GivenFile> files = {};
  std::function<void(const std::string&)> log = {};
  std::function<void(const std::string&)> complain = {};
};

class ExplorerServer {
 public:
  /// Serves from now on. @throws MissingResource
  ExplorerServer(ExplorerSettings settings, Catalog& catalog);
  ~ExplorerServer();
  ExplorerServer(const ExplorerServer&) = delete;
  ExplorerServer& operator=(const ExplorerServer&) = delete;

  /// With the token.
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] const std::string& token() const;
  /// Only programs of this machine can reach it.
  [[nodiscard]] bool is_local() const;

  /// How many connections are open, and how many of them listen to events.
  [[nodiscard]] std::size_t connections() const;
  [[nodiscard]] std::size_t listeners() const;

  /// Stops searches and answers under way, and closes all connections. Whether all ended within
  /// that time; if not, only the end of the process ends them.
  [[nodiscard]] bool stop(std::chrono::duration<double> patience);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::serve
