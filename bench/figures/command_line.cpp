#include "bench/figures/command_line.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace tuberia::bench {

struct CommandLine::Parser {
  Parser(std::string what_it_does, std::string program) : app(std::move(what_it_does), std::move(program)) {}
  CLI::App app;
};

CommandLine::CommandLine(std::string what_it_does, std::string program)
    : parser_(std::make_unique<Parser>(std::move(what_it_does), std::move(program))) {}
CommandLine::~CommandLine() = default;

void CommandLine::flag(const char* name, bool& value, const char* help) { parser_->app.add_flag(name, value, help); }

void CommandLine::text(const char* name, std::string& value, const char* help) {
  CLI::Option* option = parser_->app.add_option(name, value, help);
  if (!value.empty()) option->capture_default_str();
}

void CommandLine::one_of(const char* name, std::string& value, std::vector<std::string> allowed, const char* help) {
  parser_->app.add_option(name, value, help)->check(CLI::IsMember(std::move(allowed)))->capture_default_str();
}

void CommandLine::whole(const char* name, int& value, int least, int most, const char* help) {
  parser_->app.add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

void CommandLine::number(const char* name, double& value, double least, double most, const char* help) {
  parser_->app.add_option(name, value, help)->check(CLI::Range(least, most))->capture_default_str();
}

void CommandLine::words(const char* name, std::vector<std::string>& values, const char* help, std::vector<std::string> allowed) {
  CLI::Option* option = parser_->app.add_option(name, values, help);
  if (!allowed.empty()) option->check(CLI::IsMember(std::move(allowed)));
}

void CommandLine::exclude(const char* name, const char* other) { parser_->app.get_option(name)->excludes(parser_->app.get_option(other)); }

std::optional<int> CommandLine::parse(int argc, const char* const* argv) {
  try {
    parser_->app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return parser_->app.exit(stop);
  }
  return std::nullopt;
}

}  // namespace tuberia::bench
