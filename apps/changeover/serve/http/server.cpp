#include "serve/http/server.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdarg>
#include <cstddef>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "serve/http/exchange.hpp"
#include "serve/http/microhttpd.hpp"

namespace changeover::serve {
namespace {

constexpr std::size_t bytes_of_a_head = 32 << 10;
// What libmicrohttpd has for one request, and clears after each. Half of it is for reading; lines,
// parameters and cookies are kept in the rest, and where that is full there is no room for the head
// of an answer, so that nothing is answered.
constexpr std::size_t room_of_a_connection = 64 << 10;
constexpr std::size_t room_of_fields = 24 << 10;
constexpr std::size_t bytes_of_a_field = 64;
constexpr const char* too_many_fields = "the head of the request has too many lines or cookies";
// A request that is refused is read to its end if that is near, so that who sends it hears why.
constexpr std::size_t read_though_refused = 64 << 10;

struct Listener {
  std::shared_ptr<EventFeed> feed;
  MHD_Connection* connection;
};

}  // namespace

struct Server::State {
  struct Calls;

  explicit State(Settings given)
      : settings(std::move(given)),
        deadlines(settings.deadlines,
                  refused_as_text({408, "the request took too long to arrive"})),
        lanes(settings.lanes) {}

  Settings settings;
  Deadlines deadlines;
  std::atomic<bool> stopping = false;
  std::atomic<std::size_t> held = 0;
  std::atomic<std::size_t> untaken = 0;
  Heads heads;
  MHD_Daemon* daemon = nullptr;
  Lanes lanes;  // last: its threads end first

  void complain(const std::string& line) const {
    if (settings.complain) {
      settings.complain(line);
    }
  }

  // Answers what libmicrohttpd cannot answer, or would in its own words, and ends the connection.
  static void refuse_at_once(Exchange& exchange, const Refusal& refusal);
  // libmicrohttpd refuses something with this status.
  void refuse_instead(int status);
  [[nodiscard]] static std::optional<Refusal> head_defect(const Exchange& exchange);
  // Reads the head.
  void begin(Exchange& exchange, const char* method);
  void check(Exchange& exchange) const;
  void take(Exchange& exchange, const char* bytes, std::size_t count);
  // Answers at once, or says in which lane it will be answered.
  MHD_Result dispatch(Exchange& exchange);
  MHD_Result wait_in_lane(Exchange& exchange);
  [[nodiscard]] Response answer(const Exchange& exchange) const;
  void hold(Exchange& exchange);
  MHD_Result send(Exchange& exchange);
  MHD_Result handle(Exchange& exchange, const char* method, const char* upload,
                    std::size_t* upload_size);
};

// What libmicrohttpd calls. Nothing may be thrown through it.
struct Server::State::Calls {
  static void* target(void* cls, const char* uri, MHD_Connection* connection) {
    try {
      auto exchange = std::make_unique<Exchange>();
      exchange->connection = connection;
      exchange->socket = socket_of(connection);
      exchange->target = uri;
      auto* const state = static_cast<Server::State*>(cls);
      if (const auto defect = address_defect(exchange->target)) {
        refuse_at_once(*exchange, *defect);
      } else {
        state->deadlines.hear(exchange->socket);
        state->heads.add(*exchange);
      }
      return exchange.release();
    } catch (...) {
      return nullptr;
    }
  }

  static MHD_Result access(void* cls, MHD_Connection* /*connection*/, const char* url,
                           const char* method, const char* version, const char* upload,
                           std::size_t* upload_size, void** context) {
    auto* const state = static_cast<Server::State*>(cls);
    Exchange* const exchange = static_cast<Exchange*>(*context);
    if (exchange == nullptr || exchange->refused_at_once) {
      return MHD_NO;
    }
    try {
      if (!exchange->begun) {
        state->heads.remove(*exchange);
        exchange->request.path = url[0] == '/' ? url + 1 : url;
        exchange->head_bytes = std::string_view(method).size() + exchange->target.size() +
                               std::string_view(version).size() +
                               std::string_view("  \r\n\r\n").size();
      }
      return state->handle(*exchange, method, upload, upload_size);
    } catch (const std::exception& fault) {
      state->complain(fmt::format("a request was dropped: {}", fault.what()));
      return MHD_NO;
    } catch (...) {
      return MHD_NO;
    }
  }

