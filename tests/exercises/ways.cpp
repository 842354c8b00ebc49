// SPDX-License-Identifier: MIT-0
#include "ways.h"

#include <fcntl.h>

#include <stdexcept>
#include <utility>

namespace ways {

Driver::Driver(grade::Exercise exercise, const std::filesystem::path& driver)
    : exercise_(std::move(exercise)), file_(::open(driver.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (!file_) throw std::runtime_error("there is no " + driver.string());
}

grade::Report Driver::grade(const std::filesystem::path& header, std::uint64_t seed,
                            const cage::Limits& limits, const std::string& only) const {
  grade::Request request;
  request.exercise = exercise_;
  request.submission = header;
  request.seed = seed;
  request.sandbox = cage::Sandbox::none;
  request.run_limits = limits;
  request.runs = 1;
  request.only = only;
  request.arguments = {weakly_canonical(header)};
  return grade::grade_driver(request, file_);
}

}  // namespace ways
