// SPDX-License-Identifier: BSD-2-Clause
#include "serve/page_connection.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <utility>

#include "diagnostics/problem.h"

namespace soarbox::serve {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Request = http::request<http::string_body>;

/// Maximum bytes that may be queued for a page: above the first limit, scenes are left out; above the second, the
/// connection is closed.
constexpr std::size_t kScenesWaitAbove = 192u << 10, kMostWaiting = 16u << 20;
/// Time after which a scene is requested for a page that has missed one. A run that is not paused sends one before
/// that.
constexpr std::chrono::milliseconds kSceneAfter(500);

/// Limits the requests of a client: an average rate per second, and bursts of four times as many.
class Allowance {
 public:
  explicit Allowance(double per_s) : per_s_(per_s), left_(4 * per_s) {}

  bool Take() {
    const auto now = std::chrono::steady_clock::now();
    left_ = std::min(4 * per_s_, left_ + per_s_ * std::chrono::duration<double>(now - last_).count());
    last_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  double per_s_, left_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class PageConnection final : public Viewer, public std::enable_shared_from_this<PageConnection> {
 public:
  PageConnection(boost::asio::ip::tcp::socket socket, Site& site, const Site::Admission& admission,
                 std::function<void()> on_gone)
      : socket_(std::move(socket)),
        session_(admission.session),
        may_ask_(admission.may_ask),
        on_gone_(std::move(on_gone)),
        site_(site),
        address_(admission.address),
        rest_timer_(socket_.get_executor()),
        scene_timer_(socket_.get_executor()),
        allowance_(site.settings().limits.requests_per_s) {
    websocket::stream_base::timeout times{std::chrono::seconds(10), std::chrono::seconds(60), true};
    socket_.set_option(times);
    socket_.read_message_max(site.settings().limits.message_bytes);
    if (!admission.protocol.empty()) {
      socket_.set_option(
          websocket::stream_base::decorator([protocol = admission.protocol](websocket::response_type& answer) {
            answer.set(http::field::sec_websocket_protocol, protocol);
          }));
    }
    session_->Join(*this, admission.tab);
  }
  ~PageConnection() override {
    session_->Leave(*this);
    on_gone_();
  }
  PageConnection(const PageConnection&) = delete;
  PageConnection& operator=(const PageConnection&) = delete;

  void Accept(Request request) {
    const auto kept = std::make_shared<Request>(std::move(request));
    socket_.async_accept(*kept, [self = shared_from_this(), kept](beast::error_code error) {
      if (error) return;
      self->is_accepted_ = true;
      self->Write();
      self->Read();
    });
  }

  void SendText(Bytes text, const std::string& key) override {
    if (!key.empty()) {
      // Replaces a waiting message, but not the one that is being written.
      const auto begin = waiting_.begin() + (is_writing_ ? 1 : 0);
      const auto older = std::find_if(begin, waiting_.end(), [&](const Out& out) { return out.key == key; });
      if (older != waiting_.end()) {
        waiting_bytes_ += text->size() - older->bytes->size();
        older->bytes = std::move(text);
        return;
      }
    }
    Send({std::move(text), false, key});
  }

  void SendScene(Bytes block, bool is_full) override {
    if (needs_full_ && !is_full) return;
    // The first scene is always sent, because no other follows in a paused run.
    needs_full_ = has_scene_ && waiting_bytes_ > kScenesWaitAbove;
    if (needs_full_) return;
    has_scene_ = true;
    Send({std::move(block), true, {}});
  }

  bool MayAsk() const override { return may_ask_; }

 private:
  struct Out {
    Bytes bytes;
    bool is_binary = false;
    std::string key;
  };

  void Send(Out out) {
    waiting_bytes_ += out.bytes->size();
    if (waiting_bytes_ > kMostWaiting) return Close();
    waiting_.push_back(std::move(out));
    Write();
  }

  void Write() {
    if (!is_accepted_ || is_writing_ || waiting_.empty()) return;
    is_writing_ = true;
    socket_.binary(waiting_.front().is_binary);
    socket_.async_write(boost::asio::buffer(*waiting_.front().bytes),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->is_writing_ = false;
                          self->waiting_bytes_ -= self->waiting_.front().bytes->size();
                          self->waiting_.pop_front();
                          if (error) return self->Close();
                          self->Write();
                          if (self->waiting_.empty() && self->has_scene_ && self->needs_full_) self->CatchUp();
                        });
  }

  /// Requests the present scene if the page has missed one and gets no other within kSceneAfter, as in a paused run.
  void CatchUp() {
    if (std::exchange(catches_up_, true)) return;
    scene_timer_.expires_after(kSceneAfter);
    scene_timer_.async_wait([self = shared_from_this()](beast::error_code error) {
      self->catches_up_ = false;
      if (!error && self->needs_full_) self->session_->AskForScene();
    });
  }

  void Read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->Close();
      std::string text = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.clear();
      if (!self->socket_.got_text()) {
        self->Refuse(NewProblem("this server reads text only", "a request is a JSON object"));
      } else if (!self->allowance_.Take()) {
        self->Refuse(NewProblem("you send requests faster than this server allows", "wait a moment"));
      } else if (!self->site_.MayBegin(self->session_->place().id(), self->address_)) {
        self->Refuse(NewProblem("you send more than this server allows", "wait a moment"));
        return self->ReadLater();
      } else {
        // A point for each 64 KB: parsing them takes about a millisecond.
        constexpr double kBytesPerPoint = 65536;
        self->site_.Charge(self->session_->place().id(), self->address_,
                           static_cast<double>(text.size()) / kBytesPerPoint);
        self->session_->Take(*self, std::move(text));
      }
      self->Read();
    });
  }

  /// Reads again after a second. Meanwhile the page's data stay in the buffers of the network.
  void ReadLater() {
    rest_timer_.expires_after(std::chrono::seconds(1));
    rest_timer_.async_wait([self = shared_from_this()](beast::error_code error) {
      if (!error) self->Read();
    });
  }

  void Refuse(const Diagnostic& problem) {
    SendText(std::make_shared<const std::string>(ErrorMessage(problem)), "refusal");
  }

  /// Closes the socket. Pending operations then end with an error and release this object.
  void Close() {
    rest_timer_.cancel();
    scene_timer_.cancel();
    beast::get_lowest_layer(socket_).close();
  }

  websocket::stream<beast::tcp_stream> socket_;
  std::shared_ptr<Session> session_;
  bool may_ask_;
  std::function<void()> on_gone_;
  Site& site_;
  std::string address_;
  boost::asio::steady_timer rest_timer_, scene_timer_;
  Allowance allowance_;
  beast::flat_buffer buffer_;
  std::deque<Out> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool is_accepted_ = false, is_writing_ = false, needs_full_ = true, has_scene_ = false, catches_up_ = false;
};

}  // namespace

void ServePage(boost::asio::ip::tcp::socket socket, Request request, Site& site, const Site::Admission& admission,
               std::function<void()> on_gone) {
  std::make_shared<PageConnection>(std::move(socket), site, admission, std::move(on_gone))->Accept(std::move(request));
}

}  // namespace soarbox::serve
