// SPDX-License-Identifier: MIT-0
// write_samples FOLDER: a kept report of every verdict, to be held against the published formats.
#include "report/folder.h"
#include "sample.h"

int main(int, char** argv) {
  const std::set<grade::Emit> both{grade::Emit::gradescope, grade::Emit::junit};
  const std::filesystem::path folder = argv[1];
  for (int code = 0; code <= int(grade::Verdict::grader_error); ++code) {
    grade::Report report = code % 2 == 0 ? sample() : hostile_sample();
    report.verdict = grade::Verdict(code);
    if (report.verdict == grade::Verdict::rejected) report.sha256.clear(), report.tests.clear();
    if (report.verdict == grade::Verdict::time_limit) report.seconds = NAN;
    const std::filesystem::path out = folder / std::string(name(report.verdict));
    std::filesystem::create_directories(out);
    keep(report, out, both);
  }
  keep_provisional(sample(), folder / "provisional", both);
}
