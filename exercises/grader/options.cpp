// SPDX-License-Identifier: MIT-0
#include "options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "command_line.h"
#include "printable.h"

namespace grade {
namespace {

constexpr const char* about =
    "Grades exercises: your own,  grade FILE,  or those of a class,\n"
    "  grade --class FOLDER --out FOLDER.\n"
    "Without any word it grades what you save in this folder, as often as you save it.";

constexpr const char* codes =
    "A class hands in FOLDER/STUDENT/CHAPTER/EXERCISE.h. Graded again, it skips what is done.\n"
    "Exit codes: 0 graded, whatever the verdict, or run or played, and 1 where that did not come\n"
    "  to a good end; 2 bad input; 3 the submission is not there or may not be read, while a pipe "
    "or\n"
    "  another thing that is no file is REJECTED;\n"
    "  42 the grader failed and will again; 75 it failed, try again.\n"
    "Examples: grade start orbit-drift\n"
    "          grade orbit-drift.h\n"
    "          grade 2-euler/orbit-drift my_euler.h\n"
    "          grade --class submissions/ --seed-file seed.txt --jobs 2 --out results/\n"
    "          grade class course.toml --round week-2\n"
    "          grade collect moodle unpacked/ submissions/week-2 --worksheet Grades.csv\n"
    "          grade hand-back moodle Grades.csv results/week-2";

struct Word {
  What what;
  const char *word, *first, *second, *about;  ///< what stands behind it, if anything
  bool needs_first;
  const char* third = nullptr;  ///< with which it needs all three
};

constexpr Word words[] = {
    {What::start, "start", "EXERCISE", "FOLDER", "Put an exercise's starter here, or into a folder",
     true},
    {What::list, "list", "PART", nullptr,
     "Name exercises, all or by a part of a name, and what is done", false},
    {What::hint, "hint", "EXERCISE", nullptr, "Show the exercise's next hint", true},
    {What::run, "run", "FILE", nullptr,
     "Run a header's own main and show what it prints: not graded", true},
    {What::play, "play", "FILE", "FOLDER",
     "Write a page in which a header's code moves; level: all of it", true},
    {What::ways, "ways", "EXERCISE", nullptr, "Show other right ways, once you have full marks",
     true},
    {What::seal, "seal", "EXERCISE", nullptr, "", true},
    {What::course, "class", "COURSE.toml", nullptr,
     "Grade the assignments of the course that this file describes", true},
    {What::collect, "collect", "KIND", "FROM",
     "Bring in what moodle, canvas, git or folders hand out", true, "TO"},
    {What::hand_back, "hand-back", "KIND", "TABLE", "Fill marks into a table of moodle or canvas",
     true, "RESULTS"},
    {What::gradescope, "gradescope", "REPORTS", "RESULTS.json", "", true},
    {What::classroom, "classroom", "REPORTS", "RESULT.json", "", true},
    {What::check, "check", nullptr, nullptr, "Try what grading needs on this machine", false},
};

void declare_words(CLI::App& app, Options& options) {
  for (const Word& each : words) {
    CLI::App* const word = app.add_subcommand(each.word, each.about)->fallthrough();
    if (*each.about == '\0') word->group("");  // not for students
    word->final_callback([&options, &each] {
      options.word = each.what;
      options.said = each.word;
    });
    if (each.first) word->add_option(each.first, options.first)->required(each.needs_first);
    if (each.second) word->add_option(each.second, options.second)->required(each.third != nullptr);
    if (each.third) word->add_option(each.third, options.third)->required();
  }
}

void declare(CLI::App& app, Options& options) {
  app.add_option("EXERCISE", options.exercise, "Chapter and exercise, such as 2-euler/orbit-drift");
  app.add_option("FILE", options.file, "The header to grade, or a folder that holds it");
  CLI::Option* const out =
      app.add_option("--out", options.out, "Folder for report.json, feedback.md and plots");
  app.add_option("--emit", options.emits, "Write results.json or junit.xml beside the report")
      ->check(CLI::IsMember({"gradescope", "junit"}))
      ->allow_extra_args(false)
      ->take_all()
      ->needs(out);
  CLI::Option* const seed = app.add_option("--seed", options.seed,
                                           "Number that all hidden inputs come from; 1 is public");
  app.add_option("--seed-file", options.seed_file, "File that holds it")->excludes(seed);
  app.add_option("--sandbox", options.sandbox, "none: only for your own code on your own machine")
      ->check(CLI::IsMember({"bubblewrap", "none", "auto"}));
  app.add_option("--exit-status", options.exit_status, "verdict: exit with 1 below full score")
      ->check(CLI::IsMember({"grader", "verdict"}));
  CLI::Option* const whole_class =
      app.add_option("--class", options.submissions, "Grade this folder of submissions")
          ->needs(out);
  app.add_option("--exercise", options.exercises, "Only this one; may be repeated")
      ->allow_extra_args(false)
      ->take_all()
      ->needs(whole_class);
  app.add_option("--assigned", options.assigned,
                 "File with a line for each exercise that all have to hand in")
      ->needs(whole_class);
  app.add_option("--jobs", options.jobs, "Submissions at a time, of a student one");
  app.add_option("--shard", options.shard, "i/n: only each n-th submission, from the i-th");
  app.add_option("--round", options.round, "Only this assignment of a course");
  app.add_option("--course", options.course, "By whose round commits are collected: its file");
  app.add_option("--until", options.until, "Time of the end, with its offset, to collect by");
  app.add_option("--worksheet", options.worksheet, "Moodle's, that knows when, and who");
  app.add_option("--column", options.column, "Of Canvas's gradebook, to hand back into");
  app.add_flag("--all", options.all, "Show each test that failed in full");
  app.add_flag("--version", options.version, "Say which grader this is, exercise by exercise");
  app.add_option("--limits", options.limits)->group("");
  app.add_flag("--unchecked", options.unchecked)->group("");
}

/// Words as they were written before they were words: `--list`, `PART --list`, `--run FILE`.
struct Old {
  bool list = false;
  std::string run;

  void declare(CLI::App& app) {
    app.add_flag("--list", list)->group("");
    app.add_option("--run", run)->group("");
  }

  void put_into(Options& options) const {
    if (list) {
      options.word = What::list;
      options.said = "list";
      options.first = std::exchange(options.exercise, "");
    } else if (!run.empty()) {
      options.word = What::run;
      options.said = "run";
      options.first = run;
    }
  }
};

}  // namespace

std::optional<Options> read_options(int argc, char** argv) {
  CLI::App app{about, "grade"};
  app.footer(codes);
  Options options;
  Old old;
  declare(app, options);
  declare_words(app, options);
  old.declare(app);
  if (argc == 2 && std::string_view(argv[1]) == "help") argv[1] = const_cast<char*>("--help");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return {};
  } catch (const CLI::Error& error) {
    throw Usage(printable_name(error.what()));
  }
  for (const CLI::Option* option : app.get_options()) {
    const auto& values = option->results();
    if (std::ranges::find(values, "") != values.end())
      throw Usage(option->get_name() + " needs a value; '' is none");
  }
  old.put_into(options);
  return options;
}

}  // namespace grade
