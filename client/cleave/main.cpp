// The program `cleave`.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "cleave/commands/command_line.hpp"
#include "idl/topics.hpp"
#include "libcleave/logging.hpp"

namespace {

using namespace cleave::client;

// Data that did not reach stdout, e.g. for want of room, is a failure.
void flush_stdout() {
  if (!std::cout.flush()) throw std::runtime_error("stdout cannot be written");
}

int run(int argc, char** argv) {
  CLI::App app;
  Action action;
  describe_command_line(app, action);
  app.set_version_flag("--version", cleave::version_text(CLEAVE_VERSION));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_wrong_usage;
  }
  const int code = action();
  flush_stdout();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    cleave::init_logging("cleave");
    return run(argc, argv);
  } catch (const UsageError& error) {
    std::cerr << "cleave: " << error.what() << '\n';
    return exit_wrong_usage;
  } catch (const std::exception& error) {
    std::cerr << "cleave: " << error.what() << '\n';
    return exit_failed;
  }
}
