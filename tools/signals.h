/// Being interrupted: files half written disappear, the terminal's line is cleared, and the
/// exit code says which signal it was. Everything here is async-signal-safe where it has to be.
#pragma once

#include <string>

namespace transformesh::tool {

/// Opens unusable descriptors in place of closed standard ones, so that no file takes their number.
void occupy_standard_descriptors();

/// SIGINT, SIGTERM, SIGPIPE, SIGXCPU and, unless nohup has it ignored, SIGHUP end the process at
/// once with 128 + their number and remove its temporary files. SIGXFSZ is ignored: the write that
/// grew too large fails and tells.
void install_signal_handlers();

/// From now on SIGINT, SIGTERM and SIGHUP are told: `tm-x: interrupted by SIGINT` and the advice.
void tell_interruption(const std::string& program, const std::string& advice);

/// Whether a progress bar stands on the terminal's current line.
void set_bar_is_visible(bool is_visible);

}  // namespace transformesh::tool
