// tuberia: models to pictures on the command line.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "examples/tuberia/commands.hpp"

namespace tuberia::cli {

int fail(const std::string& message) {
  std::fprintf(stderr, "tuberia: %s\n", message.c_str());
  return kFailed;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Tuberia: a fixed-function GPU in software", "tuberia"};
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "The help of all commands");
  app.option_defaults()->always_capture_default();

  std::vector<std::pair<CLI::App*, Run>> commands;
  for (const auto add : {&add_render, &add_gallery, &add_compare, &add_info, &add_stages, &add_trace, &add_requirements, &add_witness}) {
    CLI::App* command = nullptr;
    Run body = add(app, command);
    commands.emplace_back(command, std::move(body));
  }
  // The parser would only say that a command is required.
  const std::string first = argc > 1 ? argv[1] : "";
  const auto is_named = [&](const auto& command) { return command.first->get_name() == first; };
  if (!first.empty() && first[0] != '-' && std::none_of(commands.begin(), commands.end(), is_named))
    return fail("there is no command '" + first + "'; see tuberia --help");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(error.what());
  }
  for (const auto& [command, body] : commands)
    if (command->parsed()) return body();
  return kFailed;
}

}  // namespace
}  // namespace tuberia::cli

int main(int argc, char** argv) {
  try {
    return tuberia::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return tuberia::cli::fail("out of memory");
  } catch (const std::exception& error) {
    return tuberia::cli::fail(error.what());
  }
}
