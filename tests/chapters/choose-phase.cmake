# A force that switches: without --phase the answer hangs on when it does, and who asks is warned; with --phase it does not.
set(NAME choose)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})

# answers(warning pattern arguments...): PROGRAM must find an answer like the pattern, and say a line like the warning; nothing if
# that is empty.
function(answers warning pattern)
  execute_process(COMMAND ${PROGRAM} --quiet --format json ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0 OR NOT out MATCHES "${pattern}")
    message(SEND_ERROR "${ARGN}: expected '${pattern}', got ${code}: ${out}")
  endif()
  if(warning AND NOT err MATCHES "^choose: [^\n]*${warning}[^\n]*\n$" OR err AND NOT warning)
    message(SEND_ERROR "${ARGN}: expected the warning '${warning}', got: ${err}")
  endif()
endfunction()

# kerb(file moment): a wheel on a spring, over a kerb
function(kerb file moment)
  file(WRITE ${SCRATCH}/${file} "using Vec = double;
inline Vec acceleration(const Vec& x, const Vec& v, double t) { return -400 * (x - (t > ${moment} ? 1 : 0)) - 4 * v; }
inline const Vec start_x = 0.1, start_v = 0;\n")
endfunction()
kerb(round.h 1)
kerb(later.h 1.004)
answers("another moment, the error of midpoint in 2 steps a frame is 0.03[0-9]; .* ask again with --phase"
  "^[[]\n  {\n    \"function\": \"midpoint\",[^}]*\"steps_per_frame\": 2,[^}]*\"evaluations_per_second\": 240" --scene ${SCRATCH}/round.h --seconds 2)
answers("the error of velocity_verlet in 2 steps a frame is 0.03[0-9];"
  "^[[]\n  {\n    \"function\": \"velocity_verlet\",[^}]*\"steps_per_frame\": 2," --scene ${SCRATCH}/later.h --seconds 2)
foreach(scene round later)
  answers("" "^[[]\n  {\n    \"function\": \"velocity_verlet\",[^}]*\"steps_per_frame\": 8,[^}]*\"evaluations_per_second\": 480"
    --scene ${SCRATCH}/${scene}.h --phase --seconds 2)
endforeach()

# A switch that hangs on the place, and not on the time, is luck as well.
file(WRITE ${SCRATCH}/step.h "using Vec = double;
inline Vec acceleration(const Vec& x, const Vec&, double) { return -4 * x + (x > 0.5 ? 3.0 : 0); }
inline const Vec start_x = 1, start_v = 0;\n")
answers("ask again with --phase" "" --scene ${SCRATCH}/step.h)

# Where nothing switches, nobody is warned, even if the error is only just within its bound.
file(WRITE ${SCRATCH}/smooth.h "#include <cmath>\nusing Vec = double;
inline Vec acceleration(const Vec& x, const Vec& v, double t) { return -100 * std::sin(x) - v + 20 * std::sin(37 * t); }
inline const Vec start_x = 3, start_v = 0;\n")
foreach(error 0.0136 0.000027)
  answers("" "" --scene ${SCRATCH}/smooth.h --error ${error} --seconds 2)
endforeach()
