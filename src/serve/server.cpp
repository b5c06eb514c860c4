// SPDX-License-Identifier: BSD-2-Clause
#include "serve/server.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "diagnostics/problem.h"
#include "serve/page_connection.h"
#include "serve/site.h"

namespace soarbox::serve {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = asio::ip::tcp;

constexpr auto kHeaderTime = std::chrono::seconds(15), kIdleTime = std::chrono::seconds(60);
constexpr std::uint32_t kMostHeaderBytes = 16u << 10;

/// Number of connections, in total and per address, and the bytes that the server stores for them: received bodies, and
/// replies to be sent.
class Counts {
 public:
  explicit Counts(Limits limits) : limits_(limits) {}

  bool HasRoomFor(const std::string& address, std::size_t bytes) const {
    const auto found = bytes_of_.find(address);
    return bytes_ + bytes <= limits_.bytes_in_flight &&
           (found == bytes_of_.end() ? 0 : found->second) + bytes <= limits_.bytes_in_flight_per_address;
  }
  void AddBytes(const std::string& address, std::size_t bytes) {
    bytes_ += bytes;
    if (bytes > 0) bytes_of_[address] += bytes;
  }
  void RemoveBytes(const std::string& address, std::size_t bytes) {
    bytes_ -= bytes;
    const auto found = bytes_of_.find(address);
    if (found != bytes_of_.end() && (found->second -= bytes) == 0) bytes_of_.erase(found);
  }

  bool IsFull(const std::string& address) const {
    const auto found = of_.find(address);
    return all_ >= limits_.connections || (found != of_.end() && found->second >= limits_.connections_per_address);
  }
  void Add(const std::string& address) {
    ++all_;
    ++of_[address];
  }
  void Remove(const std::string& address) {
    --all_;
    if (--of_[address] == 0) of_.erase(address);
  }

