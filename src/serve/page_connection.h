// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <functional>
#include <memory>
#include <string>

#include "serve/site.h"

namespace soarbox::serve {

/// Serves a page over a WebSocket until it disconnects. Disconnects it if too much data waits for it. `on_gone` is
/// called once, at the end.
void ServePage(boost::asio::ip::tcp::socket socket,
               boost::beast::http::request<boost::beast::http::string_body> request, Site& site,
               const Site::Admission& admission, std::function<void()> on_gone);

}  // namespace soarbox::serve