  static void completed(void* cls, MHD_Connection* /*connection*/, void** context,
                        MHD_RequestTerminationCode /*why*/) {
    auto* const state = static_cast<Server::State*>(cls);
    const std::unique_ptr<Exchange> exchange(static_cast<Exchange*>(*context));
    *context = nullptr;
    if (exchange) {
      state->heads.remove(*exchange);
      state->held -= exchange->held;
      state->untaken -= exchange->untaken;
      state->deadlines.enter(exchange->socket, Stage::head);
    }
  }

  static void connection(void* cls, MHD_Connection* connection, void** /*context*/,
                         MHD_ConnectionNotificationCode what) {
    auto* const state = static_cast<Server::State*>(cls);
    const int socket = socket_of(connection);
    try {
      what == MHD_CONNECTION_NOTIFY_STARTED ? state->deadlines.open(socket)
                                            : state->deadlines.close(socket);
    } catch (...) {
      ::shutdown(socket, SHUT_RDWR);
    }
  }

  static int socket_of(MHD_Connection* connection) {
    return MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd;
  }

  static MHD_Result header(void* cls, MHD_ValueKind /*kind*/, const char* key, std::size_t key_size,
                           const char* value, std::size_t value_size) {
    auto& exchange = *static_cast<Exchange*>(cls);
    Request& request = exchange.request;
    // Both are where they were read, with a colon and blanks between them.
    const auto apart =
        reinterpret_cast<std::uintptr_t>(value) - reinterpret_cast<std::uintptr_t>(key);
    constexpr std::size_t usual = std::string_view(": ").size();
    exchange.head_bytes += value_size + std::string_view("\r\n").size() +
                           (apart > key_size && apart < bytes_of_a_head ? apart : key_size + usual);
    const std::string name = lower_case({key, key_size});
    exchange.blank_in_name = exchange.blank_in_name || name.find_first_of(" \t") != name.npos;
    std::string text(value, value_size);
    text.erase(text.find_last_not_of(" \t") + 1);
    if (!request.headers.emplace(name, std::move(text)).second) {
      request.repeated.push_back(name);
    }
    return MHD_YES;
  }

  static MHD_Result parameter(void* cls, MHD_ValueKind /*kind*/, const char* key,
                              std::size_t key_size, const char* value, std::size_t value_size) {
    auto& request = *static_cast<Request*>(cls);
    request.parameters.emplace_back(
        std::string(key, key_size),
        value == nullptr ? std::string() : std::string(value, value_size));
    return MHD_YES;
  }

  static ssize_t events(void* cls, std::uint64_t /*position*/, char* room, std::size_t size) {
    const auto* const listener = static_cast<Listener*>(cls);
    std::size_t count = 0;
    const auto read = listener->feed->read(
        {room, size}, count, [listener] { MHD_suspend_connection(listener->connection); });
    return read == EventFeed::Read::ended ? MHD_CONTENT_READER_END_OF_STREAM
                                          : static_cast<ssize_t>(count);
  }

  static void events_end(void* cls) {
    const std::unique_ptr<Listener> listener(static_cast<Listener*>(cls));
    listener->feed->on_more({});
  }

  static void body_end(void* cls) { delete static_cast<std::shared_ptr<const std::string>*>(cls); }

