# The chooser of chapter 7: what it finds, exit codes, and one clear line for bad input. It is asked with --quiet, since on a slow
# machine it would say how far it has got.
function(run)
  execute_process(COMMAND ${PROGRAM} --quiet ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  set(code ${code} PARENT_SCOPE)
  set(out "${out}" PARENT_SCOPE)
  set(err "${err}" PARENT_SCOPE)
endfunction()

function(answers expected_code pattern)
  run(${ARGN})
  if(NOT code EQUAL expected_code)
    message(SEND_ERROR "${ARGN}: exit code ${code}, expected ${expected_code}")
  endif()
  if(NOT out MATCHES "${pattern}")
    message(SEND_ERROR "${ARGN}: expected '${pattern}' in: ${out}")
  endif()
  if(NOT err STREQUAL "")
    message(SEND_ERROR "${ARGN}: wrote on stderr: ${err}")
  endif()
  set(first "${out}")
  run(${ARGN})
  if(NOT out STREQUAL first)
    message(SEND_ERROR "${ARGN}: another answer the second time")
  endif()
endfunction()

set(NAME choose)
include(${CMAKE_CURRENT_LIST_DIR}/refusal.cmake)

answers(0 "This scene has an exact step. Take it:\n  spring_folded, 1 step a frame.*\n  spring_exact, 1 step a frame.*within the bounds is\n  velocity_verlet, 4 steps a frame: 240 .*\n  #include \"integrate/velocity_verlet.h\""
  --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01)
answers(0 "Take it:\n  constant_acceleration, 1 step a frame" --scene ball)
answers(0 "^Where gravity and this drag are all that acts, there is an exact step: .*pick-a-method.html.*\n\nThe cheapest within the bounds:\n" --scene drag --drag 2 --seconds 1)
answers(0 "^The cheapest within the bounds:\n" --scene pendulum --angle 2 --energy 0.001)
answers(0 "^The cheapest within the bounds:\n  dopri5" --scene orbit --energy 0.001)
answers(1 "^Nothing meets the bounds. The nearest:\n" --scene orbit --error 1e-15 --hz 10 --seconds 1)
answers(0 "uneven frames as well comes first.*If its force switches.*with --phase.*get the worst answer" --help)
answers(0 "--eccentricity[^\n]*default 0.5.*default any.*2 bad input.*Example: choose" --help)
answers(0 "evals/s +us/frame +error +uneven +energy .*\nsymplectic_euler +33 +1980 +[0-9.]+ +0.0097 +0.00[0-9]+ +- +error 0.0100[1-9] in 32 steps"
  --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01)
# Neither the method nor the price is found by doubling the steps.
answers(0 "within the bounds is\n  bdf2, 2 steps a frame: 240 evaluations a second, [0-9.]+ us a frame for 1000, error 0.0083\n"
  --scene spring --omega 60 --zeta 2 --hz 60 --seconds 1 --error 0.01)
answers(0 "within the bounds is\n  velocity_verlet, 3 steps a frame: 90 "
  --scene spring --omega 25 --zeta 0.3 --hz 30 --seconds 5 --error 0.02)
answers(0 "\nvelocity_verlet [^\n]*\nleapfrog [^\n]*\nstormer_verlet " --scene spring --omega 10 --seconds 1)
# Of equal prices, what is right in even frames alone comes last.
answers(0 "\nvelocity_verlet [^\n]*\nleapfrog [^\n]*\neuler [^\n]*\nsymplectic_euler [^\n]*\nstormer_verlet [^\n]*! " --scene ball)

# A stiffness and a mass are a frequency. Errors that are asked for in metres are told in metres.
function(same first second)
  run(${${first}})
  set(one "${out}")
  run(${${second}})
  if(NOT out STREQUAL one)
    message(SEND_ERROR "${${second}} answers otherwise than ${${first}}: ${out}")
  endif()
endfunction()
set(by_omega --scene spring --omega 5 --error 0.02)
set(by_stiffness --scene spring --k 100 --m 4 --error 0.02)
same(by_omega by_stiffness)
answers(0 "velocity_verlet, 4 steps a frame: 240 [^\n]*, error 0.012 m\n.* error \\[m\\] +uneven \\[m\\] .*\nsymplectic_euler +33 [^\n]* 0.019 [^\n]* error 0.0201 in 32 steps"
  --scene spring --omega 40 --zeta 0.1 --hz 60 --error-metres 0.02 --reach 2)
# What is right in even frames alone is marked.
answers(0 "velocity_verlet, [^\n]*, error 0.006, too much in uneven frames: 0.011\n.*\nvelocity_verlet [^\n]* 0.006 +0.011! "
  --scene spring --omega 20 --zeta 0.1 --seconds 1)

# Where the two prices choose differently, it says so; and what adaptive steps cost.
answers(0 "By time, [^\n]*\n  rk4, 1 step a frame" --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01)
answers(0 "end with the frames:\n  dopri5_adaptive, a tolerance of 1e-05: 688 evaluations a second.*\ndopri5_adaptive +adaptive +688 "
  --scene orbit --eccentricity 0.9)

# A scene of one's own is compiled, run, and timed. A spring that is written down by hand has the answer of the spring.
set(own "${SCRATCH}/spring.h")
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
function(own_scene text)
  file(WRITE ${own} "${text}")
endfunction()
own_scene("using Vec = double;
inline Vec acceleration(const Vec& x, const Vec& v, double) { return -1600 * x - 8 * v; }
inline const Vec start_x = 1, start_v = 0;\n")
run(--scene ${own} --hz 60 --error 0.01)
if(NOT code EQUAL 0 OR NOT out MATCHES "^The cheapest within the bounds:\n  velocity_verlet, 4 steps a frame: 240 evaluations a second, error 0.006\n.*\nvelocity_verlet +4 +240 +- +0.006 +0.0094 .*\nsymplectic_euler +33 +1980 .* in 32 steps\n.*\ndopri5_adaptive +adaptive +136 +- +0.0093 +0.0092 .*of velocity_verlet takes here, of one of 512 bodies [[]ns[]]: [0-9.]+\n$")
  message(SEND_ERROR "a spring of one's own: ${code}: ${out}${err}")
endif()
run(--scene ${EXAMPLE} --seconds 5 --error-metres 0.01 --format json)
if(NOT code EQUAL 0 OR NOT out MATCHES "^\\[\n  {\n    \"function\": \"velocity_verlet\",\n    \"header\": \"velocity_verlet.h\",\n    \"good\": true,")
  message(SEND_ERROR "the chapter's example: ${code}: ${out}${err}")
endif()
own_scene("using Vec = double;\ninline Vec acceleration(const Vec& x, const Vec&, double) { return -y; }\n")
refuses("spring.h doesn't compile as a scene; it has to define Vec, acceleration.*error: .*y" --scene ${own})
own_scene("#include <cmath>
using Vec = double;
inline Vec acceleration(const Vec& x, const Vec&, double) { return -std::sqrt(x); }
inline const Vec start_x = 1, start_v = -1;\n")
refuses("the acceleration is not finite, or changes too suddenly, after 0.[0-9]+ seconds" --scene ${own})
own_scene("using Vec = double;
inline Vec acceleration(const Vec& x, const Vec&, double) { return -x; }
inline const Vec start_x = 0, start_v = 0;\n")
refuses("nothing leaves the origin" --scene ${own})
refuses("there is no file ${SCRATCH}/nothing.h" --scene ${SCRATCH}/nothing.h)
refuses("a scene of your own takes no --omega" --scene ${own} --omega 3)

# For other programs: all entries, each with what is known of it.
answers(0 "^\\[\n  {\n    \"function\": \"spring_folded\",\n    \"header\": \"spring_exact.h\",\n    \"good\": true,\n    \"steps_per_frame\": 1,.*\"function\": \"spring_exact\",.*\"function\": \"dopri5_adaptive\","
  --scene spring --seconds 1 --format json)
answers(0 "^\\[\n  {\n    \"function\": \"constant_acceleration\",.*\"steps_per_frame\": null,\n    \"tolerance\": [0-9.e-]+,"
  --scene ball --format json)

# A log of frames gives the uneven ones, and their mean as the rate.
set(log ${SCRATCH}/game.csv)
file(WRITE ${log} "Application,MsBetweenPresents\n")
foreach(n RANGE 1 40)
  file(APPEND ${log} "game.exe,20\ngame.exe,10\ngame.exe,10\n")
endforeach()
answers(0 "\nuneven: the error in frames as uneven as the 120 of game.csv, the roughest 75, which take 10 to 20 ms,\n"
  --scene spring --omega 40 --seconds 1 --frames ${log})
answers(0 "\nvelocity_verlet +1 +75 [^\n]*.*\nrk4 +1 +300 .*the 120 of game.csv, which take 10 to 20 ms," --scene pendulum --omega 1 --seconds 3 --frames ${log})
answers(0 "\nvelocity_verlet +1 +60 [^\n]*.*game.csv, the roughest 60," --scene pendulum --omega 1 --seconds 1 --hz 60 --frames ${log})
file(APPEND ${log} "game.exe,slow\n")
refuses("${log}, row 122: 'slow' is no number" --scene ball --frames ${log})
refuses("nothing.csv: there is no such file" --scene ball --frames nothing.csv)

# Times have units, and what hardly moves says so.
answers(0 "spring_exact, 1 step a frame: 100 evaluations" --scene spring --frame 10ms --seconds 0.05min)
answers(0 "\nvelocity_verlet +1 +0.0167 " --scene pendulum --omega 0.001 --seconds 5h --frame 1min)
answers(0 "In this time nothing moves farther than 5e-07 of [^\n]*\n[^\n]* standing still is good enough" --scene spring --omega 0.001 --seconds 1)
answers(0 "^Where gravity and this drag.*shelf/quadratic_drag.h.\n\nThe cheapest within the bounds:\n" --scene drag)
refuses("lightyears unit not recognized" --scene ball --seconds 3lightyears)
refuses("--frame and --hz say the same" --scene ball --frame 10ms --hz 100)
refuses("--hz must lie between 1e-09 and 100000" --scene ball --hz 0)

# An answer that nobody can read is none.
execute_process(COMMAND ${PROGRAM} --scene ball OUTPUT_FILE /dev/full RESULT_VARIABLE code ERROR_VARIABLE err)
if(NOT code EQUAL 2 OR NOT err STREQUAL "choose: can't write the answer\n")
  message(SEND_ERROR "on a full disk: ${code}: ${err}")
endif()

# The chart is there and whole, or there is none.
set(chart ${SCRATCH}/chart.svg)
answers(0 "\nThe cheapest" --scene drag --chart ${chart})
file(READ ${chart} drawn)
if(NOT drawn MATCHES "velocity_verlet.*</svg>")
  message(SEND_ERROR "the chart has no line of velocity_verlet: ${drawn}")
endif()
file(GLOB left ${SCRATCH}/*.part)
if(left)
  message(SEND_ERROR "the chart leaves ${left}")
endif()
refuses("can't draw ${SCRATCH}/no/chart.svg" --scene drag --chart ${SCRATCH}/no/chart.svg)

refuses("--scene is required")
refuses("there is no format 'xml'; there are text, json" --scene ball --format xml)
refuses("--k and --omega say the same" --scene spring --k 3 --omega 2)
refuses("--error-metres and --error say the same" --scene ball --error 0.1 --error-metres 2)
refuses("--m means nothing without --k" --scene spring --m 3)
refuses("--reach means nothing without --error-metres" --scene spring --reach 3)
refuses("the scene ball takes no --k" --scene ball --k 3)
refuses("there is no scene 'spoon'; there are spring, orbit, pendulum, drag, ball" --scene spoon)
refuses("the scene ball takes no --omega" --scene ball --omega 3)
refuses("--omega must lie between 0.001 and 1000" --scene spring --omega nan)
refuses("--omega must lie between 0.001 and 1000" --scene spring --omega 1e999)
refuses("--zeta must lie between 0 and 100" --scene spring --zeta -1)
refuses("--eccentricity must lie between 0 and 0.99" --scene orbit --eccentricity 1)
refuses("--omega" --scene spring --omega fast)
refuses("--omega" --scene spring --omega 3 --omega 4)
refuses("there is no option --frog" --scene ball --frog)
refuses("there is no option --frog" --frog)
refuses("there is no option --frog" --frog 3)
refuses("an option must come before more" --scene ball more)
refuses("--energy means nothing" --scene spring --zeta 0.1 --energy 0.1)
refuses("--energy means nothing" --scene drag --energy 0.1)
refuses("--phase is for scenes of your own" --scene ball --phase)
refuses("less than one frame" --scene ball --hz 10 --seconds 0.01)
refuses("must stay below" --scene ball --hz 10000 --seconds 10000)
