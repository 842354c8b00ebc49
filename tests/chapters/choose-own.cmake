# Scenes of one's own that are not of doubles or of Eigen's vectors, and those that are none.
set(NAME choose)
include(${CMAKE_CURRENT_LIST_DIR}/refusal.cmake)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})

# own_scene(file lines...): a header with these lines.
function(own_scene file)
  list(JOIN ARGN ";\n" text)
  file(WRITE ${SCRATCH}/${file} "${text};\n")
endfunction()

# answers(pattern arguments...): PROGRAM must find an answer like the pattern, from within the folder of the scenes.
function(answers pattern)
  execute_process(COMMAND ${PROGRAM} --quiet ${ARGN} WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0 OR NOT out MATCHES "${pattern}" OR err)
    message(SEND_ERROR "${ARGN}: expected '${pattern}', got ${code}: ${out}${err}")
  endif()
endfunction()

# The spring of choose.cmake in floats: the same steps, and it says so.
own_scene(float.h "using Vec = float" "inline Vec acceleration(const Vec& x, const Vec& v, float) { return -1600 * x - 8 * v; }
inline const Vec start_x = 1, start_v = 0")
answers("^The acceleration is in float.*\n\nThe cheapest within the bounds:\n  velocity_verlet, 4 steps a frame: 240 evaluations a second, error 0.006.*\nsymplectic_euler +33 +1980 "
  --scene float.h --seconds 2)
refuses("the scene is in float, which keeps no error below 1e-06" --scene ${SCRATCH}/float.h --error 1e-7)

# The same spring along a line in space, of a type that holds numbers by other names than x, y and z; timed as it is.
set(plus "inline Vec operator+(Vec a, Vec b) { return {a.east + b.east, a.north + b.north, a.up + b.up}; }")
set(times "inline Vec operator*(double s, Vec a) { return {s * a.east, s * a.north, s * a.up}; }")
set(force "inline Vec acceleration(const Vec& x, const Vec& v, double) { return -1600 * x + -8 * v; }")
set(start "inline const Vec start_x{0.6, 0, 0.8}, start_v{}")
own_scene(space.h "struct Vec { double east, north, up; }" "${plus}\n${times}\n${force}\n${start}")
answers("^The cheapest within the bounds:\n  velocity_verlet, 4 steps a frame: 240 evaluations a second, error 0.006.*\n.*of velocity_verlet takes here, of one of 512 bodies [[]ns[]]: [0-9.]+\n$"
  --scene space.h --seconds 2)
own_scene(floats.h "struct Vec { float x, y; }" "inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator*(float s, Vec a) { return {s * a.x, s * a.y}; }
inline Vec acceleration(const Vec& x, const Vec& v, double) { return -1600.f * x + -8.f * v; }
inline const Vec start_x{0.6f, 0.8f}, start_v{}")
answers("\"function\": \"velocity_verlet\",.*\"steps_per_frame\": 4," --scene floats.h --seconds 2 --format json)

# What a scene lacks is said in one line: the compiler's, with the reader's file and line, if that is where it is.
own_scene(semicolon.h "using Vec = double" "inline Vec acceleration(const Vec& x, const Vec&, double) {
  const double y = 2 * x
  return -y" "}\ninline const Vec start_x = 1, start_v = 0")
set(by_gcc "4:3: error: expected .*;.* before .*return")
set(by_clang "3:25: fatal error: expected .*;.* at end of declaration")
refuses(" ${SCRATCH}/semicolon.h:(${by_gcc}|${by_clang})" --scene ${SCRATCH}/semicolon.h)
own_scene(start.h "using Vec = double" "inline Vec acceleration(const Vec& x, const Vec&, double) { return -x; }\ninline const Vec start_x = 1")
refuses("it has to define Vec.* error: .*start_v" --scene ${SCRATCH}/start.h)
own_scene(force.h "using Vec = double" "inline const Vec start_x = 1, start_v = 0")
refuses("force.h is no scene: it needs a function acceleration that can be called with" --scene ${SCRATCH}/force.h)
own_scene(whole.h "using Vec = int" "inline Vec acceleration(const Vec& x, const Vec&, double) { return -x; }\ninline const Vec start_x = 1, start_v = 0")
refuses("whole.h is no scene: Vec has to be double, float, a vector of Eigen's" --scene ${SCRATCH}/whole.h)
string(REPLACE "(double s, Vec a)" "(Vec a, double s)" behind "${times}")
own_scene(behind.h "struct Vec { double east, north, up; }" "${plus}\n${behind}
inline Vec acceleration(const Vec& x, const Vec&, double) { return x * -1; }\n${start}")
refuses("behind.h is no scene: Vec needs . and .,[^\n]* with the number in front" --scene ${SCRATCH}/behind.h)
string(REPLACE ", a.up + b.up" ", 1" not_all "${plus}")
own_scene(sum.h "struct Vec { double east, north, up; }" "${not_all}\n${times}\n${force}\n${start}")
refuses("start_x . start_v is not the sum of their numbers" --scene ${SCRATCH}/sum.h)
own_scene(crash.h "#include <cstdlib>\nusing Vec = double" "inline Vec acceleration(const Vec& x, const Vec&, double) { if (x < 0) std::abort()" " return -x" "}\ninline const Vec start_x = 1, start_v = 0")
refuses("the acceleration of ${SCRATCH}/crash.h crashed" --scene ${SCRATCH}/crash.h)
