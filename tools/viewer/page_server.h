/// Serves a page to browsers on this machine, by HTTP on the loopback address. Requests must
/// contain a secret token. Only contents of the site can be read, and no file is opened. Uses one
/// thread.
#pragma once

#include <functional>
#include <list>
#include <optional>
#include <string>

namespace transformesh::tool {

struct Answer {
  std::string type;  ///< media type of the content
  std::string body;
};

class PageServer {
 public:
  /// Listens on a port; 0 chooses a free port. Throws GoalError if listening fails.
  explicit PageServer(int port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// Returns the URL of the page: http://127.0.0.1:PORT/TOKEN/
  const std::string& address() const { return address_; }

  /// Answers requests and does not return. `site` receives the path after the token, such as
  /// `page.json`, and returns nothing if there is no such content.
  using Site = std::function<std::optional<Answer>(const std::string& name)>;
  [[noreturn]] void serve(const Site& site);

  /// Returns the complete answer to the head of a request. Public for tests.
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
