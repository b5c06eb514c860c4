// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "sml/server/connection.h"
#include "sml/wire/message.h"

namespace soarbox::server {

class KernelHost;

/// Executes one call of a client. Every call gets a response; errors are described in its text.
class Dispatcher {
 public:
  Dispatcher(KernelHost& host, Connection& from) : host_(host), from_(from) {}

  void Handle(const wire::Message& call, wire::Message& response);

  struct Request;

 private:
  KernelHost& host_;
  Connection& from_;
};

}  // namespace soarbox::server
