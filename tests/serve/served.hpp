// A server in this process, for all tests of a suite, or for one.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "client.hpp"
#include "run_program.hpp"
#include "serve/explorer_server.hpp"

namespace changeover::test {

/// A separate catalog in a folder that goes away, and pages with two files.
class OwnServer {
 public:
  explicit OwnServer(serve::ExplorerSettings settings = {})
      : catalog({.shipped = {}, .user = folder.file("mine.db")}) {
    std::filesystem::create_directory(folder.path() / "pages");
    std::filesystem::create_directory(folder.path() / "pages" / "assets");
    spit(folder.file("pages/index.html"), "<!doctype html><title>Explorer</title>");
    spit(folder.file("pages/assets/app.js"), "export const x = 1;\n");
    spit(folder.file("pages/secret"), "of no type that pages have");
    spit(folder.file("outside.txt"), "not a page");
    std::filesystem::create_symlink(folder.file("outside.txt"), folder.file("pages/link.txt"));
    settings.assets = folder.file("pages");
    server = std::make_unique<serve::ExplorerServer>(std::move(settings), catalog);
  }

  [[nodiscard]] std::uint16_t port() const { return server->port(); }
  [[nodiscard]] Headers token() const {
    return {{"X-Changeover-Token", server->token()}, {"Content-Type", "application/json"}};
  }

  TemporaryFolder folder;
  Catalog catalog;
  std::unique_ptr<serve::ExplorerServer> server;
};

/// Tests of one server with its own catalog.
class OfOneServer : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { own_ = new OwnServer; }
  static void TearDownTestSuite() {
    delete own_;
    own_ = nullptr;
  }
  static std::uint16_t port() { return own_->port(); }

  inline static OwnServer* own_ = nullptr;
};

/// The parsed body.
inline nlohmann::json json_of(const Reply& reply) {
  return nlohmann::json::parse(reply.body, nullptr, false);
}

/// The message of a refusal.
inline std::string message_of(const Reply& reply) {
  const nlohmann::json json = json_of(reply);
  return json.is_object() && json.contains("error") ? json["error"]["message"].get<std::string>()
                                                    : "no message: " + reply.body;
}

/// Posts JSON with the token.
inline Reply act(const OwnServer& own, const std::string& target, const std::string& body = "") {
  return ask(own.port(), "POST", target, own.token(), body);
}

/// The answer to that, which is 200.
inline nlohmann::json asked(const OwnServer& own, const std::string& target,
                            const nlohmann::json& body) {
  const Reply reply = act(own, target, body.dump());
  EXPECT_EQ(reply.status, 200) << target << "\n" << reply.body.substr(0, 500);
  return json_of(reply);
}

/// Tests of answers: the catalog that comes with the program.
class Served : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { server_ = new serve::ExplorerServer({}, standard_catalog()); }
  static void TearDownTestSuite() {
    delete server_;
    server_ = nullptr;
  }
  static Reply get(const std::string& target, const Headers& headers = {}) {
    return test::get(server_->port(), target, headers);
  }
  static Reply post(const std::string& target, const std::string& body,
                    const std::string& type = "application/octet-stream") {
    return ask(server_->port(), "POST", target, {{"Content-Type", type}}, body);
  }
  static nlohmann::json json(const std::string& target) {
    const Reply reply = get(target);
    EXPECT_EQ(reply.status, 200) << target << "\n" << reply.body.substr(0, 500);
    return json_of(reply);
  }

  inline static serve::ExplorerServer* server_ = nullptr;
};

}  // namespace changeover::test
