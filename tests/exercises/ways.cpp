// SPDX-License-Identifier: MIT-0
#include "ways.h"

#include <dlfcn.h>
#include <fcntl.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "harness/call.h"

namespace ways {
namespace {

grade::Request request_for(const grade::Exercise& exercise, const std::filesystem::path& header,
                           std::uint64_t seed, const std::string& only) {
  grade::Request request;
  request.exercise = exercise;
  request.submission = header;
  request.seed = seed;
  request.sandbox = cage::Sandbox::trusted;
  request.runs = 1;
  request.only = only;
  return request;
}

template <class Function>
Function function(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

}  // namespace

Driver::Driver(grade::Exercise exercise, const std::filesystem::path& driver)
    : exercise_(std::move(exercise)), file_(::open(driver.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (!file_) throw std::runtime_error("there is no " + driver.string());
}

grade::Report Driver::grade(const std::filesystem::path& header, std::uint64_t seed,
                            const cage::Limits& limits, const std::string& only,
                            bool diagnoses) const {
  grade::Request request = request_for(exercise_, header, seed, only);
  request.run_limits = limits;
  request.diagnoses = diagnoses;
  request.arguments = {weakly_canonical(header),
                       std::to_string(std::lround(std::ceil(limits.processor))),
                       std::to_string(limits.memory), std::to_string(limits.file)};
  return grade::grade_driver(request, file_);
}

Library::Library(grade::Exercise exercise, const std::filesystem::path& library)
    : exercise_(std::move(exercise)) {
  void* opened = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!opened) throw std::runtime_error(::dlerror());
  using Ask = Vec (*)(const Vec& x, const Vec& v, double t);
  function<void (*)(Ask)>(opened, "answer_questions")(harness::ask);
  way_of_ = function<decltype(way_of_)>(opened, "way_of");
}

grade::Report Library::grade(const std::filesystem::path& header, std::uint64_t seed,
                             const std::string& only) const {
  grade::Request request = request_for(exercise_, header, seed, only);
  request.called = way_of_(weakly_canonical(header).c_str());
  request.diagnoses = false;
  if (!request.called) throw std::runtime_error("the library has no " + header.string());
  return grade::grade_called(request);
}

}  // namespace ways
