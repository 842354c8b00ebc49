// SPDX-License-Identifier: MIT-0
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <thread>

#include "report/escape.h"
#include "report/files.h"
#include "time_limits.h"

namespace grade {
namespace {

constexpr const char* about =
    "Grades exercises: your own,  grade EXERCISE FILE,  or those of a class,\n"
    "  grade --class FOLDER --out FOLDER.";

constexpr const char* codes =
    "A class hands in FOLDER/STUDENT/CHAPTER/EXERCISE.h. Graded again, it skips what is done.\n"
    "Exit codes: 0 graded, whatever the verdict; 2 bad input; 3 the submission cannot be read;\n"
    "  42 the grader failed and will again; 75 it failed, try again.\n"
    "Examples: grade 2-euler/orbit-drift my_euler.h\n"
    "          grade --class submissions/ --seed-file seed.txt --jobs 2 --out results/";

/// The words of the command line, before they are checked.
struct Words {
  std::string exercise, file, out, seed, seed_file, shard, limits, submissions;
  std::string sandbox = "bubblewrap", exit_status = "grader";
  std::vector<std::string> emits, exercises;
  std::string jobs = std::to_string(std::max(1U, std::thread::hardware_concurrency()));
  bool list = false, version = false;
};

void declare(CLI::App& app, Words& words) {
  app.add_option("EXERCISE", words.exercise, "Chapter and exercise, such as 2-euler/orbit-drift");
  app.add_option("FILE", words.file, "The header to grade, or a folder that holds it");
  CLI::Option* const out =
      app.add_option("--out", words.out, "Folder for report.json, feedback.md and plots");
  app.add_option("--emit", words.emits, "Write results.json or junit.xml beside the report")
      ->check(CLI::IsMember({"gradescope", "junit"}))
      ->needs(out);
  CLI::Option* const seed =
      app.add_option("--seed", words.seed, "Number that all hidden inputs come from; 1 is public");
  app.add_option("--seed-file", words.seed_file, "File that holds it")->excludes(seed);
  app.add_option("--sandbox", words.sandbox, "none: only for your own code on your own machine")
      ->check(CLI::IsMember({"bubblewrap", "none"}));
  app.add_option("--exit-status", words.exit_status, "verdict: exit with 1 below full score")
      ->check(CLI::IsMember({"grader", "verdict"}));
  CLI::Option* const whole_class =
      app.add_option("--class", words.submissions, "Grade this folder of submissions")->needs(out);
  app.add_option("--exercise", words.exercises, "Only this one; may be repeated")
      ->needs(whole_class);
  app.add_option("--jobs", words.jobs, "Submissions at a time")->needs(whole_class);
  app.add_option("--shard", words.shard, "i/n: only each n-th submission, from the i-th")
      ->needs(whole_class);
  app.add_flag("--list", words.list, "Name the exercises");
  app.add_flag("--version", words.version, "Say which grader this is, exercise by exercise");
  app.add_option("--limits", words.limits)->group("");
}

std::uint64_t number(const std::string& text, const std::string& option) {
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) {
    throw Usage(option + " takes a whole number below 2^64, not '" + printable_name(text) + "'");
  }
  return value;
}

std::uint64_t seed(const Words& words) {
  if (!words.seed.empty()) return number(words.seed, "--seed");
  if (words.seed_file.empty()) return Request().seed;
  std::optional<std::string> text = read_whole(words.seed_file);
  if (!text) throw Usage("can't read the seed file '" + printable_name(words.seed_file) + "'");
  std::erase_if(*text, [](char c) { return c == '\n' || c == '\r' || c == ' '; });
  // The seed itself may be a secret: what the file holds is not printed.
  try {
    return number(*text, "");
  } catch (const Usage&) {
    throw Usage("the seed file must hold a whole number below 2^64 and nothing else");
  }
}

Exercise exercise_named(const std::string& name) {
  if (const std::optional<Exercise> found = exercise(name)) return *found;
  throw Usage("there is no exercise '" + printable_name(name) + "'; did you mean '" +
              nearest_exercise(name) + "'? --list names all");
}

std::set<Emit> emits(const Words& words) {
  std::set<Emit> all;
  for (const std::string& word : words.emits) {
    all.insert(word == "junit" ? Emit::junit : Emit::gradescope);
  }
  return all;
}

std::filesystem::path folder(const std::string& name) {
  if (std::filesystem::exists(name) && !std::filesystem::is_directory(name)) {
    throw Usage("--out '" + printable_name(name) + "' is a file; name a folder");
  }
  return name;
}

Shard shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = std::min(text.find('/'), text.size() - 1);
  const Shard shard{number(text.substr(0, slash), "--shard"),
                    number(text.substr(slash + 1), "--shard")};
  if (shard.part < 1 || shard.part > shard.of) {
    throw Usage("--shard takes i/n with i from 1 to n, not '" + printable_name(text) + "'");
  }
  return shard;
}

void add_class(Command& command, const Words& words) {
  if (!words.exercise.empty()) throw Usage("--class takes no EXERCISE; choose with --exercise");
  if (words.sandbox == "none") throw Usage("a class is graded in the sandbox only");
  if (words.exit_status == "verdict") throw Usage("--exit-status verdict is for one submission");
  Class& work = command.classroom;
  for (const std::string& name : words.exercises) work.exercises.push_back(exercise_named(name));
  work.submissions = words.submissions;
  work.results = folder(words.out);
  work.seed = seed(words);
  work.seed_file = words.seed_file;
  work.jobs = number(words.jobs, "--jobs");
  if (work.jobs < 1) throw Usage("--jobs must be at least 1");
  work.shard = shard(words.shard);
  work.emits = emits(words);
}

void add_one(Command& command, const Words& words) {
  if (words.exercise.empty()) throw Usage("name an exercise and a file; --help says more");
  command.request.exercise = exercise_named(words.exercise);
  if (words.file.empty()) throw Usage("name the file to grade behind the exercise");
  command.request.submission = words.file;
  command.request.seed = seed(words);
  if (words.sandbox == "none") command.request.sandbox = cage::Sandbox::none;
  if (!words.out.empty()) command.out = folder(words.out);
  command.emits = emits(words);
  command.exit_by_verdict = words.exit_status == "verdict";
  command.limits_given = !words.limits.empty();
  if (command.limits_given && !read_limits(words.limits, command.request)) {
    throw Usage("--limits is for the grader's own use");
  }
}

}  // namespace

Command read_command_line(int argc, char** argv) {
  CLI::App app{about, "grade"};
  app.footer(codes);
  Words words;
  declare(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return {};
  } catch (const CLI::Error& error) {
    throw Usage(printable_name(error.what()));
  }
  Command command;
  if (words.list || words.version) {
    command.what = words.list ? Command::What::list : Command::What::version;
  } else if (!words.submissions.empty()) {
    command.what = Command::What::whole_class;
    add_class(command, words);
  } else {
    command.what = Command::What::one;
    add_one(command, words);
  }
  return command;
}

}  // namespace grade
