// SPDX-License-Identifier: BSD-2-Clause
// Connections of clients that start a message but do not complete it.
#include "sml/wire/channel.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <future>
#include <string_view>

namespace soarbox::wire {
namespace {

/// Listens and returns the first accepted channel.
struct Listening {
  Listening() {
    ChannelLimits limits;
    limits.patience = std::chrono::milliseconds(50);
    auto opened = Acceptor::Open(io, "127.0.0.1", -1, limits,
                                 [this](std::unique_ptr<Channel> channel) { came.set_value(std::move(channel)); });
    EXPECT_TRUE(opened.ok());
    acceptor = std::move(*opened);
  }
  IoThread io;
  std::promise<std::unique_ptr<Channel>> came;
  std::unique_ptr<Acceptor> acceptor;
};

int ConnectTo(int port) {
  const int made = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return made;
}

void Send(int to, std::string_view bytes) {
  EXPECT_EQ(send(to, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
}

/// Waits until the peer closes the connection.
bool IsClosed(int from) {
  char byte = 0;
  return recv(from, &byte, 1, 0) <= 0;
}

constexpr std::string_view kHello("\0\0\0\5hello", 9), kBegun("\0\0\0\5he", 6);

TEST(Channel, WhoSendsNoWholeMessageIsClosed) {
  Listening listening;
  const int client = ConnectTo(listening.acceptor->port());
  Send(client, kBegun);
  const std::unique_ptr<Channel> channel = listening.came.get_future().get();
  EXPECT_TRUE(IsClosed(client));
  EXPECT_TRUE(channel->silent());
  close(client);
}

TEST(Channel, WhoHasSentOneMaySaySoLittleAsHeLikesButMustEndWhatHeBegins) {
  Listening listening;
  const int client = ConnectTo(listening.acceptor->port());
  Send(client, kHello);
  const std::unique_ptr<Channel> channel = listening.came.get_future().get();
  std::string message;
  ASSERT_TRUE(channel->Wait(message, std::chrono::seconds(60)));
  EXPECT_EQ(message, "hello");
  EXPECT_FALSE(channel->silent());
  // The connection is still open after four times the patience.
  usleep(200'000);
  EXPECT_FALSE(channel->closed());
  Send(client, kHello);
  ASSERT_TRUE(channel->Wait(message, std::chrono::seconds(60)));
  Send(client, kBegun);
  EXPECT_TRUE(IsClosed(client));
  close(client);
}

}  // namespace
}  // namespace soarbox::wire
