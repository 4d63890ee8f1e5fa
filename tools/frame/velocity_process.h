/// A command of the user that stays alive and computes velocities for one mesh after another.
///
/// Protocol on the command's standard streams: the command first writes the line `ready`. Then it
/// answers requests. A request is a line `mesh BYTES TIME SPAN STAGE` and BYTES bytes of binary PLY
/// with double coordinates. The answer is a line `velocities COUNT` and three little-endian doubles
/// for each of the COUNT vertices, in their order. The command ends with exit code 0 when its input
/// ends.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "transformesh/motion.h"

namespace transformesh::tool {

class VelocityProcess {
 public:
  /// Starts the command. Throws GoalError if the command cannot be run or does not write `ready`
  /// within ten seconds.
  explicit VelocityProcess(std::string command);
  ~VelocityProcess();
  VelocityProcess(const VelocityProcess&) = delete;
  VelocityProcess& operator=(const VelocityProcess&) = delete;

  /// Sends a request and returns the answer. Throws the errors of run_filter() if the command ends,
  /// and InputError for an invalid answer.
  std::vector<Vec3> velocities(const std::string& ply, const Moment& moment);

 private:
  void send(const std::string& bytes);
  void receive(char* bytes, std::size_t count);
  std::string line();
  [[noreturn]] void throw_ended();
  void wait_until_ready();
  /// Closes the command's input, waits a second for its end, and ends it if it still runs.
  void end_child();

  std::string command_;
  int socket_ = -1;
  pid_t child_ = 0;
};

}  // namespace transformesh::tool
