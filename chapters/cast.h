// SPDX-License-Identifier: MIT-0
/// @file
/// The things that move in this book, each once, with its numbers. The page "The things that move"
/// shows them all.
#pragma once
#include <numbers>

#include "scenes/circle.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/projectile.h"
#include "scenes/quadratic_drag.h"
#include "scenes/rocket.h"
#include "scenes/spring.h"

// [drone]
/// A frame at sixty frames a second: the step, wherever no other is named [s].
inline constexpr double frame = 1.0 / 60;

/// A drone that circles its tower ten metres out, once round in eight seconds.
inline constexpr scenes::Circle<> drone{.omega = 2 * std::numbers::pi / 8, .radius = 10};

/// Frames in one turn of the drone.
inline constexpr long turn = 480;
// [drone]

/// How far from the tower the fence stands [m].
inline constexpr double fence = 12;

// [level]
/// A jump straight up at five metres a second, which is enough for a ledge of 1.27 m.
inline const scenes::Projectile<> jump{.start_velocity = {0, 5}};

/// A leaf, let go at rest, which loses speed to the air at two per second and so sinks at 4.9 m/s.
inline constexpr scenes::LinearDrag<> leaf{.c = 2};

/// The suspension of a toy car, ten centimetres out of place: it swings about three times a second,
/// at a tenth of the damping that would stop it from swinging.
inline constexpr scenes::Spring<> suspension{.omega = 20, .zeta = 0.1, .x0 = 0.1};

/// A hatch that a stiff spring shuts from a metre away, and a damper twice too strong slows.
inline constexpr scenes::Spring<> hatch{.omega = 60, .zeta = 2, .x0 = 1};

/// A lamp on a chain of one metre, let go one radian from where it hangs.
inline constexpr scenes::Pendulum<> lamp{.length = 1, .angle = 1};

/// Time of one turn of a shuttle [s].
inline constexpr double shuttle_turn = 8;

/// A shuttle on an ellipse twenty metres long, which comes within four metres of its planet.
inline constexpr scenes::Orbit<> shuttle{
    .eccentricity = 0.6,
    .semi_major = 10,
    .mu = 1000 * (2 * std::numbers::pi / shuttle_turn) * (2 * std::numbers::pi / shuttle_turn)};
// [level]

/// The jump of somebody who runs at three metres a second.
inline const scenes::Projectile<> running_jump{.start_velocity = {3, 5}};

/// A cannonball, shot at fifty metres a second, forty of them across.
inline const scenes::Projectile<> cannonball{.start_velocity = {40, 30}};

/// A parachute that opens at once, made for five metres a second: drag by the square of the speed.
inline constexpr scenes::QuadraticDrag<> parachute{.k = 9.81 / (5 * 5)};

/// The velocity of the diver when the parachute opens [m/s].
inline constexpr double diving = -50;

/// The suspension without its damper: it swings for ever.
inline constexpr scenes::Spring<> undamped_suspension{.omega = 20, .zeta = 0, .x0 = 0.1};

/// A door a metre open, with a closer five times too strong: it takes seconds to shut.
inline constexpr scenes::Spring<> door{.omega = 10, .zeta = 5, .x0 = 1};

/// A camera a metre from its target, on a critically damped spring.
inline constexpr scenes::Spring<> camera{.omega = 40, .zeta = 1};

// [bar]
/// Steel between a truck and its trailer: swings about a hundred times a second.
inline constexpr scenes::Spring<> bar{.omega = 600, .zeta = 0.1, .x0 = 0.001};
// [bar]

/// Anything on a spring without a damper, a metre out of place, by how often it swings [1/s].
constexpr scenes::Spring<> swinging(double times_a_second) {
  return {.omega = 2 * std::numbers::pi * times_a_second};
}

/// A wrecking ball on a chain of 9.81 m, which swings once in about 2 pi seconds.
inline constexpr scenes::Pendulum<> wrecking_ball{.length = 9.81};

/// The shuttle of the race, on a rounder ellipse: it comes within five metres of its planet.
inline constexpr scenes::Orbit<> race_shuttle{
    .eccentricity = 0.5, .semi_major = 10, .mu = shuttle.mu};

/// Time in which the comet comes round once [s].
inline constexpr double comet_year = 20;

/// A comet on an ellipse 200 m from end to end, which is 3 m from its sun at one of them.
inline constexpr scenes::Orbit<> comet{
    .eccentricity = 0.97,
    .semi_major = 100,
    .mu = 1e6 * (2 * std::numbers::pi / comet_year) * (2 * std::numbers::pi / comet_year)};

/// A model rocket of two kilograms, straight up: its engine pushes evenly for four seconds and
/// burns half of that away.
inline constexpr scenes::Rocket<> rocket;

/// The rocket with less fuel: it burns out between two steps at every rate that divides a second.
inline constexpr scenes::Rocket<> off_beat_rocket{.burn_time = 3.7103};