  __attribute__((format(printf, 2, 0))) static void complain(void* cls, const char* format,
                                                             va_list arguments) {
    auto* const state = static_cast<Server::State*>(cls);
    // Said before it makes its own answer, which is not JSON; some versions even send two heads.
    if (std::string_view(format).starts_with(
            "Error processing request (HTTP response code is %u")) {
      va_list copy;
      va_copy(copy, arguments);
      const unsigned status = va_arg(copy, unsigned);
      va_end(copy);
      try {
        state->refuse_instead(static_cast<int>(status));
      } catch (...) {
        // Then it is refused in the library's words.
      }
    }
    std::string line(512, '\0');
    const int length = std::vsnprintf(line.data(), line.size(), format, arguments);
    line.resize(std::min(line.size() - 1, static_cast<std::size_t>(std::max(length, 0))));
    line.erase(line.find_last_not_of("\r\n") + 1);
    if (state->settings.log) {
      state->settings.log(printable(line));
    }
  }
};

void Server::State::refuse_at_once(Exchange& exchange, const Refusal& refusal) {
  exchange.refused_at_once = true;
  const std::string text = refused_as_text(refusal);
  static_cast<void>(::send(exchange.socket, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
  // A socket that is closed with bytes unread is reset, and who sent them may not hear why.
  std::array<char, 4096> unread{};
  for (std::size_t read = 0; read < read_though_refused; read += unread.size()) {
    if (::recv(exchange.socket, unread.data(), unread.size(), MSG_DONTWAIT) <= 0) {
      break;
    }
  }
  // libmicrohttpd reads the end from it, and closes it.
  ::shutdown(exchange.socket, SHUT_RDWR);
}

void Server::State::refuse_instead(int status) {
  Exchange* const exchange = heads.complete();
  if (exchange == nullptr) {
    return;
  }
  heads.remove(*exchange);
  const char* const length =
      MHD_lookup_connection_value(exchange->connection, MHD_HEADER_KIND, "Content-Length");
  const bool no_length =
      length != nullptr && (*length == '\0' || length[std::strspn(length, "0123456789")] != '\0');
  if (status == 431) {
    refuse_at_once(*exchange, {431, too_many_fields});
  } else if (status == 413) {
    refuse_at_once(*exchange, {413, "the header Content-Length is too large"});
  } else {
    refuse_at_once(*exchange, {400, no_length ? "the header Content-Length is not a number of bytes"
                                              : "the head of the request is malformed"});
  }
}

std::optional<Refusal> Server::State::head_defect(const Exchange& exchange) {
  const MHD_ConnectionInfo* const head =
      MHD_get_connection_info(exchange.connection, MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE);
  if (head != nullptr && head->header_size > bytes_of_a_head) {
    return Refusal{431,
                   fmt::format("the head of the request has more than {} bytes", bytes_of_a_head)};
  }
  // libmicrohttpd cuts at a zero byte: the guards would judge another head than was sent.
  if (head != nullptr && head->header_size > exchange.head_bytes) {
    return Refusal{400, "the head of the request has zero bytes, or blanks in its first line"};
  }
  if (exchange.blank_in_name) {
    return Refusal{400, "there is a blank in the name of a header"};
  }
  constexpr auto all =
      static_cast<MHD_ValueKind>(MHD_HEADER_KIND | MHD_COOKIE_KIND | MHD_GET_ARGUMENT_KIND);
  const int fields = MHD_get_connection_values(exchange.connection, all, nullptr, nullptr);
  // Cookies are copied.
  if (bytes_of_a_field * static_cast<std::size_t>(fields) +
          exchange.request.header("cookie").size() >
      room_of_fields) {
    return Refusal{431, too_many_fields};
  }
  return std::nullopt;
}

void Server::State::begin(Exchange& exchange, const char* method) {
  exchange.begun = true;
  Request& request = exchange.request;
  request.method = method;
  MHD_get_connection_values_n(exchange.connection, MHD_HEADER_KIND, &State::Calls::header,
                              &exchange);
  MHD_get_connection_values_n(exchange.connection, MHD_GET_ARGUMENT_KIND, &State::Calls::parameter,
                              &request);
  if (const auto defect = head_defect(exchange)) {
    refuse_at_once(exchange, *defect);
    return;
  }
  try {
    check(exchange);
  } catch (const Refusal& refusal) {
    exchange.response = refused(refusal);
    constexpr int length_required = 411;
    if (refusal.status == length_required ||
        std::ranges::find(request.repeated, "content-length") != request.repeated.end()) {
      // Where the next request begins cannot be known.
      refuse_at_once(exchange, refusal);
      return;
    }
    if (refusal.status == 405) {
      exchange.response->headers.emplace_back("Allow", settings.router->allowed(request.path));
    }
  }
  deadlines.enter(exchange.socket, Stage::body);
}

void Server::State::check(Exchange& exchange) const {
  const Request& request = exchange.request;
  exchange.expected = request.headers.contains("transfer-encoding") ? read_though_refused + 1
                                                                    : declared_length(request);
  if (stopping) {
    throw Refusal{503, "the server is stopping; start it again"};
  }
  if (exchange.target.find("%00") != std::string::npos) {
    throw Refusal{400, "there is a zero byte in the address; remove it"};
  }
  settings.guard->check(request, Action::asks);
  exchange.route = &settings.router->route_of(request);
  settings.guard->check(request, exchange.route->action);
}

void Server::State::take(Exchange& exchange, const char* bytes, std::size_t count) {
  if (exchange.response) {
    return;
  }
  exchange.held += count;
  const std::size_t held_by_all = held += count;
  if (held_by_all > settings.most_bytes) {
    exchange.response = refused({503, "too much is being sent to the server at once; try again"});
    exchange.request.body = {};
    return;
  }
  exchange.request.body.append(bytes, count);
}

Response Server::State::answer(const Exchange& exchange) const {
  try {
    if (stopping) {
      throw Refusal{503, "the server is stopping; start it again"};
    }
    refuse_form(*exchange.route, exchange.request);
    return exchange.route->answer(exchange.request);
  } catch (const Refusal& refusal) {
    return refused(refusal);
  } catch (const std::bad_alloc&) {
    return refused({503, "the server has no memory left for this; try again later"});
  } catch (const std::exception& fault) {
    complain(fmt::format("{} {}: {}", exchange.request.method, printable(exchange.request.path),
                         fault.what()));
    return refused({500, "the server made a mistake, which its log names"});
  }
}

MHD_Result Server::State::dispatch(Exchange& exchange) {
  deadlines.enter(exchange.socket, Stage::answer);
  Lane lane = Lane::quick;
  try {
    lane = exchange.route->lane(exchange.request);
  } catch (const Refusal& refusal) {
    exchange.response = refused(refusal);
    return send(exchange);
  }
  if (lane == Lane::here) {
    exchange.response = answer(exchange);
    return send(exchange);
  }
  // Suspended now, the library would look for more from the client when it resumes, and drop the
  // request of one that sends no more. It asks again at once, and does not read meanwhile.
  exchange.lane = lane;
  return MHD_YES;
}

MHD_Result Server::State::wait_in_lane(Exchange& exchange) {
  // Who sends no more may still wait for an answer, and cannot be told from who has gone: short
  // answers are made for both.
  exchange.request.left = [socket = exchange.socket, since = std::chrono::steady_clock::now()] {
    constexpr std::chrono::seconds short_answer{1};
    char byte = 0;
    return std::chrono::steady_clock::now() - since > short_answer &&
           ::recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  };
  MHD_suspend_connection(exchange.connection);
  lanes.add(*exchange.lane, [this, &exchange] {
    exchange.response = answer(exchange);
    MHD_resume_connection(exchange.connection);
  });
  return MHD_YES;
}

// Counts the bytes of the answer that nothing else holds, as what is kept to be given again; of its
// two forms the one that is not sent goes.
void Server::State::hold(Exchange& exchange) {
  Response& response = *exchange.response;
  (response.gzipped && takes_gzip(exchange.request) ? response.body : response.gzipped).reset();
  const auto& bytes = response.body ? response.body : response.gzipped;
  if (!bytes || bytes.use_count() > 1) {
    return;
  }
  exchange.untaken = bytes->size();
  const std::size_t untaken_by_all = untaken += exchange.untaken;
  if (untaken_by_all > settings.most_untaken) {
    untaken -= std::exchange(exchange.untaken, 0);
    response = refused({503, "too many answers wait to be taken; try again"});
  }
}

MHD_Result Server::State::send(Exchange& exchange) {
  hold(exchange);
  Response& response = *exchange.response;
  const Request& request = exchange.request;
  const bool unchanged = response.status == MHD_HTTP_OK && !response.etag.empty() &&
                         (request.method == "GET" || request.method == "HEAD") &&
                         request.header("if-none-match") == response.etag;
  const bool packed = response.gzipped && takes_gzip(request);
  using Made = std::unique_ptr<MHD_Response, void (*)(MHD_Response*)>;
  Made made(nullptr, MHD_destroy_response);
  if (response.events && request.method != "HEAD") {
    auto listener = std::make_unique<Listener>(Listener{response.events, exchange.connection});
    constexpr std::size_t room = 4096;
    made.reset(MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, room, &State::Calls::events,
                                                 listener.get(), &State::Calls::events_end));
    if (made) {
      static_cast<void>(listener.release());
      // Deadlines has none for listeners; this one is for those who take nothing any more.
      constexpr unsigned seconds = 30;
      MHD_set_connection_option(exchange.connection, MHD_CONNECTION_OPTION_TIMEOUT, seconds);
      response.events->on_more(
          [connection = exchange.connection] { MHD_resume_connection(connection); });
    }
  } else {
    auto body = std::make_unique<std::shared_ptr<const std::string>>(packed ? response.gzipped
                                                                            : response.body);
    if (unchanged || !*body) {
      *body = std::make_shared<const std::string>();
    }
    const std::string& bytes = **body;
    // The bytes are only read.
    made.reset(MHD_create_response_from_buffer_with_free_callback_cls(
        bytes.size(), const_cast<char*>(bytes.data()), &State::Calls::body_end, body.get()));
    if (made) {
      static_cast<void>(body.release());
    }
  }
  if (!made) {
    return MHD_NO;
  }
  const auto add = [&](const std::string& name, const std::string& value) {
    MHD_add_response_header(made.get(), name.c_str(), value.c_str());
  };
  // Only a page of another site can have opened this window. The header has browsers begin another
  // process, which takes them longer than all else up to the first paint.
  const std::string_view from = request.header("sec-fetch-site");
  const bool opened_by_itself = from == "none" || from == "same-origin";
  const auto says = [&response](std::string_view name) {
    return std::ranges::any_of(response.headers,
                               [&](const auto& header) { return header.first == name; });
  };
  for (const auto& [name, value] : security_headers()) {
    if ((name != "Cross-Origin-Opener-Policy" || !opened_by_itself) && !says(name)) {
      add(name, value);
    }
  }
  for (const auto& [name, value] : response.headers) {
    add(name, value);
  }
  if (!says("Cache-Control")) {
    add("Cache-Control", response.etag.empty() ? "no-store" : "no-cache");
  }
  add("Vary", "Accept-Encoding, Sec-Fetch-Site");
  if (!response.etag.empty()) {
    add("ETag", response.etag);
  }
  if (!unchanged) {
    add("Content-Type", response.type);
    if (packed) {
      add("Content-Encoding", "gzip");
    }
  }
  const int status = unchanged ? MHD_HTTP_NOT_MODIFIED : response.status;
  if (settings.log) {
    // The token must not be in a log.
    const std::string target = exchange.target.find("token=") == std::string::npos
                                   ? exchange.target
                                   : exchange.target.substr(0, exchange.target.find('?'));
    settings.log(fmt::format("{} {} {}", request.method, printable(target), status));
  }
  deadlines.enter(exchange.socket, response.events ? Stage::listening : Stage::reading);
  return MHD_queue_response(exchange.connection, static_cast<unsigned>(status), made.get());
}

MHD_Result Server::State::handle(Exchange& exchange, const char* method, const char* upload,
                                 std::size_t* upload_size) {
  if (!exchange.begun) {
    begin(exchange, method);
    if (exchange.refused_at_once) {
      return MHD_NO;
    }
    if (exchange.response && exchange.expected > read_though_refused) {
      exchange.response->headers.emplace_back("Connection", "close");
      return send(exchange);
    }
    return MHD_YES;
  }
  if (*upload_size > 0) {
    take(exchange, upload, *upload_size);
    *upload_size = 0;
    return MHD_YES;
  }
  if (exchange.response) {
    return send(exchange);
  }
  return exchange.lane ? wait_in_lane(exchange) : dispatch(exchange);
}

Server::Server(Settings settings) : state_(std::make_unique<State>(std::move(settings))) {
  const Settings& given = state_->settings;
  constexpr unsigned threads = 2;
  state_->daemon = MHD_start_daemon(
      MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME | MHD_USE_ERROR_LOG, 0, nullptr,
      nullptr, &State::Calls::access, state_.get(), MHD_OPTION_EXTERNAL_LOGGER,
      &State::Calls::complain, state_.get(), MHD_OPTION_LISTEN_SOCKET, given.listening.socket,
      MHD_OPTION_THREAD_POOL_SIZE, threads, MHD_OPTION_CONNECTION_LIMIT, given.connections,
      MHD_OPTION_PER_IP_CONNECTION_LIMIT, given.connections_of_one,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, room_of_a_connection, MHD_OPTION_URI_LOG_CALLBACK,
      &State::Calls::target, state_.get(), MHD_OPTION_NOTIFY_COMPLETED, &State::Calls::completed,
      state_.get(), MHD_OPTION_NOTIFY_CONNECTION, &State::Calls::connection, state_.get(),
      MHD_OPTION_END);
  if (state_->daemon == nullptr) {
    ::close(given.listening.socket);
    throw MissingResource(
        "the server cannot start: the system has no threads or files left; "
        "raise the limits (ulimit -u, ulimit -n)");
  }
}

Server::~Server() {
  if (state_->daemon != nullptr) {
    static_cast<void>(stop(std::chrono::hours(1)));
  }
}

bool Server::stop(std::chrono::duration<double> patience) {
  state_->stopping = true;
  // New clients get status 503 until the daemon ends. MHD_quiesce_daemon would turn them away, but
  // with epoll it and a thread of the daemon may both take the listening socket out of the set, and
  // the library then ends the process.
  if (!state_->lanes.stop(patience)) {
    return false;
  }
  // MHD_stop_daemon drops what it has not sent yet; who does not read must not keep the server.
  constexpr std::chrono::seconds for_readers{1};
  state_->deadlines.wait_for_answers(for_readers);
  MHD_stop_daemon(state_->daemon);
  state_->daemon = nullptr;
  return true;
}

std::size_t Server::open_connections() const { return state_->deadlines.open_connections(); }

}  // namespace changeover::serve