 private:
  Limits limits_;
  std::size_t all_ = 0;
  std::map<std::string, std::size_t> of_;
  std::size_t bytes_ = 0;
  std::map<std::string, std::size_t> bytes_of_;
};

std::string Text(beast::string_view view) {
  return {view.data(), view.size()};
}

/// A connection: handles requests until it becomes a WebSocket or is closed.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Tcp::socket socket, Site& site, std::shared_ptr<Counts> counts, std::string address)
      : stream_(std::move(socket)), site_(site), counts_(std::move(counts)), address_(std::move(address)) {
    counts_->Add(address_);
  }
  ~HttpConnection() {
    Hold(0);
    if (!is_handed_on_) counts_->Remove(address_);
  }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  void Read() {
    parser_.emplace();
    parser_->header_limit(kMostHeaderBytes);
    parser_->body_limit(site_.settings().limits.upload_bytes);
    stream_.expires_after(is_first_ ? kHeaderTime : kIdleTime);
    is_first_ = false;
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                              if (error) return self->TellBroken(error);
                              self->ReadBody();
                            });
  }
  /// Sends the reason why this connection is not served, and closes it.
  void Refuse(int status, const std::string& text) {
    WebResponse response;
    response.status = status;
    response.body = "{\"error\":\"" + text + "\",\"hint\":\"\"}";
    Write(std::move(response), 11, false, false);
  }

 private:
  using Request = http::request<http::string_body>;

  void ReadBody() {
    // A chunked body does not specify its length.
    const auto length = parser_->content_length();
    const std::size_t most = site_.settings().limits.upload_bytes;
    const std::size_t bytes = parser_->chunked() ? most : length ? static_cast<std::size_t>(*length) : 0;
    if (bytes > most) return TellBroken(http::error::body_limit);
    if (bytes > 0 && !counts_->HasRoomFor(address_, bytes))
      return Refuse(503, "the server already transfers as much data as it allows; try again in a minute");
    Hold(bytes);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->TellBroken(error);
      self->Take(self->parser_->release());
    });
  }

  /// Sets the number of bytes that the server stores for this connection.
  void Hold(std::size_t bytes) {
    counts_->RemoveBytes(address_, std::exchange(held_bytes_, bytes));
    counts_->AddBytes(address_, bytes);
  }

  void TellBroken(beast::error_code error) {
    if (error == http::error::body_limit) return Refuse(413, "this is larger than the server accepts");
    if (error == http::error::header_limit) return Refuse(431, "this request has too many headers");
    // A client that has closed or is silent gets no reply; any other error is a malformed request.
    if (error == http::error::end_of_stream || error == beast::error::timeout ||
        error.category() == asio::error::get_system_category() || error == http::error::partial_message)
      return;
    Refuse(400, "this is not a request that the server can read");
  }

  WebRequest Read(const Request& request) const {
    WebRequest web;
    web.method = Text(request.method_string());
    web.target = Text(request.target());
    web.host = Text(request[http::field::host]);
    web.origin = Text(request[http::field::origin]);
    web.authorization = Text(request[http::field::authorization]);
    web.protocols = Text(request[http::field::sec_websocket_protocol]);
    web.tag = Text(request[http::field::if_none_match]);
    web.cookies = Text(request[http::field::cookie]);
    web.takes_gzip = request[http::field::accept_encoding].find("gzip") != beast::string_view::npos;
    web.body = request.body();
    web.address = address_;
    const std::vector<std::string>& proxies = site_.settings().proxies;
    if (std::ranges::find(proxies, address_) != proxies.end()) {
      // The last address is the one that our own proxy has seen.
      const std::string forwarded = Text(request["X-Forwarded-For"]);
      const std::size_t last = forwarded.find_last_of(", ");
      if (!forwarded.empty()) web.address = last == std::string::npos ? forwarded : forwarded.substr(last + 1);
    }
    return web;
  }

  void Take(Request request) {
    const WebRequest web = Read(request);
    const unsigned version = request.version();
    stream_.expires_never();  // The server's own work has no time limit.
    if (beast::websocket::is_upgrade(request)) {
      const auto kept = std::make_shared<Request>(std::move(request));
      return site_.Admit(web, [self = shared_from_this(), kept, version](Site::Admission admission) {
        if (admission.session == nullptr) return self->Write(std::move(admission.refusal), version, false, false);
        self->is_handed_on_ = true;
        self->Hold(0);
        ServePage(self->stream_.release_socket(), std::move(*kept), self->site_, admission,
                  [counts = self->counts_, address = self->address_] { counts->Remove(address); });
      });
    }
    site_.Answer(web, [self = shared_from_this(), version, keeps_on = request.keep_alive(),
                       is_head = request.method() == http::verb::head](WebResponse response) {
      self->Write(std::move(response), version, keeps_on, is_head);
    });
  }

  template <typename Body>
  static void SetHead(http::response<Body>& response, const WebResponse& given, unsigned version) {
    response.version(version);
    response.result(static_cast<unsigned>(given.status));
    response.set(http::field::content_type, given.type);
    // Allows only scripts of this server, and frames only on the sites of --embed. Other sites do not get the address
    // of the page, which contains the place's secret.
    response.set("Content-Security-Policy",
                 "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
                 "connect-src 'self' ws: wss:; frame-ancestors " +
                     (given.framed_by.empty() ? "'none'" : given.framed_by) +
                     "; base-uri 'none'; form-action 'none'; object-src 'none'");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Cross-Origin-Opener-Policy", "same-origin");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    for (const auto& [name, value] : given.headers) response.set(name, value);
  }

  void Write(WebResponse given, unsigned version, bool keeps_on, bool is_head) {
    Hold(0);
    if (!given.file.empty()) return WriteFile(given, version, keeps_on);
    if (!counts_->HasRoomFor(address_, given.body.size())) {
      given = {};
      given.status = 503;
      given.body = R"({"error":"you receive as much as this server allows","hint":"wait until it has come"})";
    }
    Hold(given.body.size());
    const auto response = std::make_shared<http::response<http::string_body>>();
    SetHead(*response, given, version);
    response->body() = std::move(given.body);
    response->prepare_payload();
    if (is_head) response->body().clear();
    Send(response, keeps_on);
  }

  /// Reads the file piece by piece while sending it.
  void WriteFile(const WebResponse& given, unsigned version, bool keeps_on) {
    const auto response = std::make_shared<http::response<http::file_body>>();
    SetHead(*response, given, version);
    beast::error_code error;
    response->body().open(given.file.c_str(), beast::file_mode::scan, error);
    if (error) return Refuse(404, "this recording cannot be read");
    response->prepare_payload();
    Send(response, keeps_on);
  }

  template <typename Response>
  void Send(const std::shared_ptr<Response>& response, bool keeps_on) {
    response->keep_alive(keeps_on);
    stream_.expires_after(kIdleTime);
    http::async_write(stream_, *response,
                      [self = shared_from_this(), response, keeps_on](beast::error_code error, std::size_t) {
                        self->Hold(0);
                        if (!error && keeps_on) return self->Read();
                        beast::error_code ignored;
                        self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                      });
  }

  beast::tcp_stream stream_;
  Site& site_;
  std::shared_ptr<Counts> counts_;
  std::string address_;
  std::size_t held_bytes_ = 0;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  bool is_first_ = true, is_handed_on_ = false;
};

