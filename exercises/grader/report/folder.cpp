// SPDX-License-Identifier: MIT-0
#include "report/folder.h"

#include "report/feedback.h"
#include "report/files.h"
#include "report/gradescope.h"
#include "report/json.h"
#include "report/junit.h"
#include "report/plot.h"
#include "report/words.h"

namespace grade {
namespace {

constexpr const char* files[] = {"report.json", "feedback.md", "results.json", "junit.xml"};
constexpr const char* plots = "plots";

void write_or_remove(bool wanted, const std::filesystem::path& file, const std::string& text) {
  if (wanted) {
    write_whole(file, text);
  } else {
    std::filesystem::remove(file);
  }
}

void write_rest(const Report& report, const std::filesystem::path& folder,
                const std::set<Emit>& emits, const Place& place) {
  write_whole(folder / "feedback.md", feedback(report, place));
  emit(report, folder, emits);
}

}  // namespace

std::string irregular_file(const std::filesystem::path& folder) {
  for (const char* name : files)
    if (no_file(folder / name)) return name;
  return no_folder(folder / plots) ? plots : "";
}

std::string foreign_file(const std::filesystem::path& folder) {
  if (const std::string other = irregular_file(folder); !other.empty()) return other;
  if (const auto text = read_whole(folder / "report.json"); text && report_from(*text)) return "";
  for (const char* name : files)
    if (std::filesystem::exists(folder / name)) return name;
  const auto drawn = plots_in(folder);
  return drawn.empty() ? "" : std::filesystem::relative(drawn.front(), folder).string();
}

void emit(const Report& report, const std::filesystem::path& folder, const std::set<Emit>& emits) {
  write_or_remove(emits.contains(Emit::gradescope) && is_graded(report), folder / "results.json",
                  gradescope(report));
  write_or_remove(emits.contains(Emit::junit), folder / "junit.xml", junit(report));
}

void keep_provisional(Report report, const std::filesystem::path& folder,
                      const std::set<Emit>& emits) {
  report.verdict = Verdict::grader_error;
  report.why = "The grader was stopped before it came to a verdict. Grade it again.";
  report.try_again = true;
  std::filesystem::create_directories(folder);
  write_whole(folder / "report.json", to_json(report));
  write_rest(report, folder, emits, {});
}

void keep(Report& report, const std::filesystem::path& folder, const std::set<Emit>& emits,
          const Place& place) {
  draw(report, folder);
  write_rest(report, folder, emits, place);
  write_whole(folder / "report.json", to_json(report));
}

}  // namespace grade
