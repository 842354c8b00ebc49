// SPDX-License-Identifier: MIT-0
/// @file
/// What `choose --help` says above its options, and below them.
#pragma once

/// What it does.
inline constexpr const char* about =
    "Prints the cheapest method and step that keep a scene within bounds, and why the others fall "
    "out.\nEvery method is run with more and more steps in each frame and compared with the exact "
    "solution.\nThe steps are doubled until the bounds are met, then every smaller number is "
    "tried.\nWhere doubling never gets there, every number that would cost less than the best is. "
    "The search ends\nat 1024 steps in a frame, and at a million in the whole run.\nOf two that "
    "cost the same, the one that is within the bounds in uneven frames as well comes first.";

/// What it can be asked about, in which units it answers, and its exit codes.
inline constexpr const char* scenes_about =
    "Scenes: spring (--omega, --zeta), orbit (--omega, --eccentricity), pendulum (--omega, "
    "--angle),\n  drag (--drag), ball (a constant force). Or your own: a header, named with its "
    ".h, that defines Vec\n  (double, float, an Eigen vector, or one of yours with + and * by a "
    "number), Vec acceleration(const Vec& x,\n  const Vec& v, double t), start_x and start_v. It "
    "is "
    "compiled and run, so it must be one that you trust.\n  If its force switches, as at a kerb, "
    "the answer hangs on where in a step that is: ask with --phase,\n  which lets the frames begin "
    "at several moments, and you get the worst answer.\n"
    "Prices: evaluations of the acceleration in a second of play. The derivatives that an implicit "
    "method\n  asks for cost as much again; solving its equations is not counted. And time, as it "
    "was recorded,\n  solver and all: microseconds in a frame for a thousand bodies in a loop.\n"
    "Exit code: 0 found, 1 nothing meets the bounds, 2 bad input.\n"
    "Example: choose --scene spring --omega 40 --zeta 0.1 --hz 60 --error 0.01";
