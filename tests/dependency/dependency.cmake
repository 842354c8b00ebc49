# cmake -DSOURCE=project -DGXX=compiler -DWORK=folder -P dependency.cmake
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${said}")
  endif()
endfunction()

# An empty project that takes the headers by these lines, in C++17, and may look for nothing.
function(project_that way lines)
  set(folder ${WORK}/${way})
  file(WRITE ${folder}/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
set(CMAKE_DISABLE_FIND_PACKAGE_Eigen3 ON)
set(CMAKE_DISABLE_FIND_PACKAGE_Catch2 ON)
${lines}
add_executable(game game.cpp)
target_link_libraries(game PRIVATE one-step-at-a-time::integrate)
get_target_property(features one-step-at-a-time::integrate INTERFACE_COMPILE_FEATURES)
if(NOT features STREQUAL \"cxx_std_17\")
  message(FATAL_ERROR \"C++17 is asked for, not \${features}\")
endif()
get_property(tests DIRECTORY PROPERTY TESTS)
get_property(options CACHE BOOK PROPERTY VALUE)
if(tests OR options)
  message(FATAL_ERROR \"more came along than the headers: \${tests} \${options}\")
endif()
")
  file(WRITE ${folder}/game.cpp "#include <integrate/euler.h>
#include <shelf/bounce.h>

int main() {
  double x = 1, v = 0;
  integrate::euler(x, v, 0.0, 0.5, [](double at, double, double) { return -at; });
  return x == 1 && v == -0.5 ? 0 : 1;
}
")
  run(${CMAKE_COMMAND} -G Ninja -S ${folder} -B ${folder}/build -DCMAKE_CXX_COMPILER=${GXX} ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/game)
  file(GLOB_RECURSE made RELATIVE ${folder}/build ${folder}/build/*.o)
  if(NOT made STREQUAL "CMakeFiles/game.dir/game.cpp.o")
    message(FATAL_ERROR "${way}: more was compiled than the game: ${made}")
  endif()
endfunction()

project_that(subdirectory "add_subdirectory(\"${SOURCE}\" one)")
project_that(fetched "include(FetchContent)
FetchContent_Declare(one SOURCE_DIR \"${SOURCE}\")
FetchContent_MakeAvailable(one)")

run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${WORK}/headers -DHEADERS_ALONE=ON -DCMAKE_CXX_COMPILER=${GXX})
run(${CMAKE_COMMAND} --install ${WORK}/headers --prefix ${WORK}/prefix)
project_that(installed "find_package(one-step-at-a-time 0.9 REQUIRED)" -DCMAKE_PREFIX_PATH=${WORK}/prefix)
