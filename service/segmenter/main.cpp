// SPDX-License-Identifier: BSD-3-Clause
// cleave-segmenter: clouds in, label maps and segment lists out.
#include <spdlog/spdlog.h>

#include <exception>
#include <stdexcept>
#include <variant>

#include "config/section.hpp"
#include "libcleave/process/exit_codes.hpp"
#include "libcleave/process/logging.hpp"
#include "libcleave/process/restart.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/roudi.hpp"
#include "segmenter/command_line.hpp"
#include "segmenter/daemon.hpp"
#include "segmenter/settings.hpp"

namespace {

using namespace cleave::service;

// The daemon, and with it every reader and writer, is gone when this returns.
Ending run(const CommandLine& line, cleave::Shutdown& shutdown) {
  return Daemon(read_settings(line), shutdown).run(shutdown);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    cleave::init_logging("cleave-segmenter");
    const std::variant<CommandLine, int> parsed = parse_command_line(count, arguments);
    if (const int* const code = std::get_if<int>(&parsed)) return *code;
    cleave::Shutdown shutdown;
    if (run(std::get<CommandLine>(parsed), shutdown) == Ending::start_anew) {
      if (const pid_t roudi = shutdown.roudi()) cleave::leave_roudi(roudi);
      cleave::restart_in_place(arguments);
    }
    return cleave::exit_done;
  } catch (const cleave::config::ConfigurationError& error) {
    spdlog::error("{}", error.what());
    return cleave::exit_wrong_usage;
  } catch (const std::invalid_argument& error) {
    spdlog::error("{}", error.what());
    return cleave::exit_wrong_usage;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return cleave::exit_failed;
  }
}
