// SPDX-License-Identifier: BSD-2-Clause
#include "serve/work.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <exception>
#include <utility>

namespace soarbox::serve {

namespace asio = boost::asio;

constexpr std::size_t kThreads = 4;

Work::Work(asio::io_context& io) : io_(io), pool_(kThreads) {}

Work::~Work() {
  pool_.stop();
  pool_.join();
}

void Work::Do(const std::string& name, std::function<void()> job, std::function<void()> done) {
  Line& line = lines_.try_emplace(name, Line{Strand(pool_.get_executor())}).first->second;
  ++line.waiting;
  asio::post(line.strand, [this, name, job = std::move(job), done = std::move(done)]() mutable {
    try {
      job();
    } catch (const std::exception&) {
      // For example, a folder was removed or memory is exhausted. The server continues.
    }
    job = nullptr;  // Its data are released before the reply is sent.
    asio::post(io_, [this, name = std::move(name), done = std::move(done)] {
      const auto found = lines_.find(name);
      if (found != lines_.end() && --found->second.waiting == 0) lines_.erase(found);
      done();
    });
  });
}

std::size_t Work::Waiting(const std::string& name) const {
  const auto found = lines_.find(name);
  return found == lines_.end() ? 0 : found->second.waiting;
}

Costs::Account& Costs::Find(const std::string& name) {
  constexpr std::size_t kMostNames = 10'000;
  const Clock::time_point now = Clock::now();
  const auto grown = [&](const Account& account) {
    return std::min(burst_, account.left + per_s_ * std::chrono::duration<double>(now - account.when).count());
  };
  if (accounts_.size() > kMostNames)
    std::erase_if(accounts_, [&](const auto& each) { return grown(each.second) >= burst_; });
  const auto [found, is_new] = accounts_.try_emplace(name, Account{burst_, now});
  found->second = {grown(found->second), now};
  return found->second;
}

bool Costs::MayBegin(const std::string& name) {
  return Find(name).left > 0;
}

void Costs::Charge(const std::string& name, double points) {
  Find(name).left -= points;
}

}  // namespace soarbox::serve
