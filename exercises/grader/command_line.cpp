// SPDX-License-Identifier: MIT-0
#include "command_line.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <system_error>
#include <thread>

#include "given_files.h"
#include "options.h"
#include "printable.h"
#include "time_limits.h"
#include "without_a_cage.h"

namespace grade {
namespace {

std::uint64_t seed(const Options& options) {
  if (!options.seed.empty()) {
    if (const auto given = whole_number(options.seed)) return *given;
    throw Usage("--seed takes a whole number below 2^64, not '" + printable_name(options.seed) +
                "'");
  }
  if (options.seed_file.empty()) return Request().seed;
  return seed_in(options.seed_file);
}

[[noreturn]] void no_exercise(const std::string& name) {
  throw Usage("there is no exercise '" + printable_name(name) + "'; did you mean '" +
              nearest_exercise(name) + "'? grade list names all");
}

Exercise exercise_named(const std::string& name) {
  if (const std::optional<Exercise> found = exercise(name)) return *found;
  no_exercise(name);
}

/// By its name, with or without the chapter, or by that of its header, wherever it lies.
Exercise exercise_meant(const std::string& name) {
  if (const std::optional<Exercise> found = exercise(name)) return *found;
  const std::filesystem::path path = name;
  std::string file = path.filename().string();
  if (!file.ends_with(".h")) file += ".h";
  const std::vector<Exercise> all = exercises();
  const auto found = std::ranges::find(all, file, &Exercise::header);
  if (found != all.end()) return *found;
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    throw Usage("'" + printable_name(name) + "' is a folder; go there, and call grade alone");
  if (std::filesystem::exists(path, none))
    throw Usage("'" + printable_name(name) +
                "' has no exercise's name; name the exercise before it: grade EXERCISE FILE");
  no_exercise(name);
}

/// A header of one's own, by its place or by its exercise's name, if it lies here.
void add_own(Command& command, const std::string& name) {
  command.request.exercise = exercise_meant(name);
  command.request.submission = name;
  std::error_code none;
  if (std::filesystem::exists(name, none)) return;
  command.request.submission = command.request.exercise.header();
  if (std::filesystem::path(name).extension() == ".h") command.request.submission = name;
  if (!std::filesystem::exists(command.request.submission, none) && !name.ends_with(".h"))
    throw Usage("name the file to grade behind the exercise; there is no " +
                command.request.exercise.header() + " here");
}

std::set<Emit> emits(const Options& options) {
  std::set<Emit> all;
  for (const std::string& word : options.emits) {
    all.insert(word == "junit" ? Emit::junit : Emit::gradescope);
  }
  return all;
}

std::filesystem::path folder(const std::string& name) {
  std::filesystem::path there = std::filesystem::absolute(name);
  std::error_code none;
  const auto missing = [&] {
    const auto found = std::filesystem::status(there, none);
    return !std::filesystem::exists(found) && there.has_relative_path();
  };
  while (missing()) there = there.parent_path();
  if (std::filesystem::is_directory(there, none)) return name;
  const bool above = there != std::filesystem::absolute(name);
  throw Usage("--out '" + printable_name(name) + "' is " + (above ? "below " : "") +
              "a file; name a folder");
}

Shard shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = std::min(text.find('/'), text.size() - 1);
  const Shard shard{whole_number(text.substr(0, slash)).value_or(0),
                    whole_number(text.substr(slash + 1)).value_or(0)};
  if (shard.part < 1 || shard.part > shard.of) {
    throw Usage("--shard takes i/n with i from 1 to n, not '" + printable_name(text) + "'");
  }
  return shard;
}

/// Each once, however often it is named.
void add(std::vector<Exercise>& all, const std::string& name) {
  if (std::ranges::find(all, name, &Exercise::name) == all.end())
    all.push_back(exercise_named(name));
}

/// A line for each exercise; what stands behind # is a remark.
std::vector<Exercise> assigned(const std::string& file) {
  const std::optional<std::string> text = small_file(file);
  if (!text)
    throw Usage("can't read the file of what was assigned, '" + printable_name(file) + "'");
  std::vector<Exercise> all;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string name; words >> name;) add(all, name);
  }
  if (all.empty())
    throw Usage("'" + printable_name(file) + "' names no exercise; write one on each line");
  return all;
}

std::size_t jobs(const std::string& text) {
  constexpr std::uint64_t most = 1000;
  if (text.empty()) return std::max(1U, std::thread::hardware_concurrency());
  const std::uint64_t asked = whole_number(text).value_or(0);
  if (asked >= 1 && asked <= most) return asked;
  throw Usage("--jobs takes a whole number from 1 to " + std::to_string(most) + ", not '" +
              printable_name(text) + "'");
}

void add_class(Command& command, const Options& options) {
  if (!options.exercise.empty()) throw Usage("--class takes no EXERCISE; choose with --exercise");
  if (options.sandbox != "bubblewrap") throw Usage("a class is graded in the sandbox only");
  if (options.exit_status == "verdict") throw Usage("--exit-status verdict is for one submission");
  Class& work = command.classroom;
  for (const std::string& name : options.exercises) add(work.exercises, name);
  if (!options.assigned.empty()) work.assigned = assigned(options.assigned);
  work.submissions = options.submissions;
  work.results = folder(options.out);
  if (lies_within(work.results, work.submissions)) {
    throw Usage("--out lies within the submissions; name a folder beside them");
  }
  work.seed = seed(options);
  work.seed_file = options.seed_file;
  work.jobs = jobs(options.jobs);
  work.shard = shard(options.shard);
  work.emits = emits(options);
}

