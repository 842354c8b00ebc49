// SPDX-License-Identifier: MIT-0
#include "home/play_page.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <regex>

#include "class/page_style.h"
#include "command_line.h"
#include "home/plot_film.h"
#include "printable.h"
#include "report/escape.h"
#include "report/files.h"
#include "report/plot.h"
#include "report/shortened.h"
#include "report/words.h"
#include "task.h"

namespace grade {
namespace {

constexpr const char* made_by = "<!-- made by grade play -->";

constexpr const char* film_style = R"css(
iframe { display: block; width: 100%; border: 0; margin: 1rem 0; }
main { max-width: 46rem; }
dt { color: var(--soft); font-size: .85rem; }
dd { margin: 0 0 .6rem; white-space: pre-wrap; overflow-wrap: anywhere; }
.key { font-size: .9rem; }
.key b { color: var(--yours); }
.key i { color: var(--ink); font-style: normal; }
)css";

/// The student's colour is the film's, whose player names it for light and for dark.
std::string key_style() {
  const std::string player = play::player_tail;
  const std::regex colour("'yours': '(#[0-9a-f]+)'");
  const std::sregex_iterator light(player.begin(), player.end(), colour), dark = std::next(light);
  return ":root { --yours: " + light->str(1) +
         "; }\n@media (prefers-color-scheme: dark) { :root { --yours: " + dark->str(1) + "; } }\n";
}

/// A film grows to the height that it needs.
constexpr const char* fit_films = R"js(<script>
for (const frame of document.querySelectorAll('iframe')) {
  const fit = () => (frame.style.height = `${frame.contentDocument.documentElement.scrollHeight}px`);
  frame.addEventListener('load', () => (fit(), new ResizeObserver(fit).observe(frame.contentDocument.body)));
}
</script>
)js";

std::string frame(const Stage& stage, const std::string& title) {
  return "<iframe title=\"" + html(title) + "\" srcdoc=\"" + html_to_the_letter(stage.page()) +
         "\"></iframe>\n";
}

/// In the order, and the colours, in which film_of() draws them.
std::string key(const Plot& plot) {
  constexpr std::array marks{"b", "i", "span"};
  std::string text;
  for (std::size_t n = 0; n < plot.curves.size(); ++n) {
    const std::string mark = marks[std::min(n, marks.size() - 1)];
    text += "<" + mark + ">●</" + mark + "> " + html(plot.curves[n].name) + " ";
  }
  return "<p class=\"key\">" + text + "</p>\n";
}

std::string failing_run(const TestResult& test) {
  std::string text = "<h2>" + html(test.name) + "</h2>\n<p>This did not hold.</p>\n";
  for (const Finding& finding : test.findings) {
    if (finding.held) continue;
    if (can_be_drawn(finding.plot)) {
      text += "<p>" + html(finding.plot.title) + "</p>\n" +
              frame(film_of(finding.plot), finding.plot.title) + key(finding.plot);
    }
    text += "<dl>\n";
    for (const Line& line : lines(finding))
      text += "<dt>" + html(line.label) + "</dt><dd>" + html(shortened(line.text)) + "</dd>\n";
    text += "</dl>\n";
  }
  return text;
}

}  // namespace

std::string play_page(const Played& played, const Report& report) {
  std::string text;
  if (!played.why.empty()) text += "<p>It came no further: " + html(played.why) + "</p>\n";
  text += "<p>" + html(headline(report)) + "</p>\n";
  const auto failed = std::ranges::find_if(report.tests, has_failed);
  if (failed != report.tests.end()) text += failing_run(*failed);
  return film_page(task(*exercise(report.exercise)).title, played.scene.caption, played.stage,
                   text);
}

std::string film_page(const std::string& title, const std::string& caption, const Stage& stage,
                      const std::string& body) {
  return "<!doctype html>\n" + std::string(made_by) +
         "\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         html(title) + "</title>\n<style>" + page_style + film_style + key_style() +
         "</style>\n<main>\n<h1>" + html(title) + "</h1>\n<p>" + html(caption) + "</p>\n" +
         frame(stage, title) + "<p class=\"key\"><b>●</b> yours <i>●</i> as it should be</p>\n" +
         body + "</main>\n" + fit_films + "</html>\n";
}

void refuse_foreign_page(const std::filesystem::path& page) {
  const auto there = read_whole(page);
  if (there && there->find(made_by) == std::string::npos)
    throw Usage("'" + printable_name(page.string()) +
                "' is there already, and is not the grader's own; move it away");
}

}  // namespace grade
