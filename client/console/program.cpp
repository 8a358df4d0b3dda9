// SPDX-License-Identifier: BSD-3-Clause
#include "console/program.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "idl/topics.hpp"
#include "libcleave/process/logging.hpp"
#include "recording/error.hpp"

namespace cleave {
namespace {

int parse_and_run(int argc, char** argv, std::string_view version, DescribeCommandLine describe) {
  CLI::App app;
  Action action;
  describe(app, action);
  app.set_version_flag("--version", version_text(version));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_wrong_usage;
  }
  const int code = action();
  if (!std::cout.flush()) throw std::runtime_error("stdout cannot be written");
  return code;
}

int failed(const std::exception& error, int code) {
  std::cerr << "cleave: " << error.what() << '\n';
  return code;
}

}  // namespace

int run_program(const Action& program) {
  try {
    init_logging("cleave");
    return program();
  } catch (const UsageError& error) {
    return failed(error, exit_wrong_usage);
  } catch (const recording::UnknownInput& error) {
    return failed(error, exit_wrong_usage);
  } catch (const std::exception& error) {
    return failed(error, exit_failed);
  }
}

int run_command_line(int argc, char** argv, std::string_view version,
                     DescribeCommandLine describe) {
  return run_program([&] { return parse_and_run(argc, argv, version, describe); });
}

}  // namespace cleave
