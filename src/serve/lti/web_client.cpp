// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/web_client.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <optional>

#include "diagnostics/problem.h"
#include "serve/lti/web_address.h"

namespace soarbox::lti {
namespace {

namespace asio = boost::asio;
namespace ssl = asio::ssl;
namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = asio::ip::tcp;

constexpr auto kStepTime = std::chrono::seconds(10);
constexpr std::size_t kMostAnswerBytes = 1u << 20;

/// One request to a server, and its answer. Each step blocks until it has ended.
class Exchange {
 public:
  Exchange(const WebAddress& address, const std::atomic<bool>& stop) : address_(address), stop_(stop) {}

  Result<ClientResponse> Run(const ClientRequest& request) {
    beast::error_code error = Connect();
    if (error) return Failed("cannot be reached", error);
    Prepare(request);
    if (!address_.is_secure) return Talk(tcp_);
    ssl::context context(ssl::context::tls_client);
    context.set_default_verify_paths(error);
    ssl::stream<beast::tcp_stream&> secure(tcp_, context);
    secure.set_verify_mode(ssl::verify_peer, error);
    secure.set_verify_callback(ssl::host_name_verification(address_.host), error);
    if (SSL_set_tlsext_host_name(secure.native_handle(), address_.host.c_str()) != 1 || error)
      return Failed("cannot be asked over TLS", error);
    error = Await([&](auto done) { secure.async_handshake(ssl::stream_base::client, done); });
    if (error) return Failed("has no certificate that this machine trusts, or does not speak TLS", error);
    return Talk(secure);
  }

 private:
  /// Starts an operation and waits for its end.
  template <typename Start>
  beast::error_code Await(Start start) {
    beast::error_code result = asio::error::timed_out;
    tcp_.expires_after(kStepTime);
    io_.restart();
    start([&result](beast::error_code error, auto&&...) { result = error; });
    const auto latest = std::chrono::steady_clock::now() + kStepTime + std::chrono::seconds(1);
    bool is_cancelled = false;
    while (!io_.stopped()) {
      io_.run_for(std::chrono::milliseconds(100));
      if (is_cancelled || (!stop_ && std::chrono::steady_clock::now() < latest)) continue;
      is_cancelled = true;
      resolver_.cancel();
      tcp_.cancel();
    }
    return result;
  }

  beast::error_code Connect() {
    Tcp::resolver::results_type found;
    beast::error_code error = Await([&](auto done) {
      resolver_.async_resolve(address_.host, address_.port,
                              [&found, done](beast::error_code failed, Tcp::resolver::results_type results) {
                                found = std::move(results);
                                done(failed);
                              });
    });
    return error ? error : Await([&](auto done) { tcp_.async_connect(found, done); });
  }

  void Prepare(const ClientRequest& given) {
    request_.version(11);
    request_.method_string(given.method);
    request_.target(address_.path);
    request_.set(http::field::host, address_.origin().substr(address_.is_secure ? 8 : 7));
    request_.set(http::field::user_agent, "soarbox");
    request_.set(http::field::accept, "application/json");
    request_.set(http::field::connection, "close");
    for (const auto& [name, value] : given.headers) request_.set(name, value);
    if (!given.type.empty()) request_.set(http::field::content_type, given.type);
    request_.body() = given.body;
    request_.prepare_payload();
  }

  template <typename Stream>
  Result<ClientResponse> Talk(Stream& stream) {
    beast::error_code error = Await([&](auto done) { http::async_write(stream, request_, done); });
    if (error) return Failed("takes no request", error);
    http::response_parser<http::string_body> parser;
    parser.body_limit(kMostAnswerBytes);
    beast::flat_buffer buffer;
    error = Await([&](auto done) { http::async_read(stream, buffer, parser, done); });
    if (error) return Failed("gives no answer", error);
    return ClientResponse{static_cast<int>(parser.get().result_int()), std::move(parser.get().body())};
  }

  Diagnostic Failed(const std::string& what, beast::error_code error) const {
    return NewProblem(address_.origin() + " " + what + (error ? ": " + error.message() : ""));
  }

  const WebAddress& address_;
  const std::atomic<bool>& stop_;
  asio::io_context io_{1};
  Tcp::resolver resolver_{io_};
  beast::tcp_stream tcp_{io_};
  http::request<http::string_body> request_;
};

}  // namespace

Result<ClientResponse> Fetch(const ClientRequest& request, const std::atomic<bool>& stop) {
  const std::optional<WebAddress> address = ReadWebAddress(request.url);
  if (!address) return NewProblem("this is not an address of the web: " + request.url);
  return Exchange(*address, stop).Run(request);
}

}  // namespace soarbox::lti
