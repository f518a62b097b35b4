#include "bench/trade/plots.hpp"
#include "bench/trade/report.hpp"
#include "bench/trade/tables.hpp"

namespace tuberia::bench::trade {
namespace {

constexpr const char* kAboutStages =
    R"(Time is the median, over rounds in which every setting is timed once, of the ratio
to the reference's time; half of the rounds lie between the quartiles. A ring is the reference, the step line the Pareto
front: left of it and below it there is nothing. Small points are single scenes, large ones their means.)";

constexpr const char* kAboutScenes =
    R"(All combinations of the switches that matter to a scene, 640 x 360 pixels, against
64 samples a pixel of the reference's setting. With one sample a pixel, edges are most of the error: that is what the
uppermost points have in common.)";

constexpr const char* kAboutFigures = R"(Figures that are known of each trade [rules 4], the same by a closed form or a
sum over all cases, and what the machine does.)";

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string sentence_start(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string thumbnail_of(const WholeResult& whole) {
  if (whole.picture_file.empty()) return {};
  return "<div><img src=\"" + escaped(whole.picture_file) + "\" alt=\"" + escaped(whole.scene) +
         "\" style=\"max-width:100%\"></div>\n";
}

std::string how_measured(const Circumstances& circumstances) {
  std::string text = escaped(sentence_of(circumstances.machine)) + ". " +
                     std::string(name_of(circumstances.pipeline.instruction_set)) + ", " +
                     std::to_string(circumstances.pipeline.threads) +
                     (circumstances.pipeline.threads == 1 ? " thread. " : " threads. ");
  if (circumstances.is_quick) text += "<span class=\"alarm\">A quick run: not to be quoted.</span> ";
  return text;
}

}  // namespace

Page page_of(const TradeResult& result, const Circumstances& circumstances) {
  Page page("Speed for accuracy", how_measured(circumstances) + kAboutStages);
  if (!result.scenes.empty())
    page.add_section("Whole scenes", paragraph(kAboutScenes) + figure_of(plot_of(result.scenes)));
  for (const WholeResult& whole : result.scenes)
    page.add_section("Whole scene: " + whole.scene,
                     paragraph(escaped(sentence_start(whole.what)) + ". Below: the front and the reference.") +
                         "<div class=\"row\">\n" + figure_of(plot_of(whole)) + thumbnail_of(whole) + "</div>\n" +
                         html_of(table_of(whole)));
  for (const StageResult& stage : result.stages)
    page.add_section(stage.title, paragraph(stage.what) + figure_of(plot_of(stage)) + html_of(table_of(stage)));
  page.add_section("Figures that are known", paragraph(kAboutFigures) + html_of(table_of(known_figures(result))));
  return page;
}

std::string markdown_of(const TradeResult& result, const Circumstances& circumstances) {
  std::string text = "# Speed for accuracy\n\n" + sentence_of(circumstances.machine) + "\n";
  for (const StageResult& stage : result.stages) text += "\n## " + stage.title + "\n\n" + markdown_of(table_of(stage));
  for (const WholeResult& whole : result.scenes)
    text += "\n## Whole scene: " + whole.scene + "\n\n" + markdown_of(table_of(whole));
  return text + "\n## Figures that are known\n\n" + markdown_of(table_of(known_figures(result)));
}

}  // namespace tuberia::bench::trade