/// An exercise and a file, or a header whose name says which exercise it is for: that is one's own.
void add_submission(Command& command, const Options& options) {
  const std::string& name = options.exercise;
  if (!options.file.empty()) {
    command.request.exercise = exercise_meant(name);
    command.request.submission = options.file;
  } else {
    add_own(command, name);
    command.at_home = true;
  }
}

void add_course(Command& command, const Options& options) {
  if (!options.exercise.empty() || !options.seed.empty() || !options.seed_file.empty() ||
      !options.out.empty() || !options.submissions.empty())
    throw Usage("grade class takes no EXERCISE, no folder and no seed; its file names them");
  if (options.sandbox != "bubblewrap") throw Usage("a course is graded in the sandbox only");
  if (options.exit_status == "verdict") throw Usage("--exit-status verdict is for one submission");
  command.course = {options.first, options.round, jobs(options.jobs), shard(options.shard)};
}

void add_one(Command& command, const Options& options) {
  if (command.what == What::watch) {
    command.at_home = true;
    if (!options.out.empty()) throw Usage("name an exercise and a file before --out");
  } else {
    add_submission(command, options);
  }
  command.request.seed = seed(options);
  command.request.seed_file = options.seed_file;
  if (options.sandbox == "none") do_without_a_cage(command.request);
  command.cage_if_any = options.sandbox == "auto";
  if (!options.out.empty()) command.out = folder(options.out);
  command.emits = emits(options);
  command.all = options.all;
  command.exit_by_verdict = options.exit_status == "verdict";
  command.limits_given = !options.limits.empty();
  command.unchecked = options.unchecked;
  if (command.limits_given && !read_limits(options.limits, command.request)) {
    throw Usage("--limits is for the grader's own use");
  }
}

/// These grade nothing, and take no more than their names and options.
void add_way(Command& command, const Options& options) {
  command.what = *options.word;
  if (!options.exercise.empty() || !options.submissions.empty() || !options.out.empty() ||
      !options.seed.empty() || !options.seed_file.empty())
    throw Usage("grade " + options.said + " grades nothing; grade " + options.said +
                " --help says what it takes");
  if (command.what == What::collect) {
    command.collection = {options.first,     options.second, options.third, options.until,
                          options.worksheet, options.course, options.round};
  } else {
    command.handed_back = {options.first, options.second, options.third, options.column};
  }
}

void check_is_for(const std::string& option, const std::string& value, const Options& options,
                  What word, const std::string& name) {
  if (!value.empty() && options.word != word) throw Usage(option + " is for " + name);
}

void add_word(Command& command, const Options& options) {
  command.what = *options.word;
  if (!options.exercise.empty() || !options.submissions.empty() || !options.out.empty())
    throw Usage("grade " + options.said + " grades nothing; grade " + options.said +
                " --help says what it takes");
  command.request.seed_file = options.seed_file;
  if (options.sandbox == "none") do_without_a_cage(command.request);
  if (command.what == What::list) {
    command.listed = options.first;
  } else if (command.what == What::run) {
    command.own = options.first;
  } else if (command.what == What::gradescope || command.what == What::classroom) {
    command.reports = options.first;
    command.own = options.second;
  } else if (command.what == What::play && options.first == "level") {
    command.what = What::level;
    command.request.seed = seed(options);
    command.own = options.second;
    command.exit_by_verdict = options.exit_status == "verdict";
  } else if (command.what == What::play) {
    add_own(command, options.first);
    command.request.seed = seed(options);
  } else if (command.what != What::check) {
    command.request.exercise = exercise_meant(options.first);
    command.own = options.second;
  }
}

}  // namespace

Command read_command_line(int argc, char** argv) {
  const std::optional<Options> read = read_options(argc, argv);
  if (!read) return {};
  const Options& options = *read;
  Command command;
  if (!options.jobs.empty() && options.submissions.empty() && options.word != What::course)
    throw Usage("--jobs requires --class");
  if (!options.shard.empty() && options.submissions.empty() && options.word != What::course)
    throw Usage("--shard requires --class");
  if (options.word != What::collect)
    check_is_for("--round", options.round, options, What::course, "grade class");
  check_is_for("--course", options.course, options, What::collect, "grade collect");
  check_is_for("--until", options.until, options, What::collect, "grade collect");
  check_is_for("--worksheet", options.worksheet, options, What::collect, "grade collect");
  check_is_for("--column", options.column, options, What::hand_back, "grade hand-back");
  if (options.word == What::collect || options.word == What::hand_back) {
    add_way(command, options);
  } else if (options.word == What::course) {
    command.what = What::course;
    add_course(command, options);
  } else if (options.word) {
    add_word(command, options);
  } else if (options.version) {
    if (!options.submissions.empty()) throw Usage("--version grades nothing");
    command.what = What::version;
  } else if (!options.submissions.empty()) {
    command.what = What::whole_class;
    add_class(command, options);
  } else {
    command.what = options.exercise.empty() ? What::watch : What::one;
    add_one(command, options);
  }
  return command;
}

}  // namespace grade
