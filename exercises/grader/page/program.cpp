// SPDX-License-Identifier: MIT-0
#include "page/program.h"

#include "judge/ending.h"
#include "judge/session.h"
#include "page/ending.h"

/// Begins a program with the student's module, and returns its number.
extern "C" [[clang::import_module("page"), clang::import_name("begin")]] int page_begin();

extern "C" [[clang::import_module("page"), clang::import_name("end")]] void page_end(int program);

/// Has the program answer, asking through ask_judge() on the way, and returns how many numbers it
/// answers, or a page::Ending.
extern "C" [[clang::import_module("page"), clang::import_name("call")]] int page_call(
    int program, int function, const double* arguments, std::size_t count);

/// Copies the answer.
extern "C" [[clang::import_module("page"), clang::import_name("answer")]] void page_answer(
    int program, double* numbers);

namespace {

const Acceleration* asked = nullptr;

class Module : public judge::Program {
 public:
  ~Module() override { page_end(number_); }

  std::vector<double> answer(int function, const std::vector<double>& arguments, std::size_t wanted,
                             const Acceleration& acceleration) override {
    asked = &acceleration;
    const int count = page_call(number_, function, arguments.data(), arguments.size());
    if (count < 0) {
      page::note_ending(page::Ending(count));
      throw judge::Stopped();
    }
    if (static_cast<std::size_t>(count) != wanted) {
      judge::note_other_count(count, wanted);
      throw judge::Stopped();
    }
    std::vector<double> numbers(wanted);
    page_answer(number_, numbers.data());
    return numbers;
  }

 private:
  int number_ = page_begin();
};

}  // namespace

/// Seven numbers in, x, v and t; three out, in place of the first.
extern "C" [[clang::export_name("ask_judge")]] void ask_judge(double* numbers) {
  const auto [x, y, z] = (*asked)({numbers[0], numbers[1], numbers[2]},
                                  {numbers[3], numbers[4], numbers[5]}, numbers[6]);
  numbers[0] = x, numbers[1] = y, numbers[2] = z;
}

extern "C" [[clang::export_name("question")]] double* question() {
  static double numbers[7];
  return numbers;
}

std::unique_ptr<judge::Program> page::begin_program() {
  return std::make_unique<Module>();
}
