#include "viewer/page_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <list>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_request = 16384;
constexpr std::size_t most_connections = 64;
constexpr std::chrono::seconds patience{10};

[[noreturn]] void throw_not_served(const std::string& what) {
  throw GoalError("cannot serve the page, " + what + ": " + std::strerror(errno));
}

/// Returns 128 random bits that cannot be guessed, as text.
std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw_not_served("because the system provides no random numbers");
  std::string token;
  for (const unsigned char byte : bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    token += {digits[byte >> 4U], digits[byte & 15U]};
  }
  return token;
}

/// Casts an address to the type that the socket interface uses for all address families.
sockaddr* general(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

int listener_on(int port, int& bound) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (listener < 0) throw_not_served("because the system provides no socket");
  const int yes = 1;
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof address;
  if (bind(listener, general(address), size) != 0 || listen(listener, 16) != 0 ||
      getsockname(listener, general(address), &size) != 0) {
    close(listener);
    throw_not_served("on port " + std::to_string(port));
  }
  bound = ntohs(address.sin_port);
  return listener;
}

std::string message(const std::string& status, const Answer& answer, bool has_body) {
  return "HTTP/1.1 " + status + "\r\nContent-Type: " + answer.type +
         "\r\nContent-Length: " + std::to_string(answer.body.size()) +
         "\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff"
         "\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin"
         "\r\nX-Frame-Options: DENY\r\nConnection: close\r\n\r\n" +
         (has_body ? answer.body : "");
}

std::string refusal(const std::string& status) {
  return message(status, {"text/plain; charset=utf-8", status + '\n'}, true);
}

std::string lower(std::string text) {
  for (char& character : text)
    if (character >= 'A' && character <= 'Z') character = static_cast<char>(character - 'A' + 'a');
  return text;
}

/// Returns the value of a header. Returns an empty text if the request has no such header.
std::string header_of(const std::string& request, const std::string& name) {
  const std::size_t found = lower(request).find("\r\n" + name + ':');
  if (found == std::string::npos) return {};
  std::size_t begin = found + name.size() + 3;
  while (begin < request.size() && request[begin] == ' ') ++begin;
  return request.substr(begin, request.find('\r', begin) - begin);
}

/// True if the value of a Host header names this machine. The port is ignored, because it is
/// different if the browser connects through an SSH tunnel.
bool is_loopback(const std::string& host) {
  const std::string name = lower(host.substr(0, host.rfind(':')));
  return name == "127.0.0.1" || name == "localhost";
}

}  // namespace

/// A connection that first receives a request and then sends the answer, without blocking.
struct PageServer::Connection {
  int socket = -1;
  std::string request, answer;
  std::size_t sent = 0;
  Clock::time_point since = Clock::now();

  bool is_answering() const { return !answer.empty(); }
};

/// Receives a part of a request. Returns false if the client has closed the connection or the
/// request is invalid.
bool PageServer::receive(Connection& connection) {
  std::array<char, 4096> block{};
  const ssize_t count = recv(connection.socket, block.data(), block.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  if (count == 0) return false;
  connection.request.append(block.data(), static_cast<std::size_t>(count));
  return connection.request.size() <= longest_request;
}

/// Sends a part of the answer. Returns false if the whole answer is sent or the client has closed
/// the connection.
bool PageServer::send_some(Connection& connection) {
  const std::string_view rest = std::string_view(connection.answer).substr(connection.sent);
  const ssize_t count = send(connection.socket, rest.data(), rest.size(), MSG_NOSIGNAL);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  connection.since = Clock::now();
  connection.sent += static_cast<std::size_t>(count);
  return connection.sent < connection.answer.size();
}

PageServer::PageServer(int port) : token_(random_token()) {
  listener_ = listener_on(port, port_);
  address_ = "http://127.0.0.1:" + std::to_string(port_) + '/' + token_ + '/';
}

PageServer::~PageServer() { close(listener_); }

std::string PageServer::answer(const std::string& request, const Site& site) const {
  const std::string line = request.substr(0, request.find('\r'));
  const std::size_t first = line.find(' '), last = line.rfind(' ');
  if (first == std::string::npos || first == last || !line.substr(last).starts_with(" HTTP/1."))
    return refusal("400 Bad Request");
  const std::string method = line.substr(0, first);
  if (method != "GET" && method != "HEAD") return refusal("405 Method Not Allowed");
  // Prevents DNS rebinding: a foreign page may have had its host name resolved to this machine.
  if (!is_loopback(header_of(request, "host"))) return refusal("403 Forbidden");
  const std::string path = line.substr(first + 1, last - first - 1), prefix = '/' + token_ + '/';
  if (!path.starts_with(prefix)) return refusal("404 Not Found");
  const std::optional<Answer> found = site(path.substr(prefix.size()));
  return found ? message("200 OK", *found, method == "GET") : refusal("404 Not Found");
}

/// Accepts a connection. Returns false if there is no free file descriptor. The connection then
/// stays in the queue of the system.
bool PageServer::accept_one(std::list<Connection>& connections) const {
  const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (socket >= 0) connections.emplace_back().socket = socket;
  return socket >= 0 || errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
}

/// Receives a part of the request or sends a part of the answer. Returns false if the connection
/// has ended.
bool PageServer::advance(Connection& connection, const Site& site) const {
  if (connection.is_answering()) return send_some(connection);
  if (!receive(connection)) return false;
  if (connection.request.find("\r\n\r\n") != std::string::npos)
    connection.answer = answer(connection.request, site);
  return true;
}

void PageServer::serve(const Site& site) {
  std::list<Connection> connections;
  bool can_accept = true;
  while (true) {
    // poll() skips negative descriptors. If connections cannot be accepted, the listener is
    // skipped, because every poll() would return at once. The listener is tried again after a
    // second, or when another connection has ended.
    const bool listens = can_accept && connections.size() < most_connections;
    std::vector<pollfd> waiting{{listens ? listener_ : -1, POLLIN, 0}};
    for (const Connection& connection : connections)
      waiting.push_back(
          {connection.socket, static_cast<short>(connection.is_answering() ? POLLOUT : POLLIN), 0});
    poll(waiting.data(), waiting.size(), 1000);

    std::size_t i = 0;
    std::erase_if(connections, [&](Connection& connection) {
      const bool is_due = waiting[++i].revents != 0;
      const bool is_late = Clock::now() - connection.since >= patience;
      const bool stays = is_due ? advance(connection, site) : !is_late;
      if (!stays) close(connection.socket);
      return !stays;
    });
    can_accept = waiting[0].revents == 0 || accept_one(connections);
  }
}

}  // namespace transformesh::tool
