// tuberia requirements MODEL: what each of its draws needs of the pipeline, and why.

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/subject.hpp"
#include "scene/closed_mesh.hpp"
#include "scene/requirements.hpp"

namespace tuberia::cli {
namespace {

using Json = nlohmann::ordered_json;

struct RequirementsArguments {
  SubjectArguments subject;
  bool json = false;
};

/// What is found out of one draw.
struct Examined {
  const DrawCall* draw;
  Requirements requirements;
  bool is_closed;

  bool could_cull() const { return is_closed && !requirements.needs(Feature::culling) && !requirements.needs(Feature::blending); }
};

std::vector<Examined> examine(const Frame& frame) {
  std::vector<Examined> all;
  for (const DrawCall& draw : frame.draws) all.push_back({&draw, requirements_of(draw, frame.target.description()), is_closed(draw)});
  return all;
}

std::string program_of(const DrawCall& draw) { return std::string(draw.program.interface().name); }

void print_features(const Requirements& requirements, bool needed) {
  std::printf("  %s\n", needed ? "needed" : "not needed");
  for (const Requirement& r : requirements.features) {
    if (r.is_needed != needed) continue;
    const bool is_turned_off = !needed && r.was_on && r.feature != Feature::drawing && r.feature != Feature::vertex_attributes && r.feature != Feature::clipping;
    std::printf("    %-20s%s%s\n", std::string(name_of(r.feature)).c_str(), is_turned_off ? "Turned off. " : "", r.reason.c_str());
  }
}

void print(const Examined& one, std::size_t number) {
  const Requirements& requirements = one.requirements;
  std::printf("\ndraw %zu: %s triangles, program %s\n", number, with_commas(static_cast<std::int64_t>(one.draw->mesh.element_count() / 3)).c_str(),
              program_of(*one.draw).c_str());
  if (!requirements.needs(Feature::drawing)) {
    std::printf("  need not be drawn: %s\n", requirements[Feature::drawing].reason.c_str());
    return;
  }
  print_features(requirements, true);
  print_features(requirements, false);
  std::printf("  the smallest pipeline: program %s, with %s at each vertex\n", program_of(requirements.smallest).c_str(),
              requirements.attributes == Attributes::none ? "no attributes" : words_of(requirements.attributes).c_str());
  if (one.could_cull())
    std::printf("  the mesh is closed: with --cull the triangles that face away, about half, would be left out; pixels could change only\n"
                "  where a face that is turned away has the depth of one before it, along outlines\n");
}

Json json_of(const Examined& one, std::size_t number) {
  const Requirements& requirements = one.requirements;
  Json features = Json::array();
  for (const Requirement& r : requirements.features)
    features.push_back({{"feature", name_of(r.feature)}, {"needed", r.is_needed}, {"was_on", r.was_on}, {"reason", r.reason}});
  return {{"draw", number}, {"triangles", one.draw->mesh.element_count() / 3}, {"program", program_of(*one.draw)},
          {"smallest_program", program_of(requirements.smallest)}, {"attributes", words_of(requirements.attributes)},
          {"scalars_a_vertex", scalar_count(requirements.attributes)}, {"is_closed", one.is_closed}, {"features", features}};
}

int run_requirements(const RequirementsArguments& arguments) {
  const auto subject = subject_of(arguments.subject);
  if (!subject) return fail(subject.error().message);
  const auto frame = prepare(subject->model, subject->options);
  if (!frame) return fail(subject->caption + ": " + frame.error().message);
  const std::vector<Examined> all = examine(*frame);
  if (arguments.json) {
    Json draws = Json::array();
    for (std::size_t i = 0; i < all.size(); ++i) draws.push_back(json_of(all[i], i));
    const Json json{{"scene", subject->caption}, {"width_pixels", frame->target.width()}, {"height_pixels", frame->target.height()}, {"draws", draws}};
    std::printf("%s\n", json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    return kFine;
  }
  std::printf("%s: %s triangles in %zu %s, %dx%d pixels\n", subject->caption.c_str(), with_commas(subject->model.triangle_count()).c_str(), all.size(),
              all.size() == 1 ? "draw" : "draws", frame->target.width(), frame->target.height());
  for (std::size_t i = 0; i < all.size(); ++i) print(all[i], i);
  return kFine;
}

}  // namespace

Run add_requirements(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<RequirementsArguments>();
  command = parent.add_subcommand("requirements", "Tell what a model's draws need of the pipeline, what not, and why");
  add_subject(*command, arguments->subject);
  command->add_flag("--json", arguments->json, "The same as JSON");
  add_picture_options(*command, arguments->subject.picture);
  return [arguments] { return run_requirements(*arguments); };
}

}  // namespace tuberia::cli
