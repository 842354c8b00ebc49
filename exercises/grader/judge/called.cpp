// SPDX-License-Identifier: MIT-0
#include "judge/called.h"

#include "judge/answering.h"

namespace judge {
namespace {

class Called : public Program {
 public:
  explicit Called(void (*called)(harness::Call& call)) : called_(called) {}

  // What it throws ends this process, as it would end a driver.
  std::vector<double> answer(int function, const std::vector<double>& arguments, std::size_t,
                             const Acceleration& acceleration) noexcept override {
    const Answering answering(acceleration);
    harness::Call call(function, arguments);
    called_(call);
    return call.answer();
  }

 private:
  void (*called_)(harness::Call& call);
};

}  // namespace

std::unique_ptr<Program> begin_called(void (*called)(harness::Call& call)) {
  return std::make_unique<Called>(called);
}

}  // namespace judge
