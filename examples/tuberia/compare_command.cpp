// tuberia compare A B

#include <cmath>
#include <cstdio>
#include <memory>

#include "examples/tuberia/commands.hpp"
#include "image/compare.hpp"
#include "image/read_image.hpp"
#include "image/write_image.hpp"

namespace tuberia::cli {
namespace {

struct CompareArguments {
  std::string first, second, difference;
};

int run_compare(const CompareArguments& arguments) {
  const auto first = read_image(arguments.first);
  if (!first) return fail(first.error().message);
  const auto second = read_image(arguments.second);
  if (!second) return fail(second.error().message);
  const auto result = compare(*first, *second);
  if (!result) return fail(arguments.first + " and " + arguments.second + ": " + result.error().message);
  if (!arguments.difference.empty())
    if (const auto written = write_image(arguments.difference, difference_image(*first, *second)); !written)
      return fail(written.error().message);

  std::printf("%s\n", result->equal ? "equal" : "different");
  std::printf("largest difference  %d codes\n", result->largest_difference);
  std::printf("differing pixels    %lld of %lld\n", static_cast<long long>(result->differing_pixels),
              static_cast<long long>(first->pixels().size()));
  if (std::isinf(result->psnr_db)) std::printf("PSNR                infinite\n");
  else std::printf("PSNR                %.2f dB\n", result->psnr_db);
  std::printf("SSIM                %.6f\n", result->ssim);
  std::printf("CIEDE2000           mean %.4f, largest %.4f\n", result->mean_ciede2000, result->largest_ciede2000);
  return result->equal ? kFine : kDifferent;
}

}  // namespace

Run add_compare(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<CompareArguments>();
  command = parent.add_subcommand("compare", "Say how two pictures differ; exit status 1 when they do");
  command->add_option("first", arguments->first, "Picture")->required();
  command->add_option("second", arguments->second, "Picture")->required();
  command->add_option("--diff", arguments->difference, "Write a picture of the differences");
  return [arguments] { return run_compare(*arguments); };
}

}  // namespace tuberia::cli
