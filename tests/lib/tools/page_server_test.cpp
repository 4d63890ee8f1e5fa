#include "viewer/page_server.h"

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

using namespace transformesh;
using namespace transformesh::tool;

namespace {

/// A server in its own process, whose CPU time can be measured.
class ServerProcess {
 public:
  /// The server has file descriptors for `connections` connections and no more.
  explicit ServerProcess(int connections = 256) : server_(0), process_(fork()) {
    if (process_ != 0) return;
    const int first_free = dup(STDERR_FILENO);
    close(first_free);
    const auto most = static_cast<rlim_t>(first_free + connections);
    const rlimit files{most, most};
    setrlimit(RLIMIT_NOFILE, &files);
    server_.serve([](const std::string&) { return Answer{"text/plain", "the page"}; });
  }
  ~ServerProcess() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  int port() const {
    const std::string& address = server_.address();
    return std::stoi(address.substr(address.find(':', 5) + 1));
  }
  std::string request() const {
    const std::string& address = server_.address();
    return "GET " + address.substr(address.find('/', 7)) +
           " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\n\r\n";
  }
  double cpu_seconds() const {
    clockid_t clock{};
    timespec time{};
    REQUIRE(clock_getcpuclockid(process_, &clock) == 0);
    REQUIRE(clock_gettime(clock, &time) == 0);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

 private:
  PageServer server_;
  pid_t process_;
};

int connection_to(const ServerProcess& server) {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(server.port()));
  REQUIRE(connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  return connection;
}

std::string answer_on(int connection, const std::string& request) {
  REQUIRE(send(connection, request.data(), request.size(), 0) ==
          static_cast<ssize_t>(request.size()));
  std::string answer;
  std::array<char, 4096> block{};
  for (ssize_t count = 1; count > 0;) {
    count = recv(connection, block.data(), block.size(), 0);
    if (count > 0) answer.append(block.data(), static_cast<std::size_t>(count));
  }
  return answer;
}

/// Checks the server's CPU time during a second in which these connections are silent. The last
/// connection is answered after the first one has ended.
void check_idle(const ServerProcess& server, int count) {
  std::vector<int> connections;
  for (int i = 0; i < count; ++i) connections.push_back(connection_to(server));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const double before = server.cpu_seconds();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  CHECK(server.cpu_seconds() - before < 0.02);
  close(connections.front());
  CHECK(answer_on(connections.back(), server.request()).ends_with("\r\n\r\nthe page"));
  for (std::size_t i = 1; i < connections.size(); ++i) close(connections[i]);
}

}  // namespace

TEST_CASE("a page server answers only requests with the token") {
  const ServerProcess server;
  const int connection = connection_to(server);
  CHECK(answer_on(connection, server.request()).starts_with("HTTP/1.1 200 OK\r\n"));
  close(connection);
}

TEST_CASE("64 silent connections, and one that waits, take no processor time") {
  const ServerProcess server;
  check_idle(server, 65);
}

TEST_CASE("connections that wait for file descriptors take no processor time") {
  const ServerProcess server(4);
  check_idle(server, 8);
}
