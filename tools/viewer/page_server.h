/// Serves a page to the browsers of this machine: HTTP on the loopback address, for who knows the
/// token in the address, read only, nothing but what the site has. One thread, no file is opened.
#pragma once

#include <functional>
#include <list>
#include <optional>
#include <string>

namespace transformesh::tool {

struct Answer {
  std::string type;  ///< of media
  std::string body;
};

class PageServer {
 public:
  /// Listens on this port, or on one that is free where it is 0. Throws GoalError.
  explicit PageServer(int port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// http://127.0.0.1:PORT/TOKEN/
  const std::string& address() const { return address_; }

  /// Answers for ever. `site` gets what follows the token, such as `page.json`, and gives nothing
  /// where there is nothing of that name.
  using Site = std::function<std::optional<Answer>(const std::string& name)>;
  [[noreturn]] void serve(const Site& site);

  /// The whole answer to the head of a request: for serve(), and to be tested.
  std::string answer(const std::string& request, const Site& site) const;

 private:
  struct Connection;
  bool accept_one(std::list<Connection>& connections) const;
  bool advance(Connection& connection, const Site& site) const;
  static bool receive(Connection& connection);
  static bool send_some(Connection& connection);

  int listener_ = -1;
  std::string token_, address_;
  int port_ = 0;
};

}  // namespace transformesh::tool
