// tuberia stages MODEL: every stage opened to the eye.

#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/stage_text.hpp"
#include "examples/tuberia/stages_page.hpp"
#include "examples/tuberia/subject.hpp"
#include "image/file.hpp"

namespace tuberia::cli {
namespace {

struct StagesArguments {
  std::string pixel, page;
  std::optional<std::int64_t> primitive;
  std::optional<int> draw;
  int fragments = 3;
  bool json = false;
  SubjectArguments subject;
  PipelineArguments pipeline;
};

/// "320,180" to a place.
Result<PixelPlace> parse_pixel(const std::string& text) {
  PixelPlace place;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, place.x);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ',') {
    const auto second = std::from_chars(first.ptr + 1, end, place.y);
    if (second.ec == std::errc{} && second.ptr == end) return place;
  }
  return Error{"--pixel: '" + text + "' is not a pixel like 320,180"};
}

Result<StageRequest> request_of(const StagesArguments& arguments) {
  StageRequest request;
  request.primitive = arguments.primitive;
  request.draw = arguments.draw;
  if (arguments.pixel.empty()) return request;
  const auto pixel = parse_pixel(arguments.pixel);
  if (!pixel) return pixel.error();
  request.pixel = *pixel;
  return request;
}

Result<Nothing> write_page(const std::string& path, const StageReport& report, const Model& model) {
  const std::string page = stages_page(report, model);
  return write_file(path, std::as_bytes(std::span(page)));
}

void print(const StageReport& report, const StagesArguments& arguments) {
  // A pixel alone asks for its history, not for the primitive that happens to be seen there.
  const bool primitive = !report.pixel || arguments.primitive || arguments.draw;
  if (arguments.json) {
    nlohmann::ordered_json both;
    if (primitive) both["primitive"] = primitive_json(report);
    if (report.pixel) both["pixel"] = pixel_json(report);
    std::printf("%s\n", both.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
    return;
  }
  if (primitive) std::fputs(primitive_text(report, arguments.fragments).c_str(), stdout);
  if (report.pixel) std::fputs(((primitive ? "\n" : "") + pixel_text(report)).c_str(), stdout);
}

int run_stages(const StagesArguments& arguments) {
  const auto pipeline_options = options_of(arguments.pipeline);
  if (!pipeline_options) return fail(pipeline_options.error().message);
  const auto request = request_of(arguments);
  if (!request) return fail(request.error().message);
  const auto subject = subject_of(arguments.subject);
  if (!subject) return fail(subject.error().message);

  Pipeline pipeline(*pipeline_options);
  auto report = stage_report(subject->model, subject->options, *request, pipeline);
  if (!report) return fail(report.error().message);
  report->caption = subject->caption;
  if (arguments.page.empty()) {
    print(*report, arguments);
    return kFine;
  }
  if (const auto written = write_page(arguments.page, *report, subject->model); !written) return fail(written.error().message);
  std::printf("%s: open it in a browser\n", arguments.page.c_str());
  return kFine;
}

}  // namespace

Run add_stages(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<StagesArguments>();
  command = parent.add_subcommand("stages", "Show what every stage makes of one primitive, and the history of a pixel");
  add_subject(*command, arguments->subject);
  command->add_option("--primitive", arguments->primitive,
                      "Its number, counted from 0 through all draws of the frame, or in --draw; by default the one seen in the middle");
  command->add_option("--draw", arguments->draw, "Number of a draw; each mesh of a model is one, translucent ones last");
  command->add_option("--pixel", arguments->pixel, "X,Y: everything that happened to this pixel, in order");
  command->add_option("--fragments", arguments->fragments, "How many of the primitive's fragments to list")->check(CLI::Range(0, 100000));
  command->add_flag("--json", arguments->json, "The same numbers as JSON");
  command->add_option("--html", arguments->page, "Write a page instead that shows all stages; it needs nothing but a browser")
      ->excludes("--json");
  add_picture_options(*command, arguments->subject.picture);
  add_pipeline_options(*command, arguments->pipeline);
  return [arguments] { return run_stages(*arguments); };
}

}  // namespace tuberia::cli