class Server {
 public:
  Server(asio::io_context& io, Tcp::acceptor acceptor, Site& site)
      : io_(io),
        acceptor_(std::move(acceptor)),
        site_(site),
        counts_(std::make_shared<Counts>(site.settings().limits)),
        timer_(io) {}

  void Accept() {
    acceptor_.async_accept([this](beast::error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) Take(std::move(socket));
      // Without free descriptors, no connection can be accepted until later.
      if (error) return AcceptLater();
      Accept();
    });
  }

  void CleanUpAgain() {
    timer_.expires_after(std::chrono::seconds(5));
    timer_.async_wait([this](beast::error_code error) {
      if (error) return;
      site_.CleanUp();
      // While a page is being reloaded, no page is connected for a moment.
      constexpr int kMostAway = 3;
      times_left_ = site_.WasLeft() ? times_left_ + 1 : 0;
      if (site_.settings().ends_when_alone && times_left_ == kMostAway && on_left_) on_left_();
      CleanUpAgain();
    });
  }

  void SetOnLeft(std::function<void()> on_left) { on_left_ = std::move(on_left); }

  void Close() {
    beast::error_code ignored;
    acceptor_.close(ignored);
    timer_.cancel();
  }

 private:
  void Take(Tcp::socket socket) {
    beast::error_code error;
    const Tcp::endpoint from = socket.remote_endpoint(error);
    if (error) return;
    socket.set_option(Tcp::no_delay(true), error);
    const std::string address = from.address().to_string();
    const bool is_full = counts_->IsFull(address);
    const auto connection = std::make_shared<HttpConnection>(std::move(socket), site_, counts_, address);
    is_full
        ? connection->Refuse(503, "this server already has the maximum number of connections; try again in a minute")
        : connection->Read();
  }

  void AcceptLater() {
    const auto later = std::make_shared<asio::steady_timer>(io_, std::chrono::milliseconds(100));
    later->async_wait([this, later](beast::error_code error) {
      if (!error && acceptor_.is_open()) Accept();
    });
  }

  asio::io_context& io_;
  Tcp::acceptor acceptor_;
  Site& site_;
  std::shared_ptr<Counts> counts_;
  asio::steady_timer timer_;
  std::function<void()> on_left_;
  int times_left_ = 0;  ///< Number of consecutive checks at which no page was connected any more.
};

Diagnostic CannotListen(const Settings& settings, const std::string& why) {
  return NewProblem(
      "the server cannot listen at " + settings.address + ":" + std::to_string(settings.port) + ": " + why,
      "choose another address or port with --listen ADDRESS:PORT");
}

}  // namespace

Result<void> Serve(Settings settings, std::unique_ptr<const Catalog> catalog,
                   const std::function<void(const std::vector<Address>&)>& on_listening) {
  asio::io_context io(1);
  beast::error_code error;
  const asio::ip::address address = asio::ip::make_address(settings.address, error);
  if (error)
    return CannotListen(settings, "this is not an address; 127.0.0.1 is this machine, 0.0.0.0 all its networks");
  Tcp::acceptor acceptor(io);
  const Tcp::endpoint endpoint(address, settings.port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) return CannotListen(settings, error.message());
  settings.port = acceptor.local_endpoint().port();
  Result<std::unique_ptr<Site>> site = Site::Make(io, std::move(settings), std::move(catalog));
  if (!site) return site.error();
  const Settings& used = (*site)->settings();
  Server server(io, std::move(acceptor), **site);
  server.Accept();
  server.CleanUpAgain();

  const std::string host = address.is_v6() ? "[" + used.address + "]" : used.address;
  const std::string base = "http://" + host + ":" + std::to_string(used.port);
  const std::string token = used.token.empty() ? "" : "#token=" + used.token;
  std::vector<Address> links = {{"", base + "/" + token}};
  if (!(*site)->learners().key().empty()) {
    links.push_back({"the teacher", base + "/class/" + (*site)->learners().key() + "/" + token});
    for (const ClassList::Learner& learner : (*site)->learners().learners())
      links.push_back({learner.name, base + "/p/" + learner.place + "/" + token});
  }
  on_listening(links);

  asio::signal_set signals(io, SIGINT, SIGTERM);
  asio::steady_timer grace(io);
  const auto end = [&] {
    server.Close();
    (*site)->EndAll("The server is being stopped. What you typed and the recording are kept.");
    // Engines need this time to finish their recordings.
    grace.expires_after(std::chrono::seconds(2));
    grace.async_wait([&io](beast::error_code) { io.stop(); });
  };
  signals.async_wait([&](beast::error_code failed, int) {
    if (!failed) end();
  });
  server.SetOnLeft(end);
  io.run();
  return {};
}

}  // namespace soarbox::serve
