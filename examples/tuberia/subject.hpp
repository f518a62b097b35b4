#pragma once
// What a command looks at: a model file, or a built-in model.

#include "examples/tuberia/picture_options.hpp"

namespace tuberia::cli {

struct Subject {
  std::string caption;
  Model model;
  RenderOptions options;
};

/// The arguments that name it.
struct SubjectArguments {
  std::string model, demo;
  PictureArguments picture;
  const CLI::App* command = nullptr;
};

void add_subject(CLI::App& command, SubjectArguments& arguments);

/// Error unless one of the two is named and can be read. Warnings of the loader go to the error output.
Result<Subject> subject_of(const SubjectArguments& arguments);

}  // namespace tuberia::cli
