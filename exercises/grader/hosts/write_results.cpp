// SPDX-License-Identifier: MIT-0
#include "hosts/write_results.h"

#include "command_line.h"
#include "exit_codes.h"
#include "printable.h"
#include "report/files.h"
#include "report/json.h"

namespace grade {

int write_results(const std::filesystem::path& reports, const std::filesystem::path& results,
                  std::string (*format)(const std::vector<Report>& all)) {
  std::vector<Report> all;
  for (const Exercise& one : exercises()) {
    const auto text = read_whole(reports / one.name / "report.json");
    if (const auto report = text ? report_from(*text) : std::nullopt) all.push_back(*report);
  }
  if (all.empty())
    throw Usage("there is no report in '" + printable_name(reports.string()) +
                "'; grade EXERCISE FILE --out REPORTS/EXERCISE makes one");
  const int code = exit_code(all);
  if (code != Exit::graded) return refuse(code, "the grader failed; nobody has lost a point by it");
  write_whole(results, format(all));
  return Exit::graded;
}

}  // namespace grade
