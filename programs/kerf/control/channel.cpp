#include "programs/kerf/control/channel.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "programs/kerf/control/client.hpp"
#include "programs/kerf/control/replies.hpp"
#include "programs/kerf/control/request.hpp"
#include "programs/kerf/control/request_execution.hpp"
#include "programs/kerf/control/status_line.hpp"

namespace kerf::program {

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBeat{10};
constexpr std::chrono::seconds kFarewell{1};

}  // namespace

class ControlChannel::Server {
 public:
  Server(ControlEndpoint endpoint, Operator& by, Order order)
      : order_(std::move(order)),
        by_(&by),
        file_(std::move(endpoint.file)),
        requests_(by, {.feed_inputs = order_.feed_inputs,
                       .machine_has_inputs = order_.machine_has_inputs,
                       .tools = order_.tools,
                       .break_down = order_.break_down}) {
    if (endpoint.listens.is_open()) {
      acceptor_.emplace(context_, asio::local::stream_protocol(),
                        std::move(endpoint.listens).release());
      accept();
    } else {
      add(std::move(endpoint.in), std::move(endpoint.out));
    }
    beat();
    thread_ = std::thread([this] { context_.run(); });
  }
  ~Server() {
    context_.stop();
    thread_.join();
    by_->drop_orders(this);  // they would answer to clients
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void close() {
    std::promise<void> closed;
    asio::post(context_, [this, &closed] {
      is_over_ = true;
      closed.set_value();
    });
    closed.get_future().wait();
  }
  void finish(ExitStatus status, const std::vector<ProgramMessage>& last_words) {
    asio::post(context_, [this, status, last_words] {
      tell_events();
      for (const ProgramMessage& message : last_words) {
        tell_all(
            event_json({.number = next_event_++, .kind = ControllerEvent::Kind::message}, message));
      }
      tell_all(end_json(status));
      has_ended_ = true;
    });
    const auto deadline = Clock::now() + kFarewell;
    while (!is_told_ && Clock::now() < deadline) {
      std::this_thread::sleep_for(kBeat);
    }
  }

 private:
  void accept() {
    acceptor_->async_accept([this](const error_code& error, auto socket) {
      if (!error) {
        add(Descriptor(socket.release()), {});
      }
      if (acceptor_->is_open()) {
        accept();
      }
    });
  }
  void add(Descriptor in, Descriptor out) {
    clients_.push_back(std::make_shared<ControlClient>(
        context_, std::move(in), std::move(out),
        [this](const std::shared_ptr<ControlClient>& client, std::optional<std::string_view> line) {
          if (!has_ended_) {
            answer(client, line);
          }
        }));
    clients_.back()->write(hello_json(order_.file));
    clients_.back()->read();
  }

  void beat() {
    timer_.expires_after(kBeat);
    timer_.async_wait([this](const error_code& error) {
      if (error) {
        return;
      }
      std::erase_if(clients_, [](const auto& client) { return !client->is_open(); });
      tell_events();
      tell_statuses();
      stop_where_nobody_answers();
      is_told_ = has_ended_ && std::ranges::all_of(clients_, &ControlClient::has_written);
      beat();
    });
  }
  void tell_all(const std::string& line) {
    if (has_ended_) {
      return;
    }
    for (const auto& client : clients_) {
      client->write(line);
    }
  }
  [[nodiscard]] std::vector<std::string> events_since(std::uint64_t& number) const {
    std::array<ControllerEvent, ControllerEvent::kKept> events;
    const std::size_t count = by_->controller().events_since(number, events);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < count; ++i) {
      lines.push_back(event_json(events[i], by_->controller().message(events[i].message)));
      number = events[i].number + 1;
    }
    return lines;
  }
  void tell_events() {
    for (const std::string& line : events_since(next_event_)) {
      tell_all(line);
    }
  }
  void tell_statuses() {
    if (has_ended_) {
      return;
    }
    const auto now = Clock::now();
    for (const auto& client : clients_) {
      if (client->every.count() > 0 && now >= client->next_status) {
        client->next_status = now + client->every;
        client->write(status_json(client->every_id, by_->status(), order_.extra));
      }
    }
  }
  // Asked again and again: the operator may be about to carry out an answer.
  void stop_where_nobody_answers() {
    const bool answers =
        order_.others_answer || acceptor_ || std::ranges::any_of(clients_, &ControlClient::reads);
    if (!answers && stands_until_asked(by_->status())) {
      by_->ask(this, [this] {
        if (stands_until_asked(by_->status())) {
          static_cast<void>(by_->give(kerf::Command::stop));
        }
      });
    }
  }
  [[nodiscard]] bool stands_until_asked(const ControllerStatus& status) const noexcept {
    return status.waits_for == WaitsFor::answer || status.state == ControllerState::held ||
           (status.state == ControllerState::idle && order_.waits_for_start) ||
           (status.state == ControllerState::running && is_held_by_feed(status));
  }

  // The machine's own inputs let it go on by themselves.
  [[nodiscard]] bool is_held_by_feed(const ControllerStatus& status) const noexcept {
    return status.is_held_by_feed && !(order_.machine_has_inputs && is_held_by_machine(status));
  }

  void answer(const std::shared_ptr<ControlClient>& client, std::optional<std::string_view> line) {
    auto request = control_request(line);
    if (!request) {
      client->write(bad_request_json(request.error(), by_->status().state));
      return;
    }
    if (is_over_) {
      client->write(refused_json(*request, by_->status().state, "the run is over"));
    } else if (request->kind == ControlRequest::Kind::events) {
      for (const std::string& event : events_since(request->since)) {
        client->write(event);
      }
      client->write(accepted_json(*request, by_->status().state));
    } else if (request->kind == ControlRequest::Kind::status) {
      client->write(status_json(request->id, by_->status(), order_.extra));
      if (request->every_s) {
        client->every_id = request->id;
        client->every = std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(*request->every_s));
        client->next_status = Clock::now() + client->every;
      }
    } else if (request->kind == ControlRequest::Kind::command &&
               request->command == kerf::Command::emergency_stop) {
      by_->emergency_stop();
      client->write(accepted_json(*request, by_->status().state));
    } else {
      client->begin_answer();
      by_->ask(this, [this, client, request = *std::move(request)] {
        const auto done = requests_.carry_out(request);
        const ControllerState state = by_->status().state;
        asio::post(context_, [client, line = done ? accepted_json(request, state)
                                                  : refused_json(request, done.error().state,
                                                                 done.error().reason)] {
          client->end_answer(line);
        });
      });
    }
  }
  Order order_;
  Operator* by_;
  asio::io_context context_;
  std::optional<asio::local::stream_protocol::acceptor> acceptor_;
  SocketFile file_;  // gone before nobody listens
  asio::steady_timer timer_{context_};
  std::vector<std::shared_ptr<ControlClient>> clients_;
  RequestExecution requests_;  // of the thread that plans
  std::uint64_t next_event_ = 1;
  bool is_over_ = false;    // no commands any more
  bool has_ended_ = false;  // nothing is said any more
  std::atomic<bool> is_told_ = false;
  std::thread thread_;
};

ControlChannel::ControlChannel(ControlEndpoint endpoint, Operator& by, Order order)
    : server_(std::make_unique<Server>(std::move(endpoint), by, std::move(order))) {}
ControlChannel::~ControlChannel() = default;

void ControlChannel::close() {
  server_->close();
}

void ControlChannel::finish(ExitStatus status, const std::vector<ProgramMessage>& last_words) {
  server_->finish(status, last_words);
}

}  // namespace kerf::program
