#!/usr/bin/env python3
# SPDX-License-Identifier: MIT-0
"""Prints the reference values of the tests in this folder; needs Python's mpmath.

Every value comes from the differential equation or from a quadrature, at 40 digits, and never from
the formula that the scene itself uses. The build does not run this.
"""
import csv
import pathlib

from mpmath import exp, mp, mpf, odefun, polyroots, quad, sin, sqrt, nstr

mp.dps = 40


def show(name, *values):
    print(f"{name:34}", *(nstr(value, 20) for value in values))


def solve(name, acceleration, x0, v0, times):
    """Follows x'' = a(x, v, t), whose coordinates are lists, by Taylor series of high order."""
    n = len(x0)
    f = odefun(lambda t, y: list(y[n:]) + acceleration(y[:n], y[n:], t), 0, x0 + v0)
    for t in times:
        show(f"{name} t={nstr(t, 5)}", *f(t))


def tenth(n):
    return mpf(n) / 10


g = mpf("9.81")
solve("linear drag c=0.7 v0=3", lambda x, v, t: [-g - tenth(7) * v[0]], [0], [3], [tenth(4), 3])
solve("quadratic drag k=0.3", lambda x, v, t: [-g + tenth(3) * v[0] ** 2], [0], [0], [tenth(2), 2])
for zeta in (0, tenth(2), 1, tenth(25)):
    spring = lambda x, v, t: [-9 * x[0] - 6 * zeta * v[0]]
    solve(f"spring omega=3 zeta={nstr(zeta, 3)}", spring, [tenth(5)], [mpf(-2)], [tenth(7), 2])
solve("circle omega=1.5 radius=2", lambda x, v, t: [-mpf("2.25") * c for c in x], [2, 0], [0, 3],
      [tenth(9), 7])

# x'' + 2 zeta omega x' + omega^2 x = 0 at omega = 1e4, zeta = 5e3: two exponentials, whose rates
# are the roots of a polynomial. From x = 1, v = 0.
fast, slow = sorted(polyroots([1, mpf(10) ** 8, mpf(10) ** 8], maxsteps=200, extraprec=200))
for t in (1, 50):
    show(f"stiff door t={t}", (fast * exp(slow * t) - slow * exp(fast * t)) / (fast - slow))


def kepler(x, v, t):
    r = sqrt(x[0] ** 2 + x[1] ** 2)
    return [-2 * c / r**3 for c in x]


for e in (tenth(6), tenth(9)):
    # At the pericentre a (1 - e) the speed is sqrt(mu / a (1 + e) / (1 - e)); here a = 3, mu = 2.
    speed = sqrt(mpf(2) / 3 * (1 + e) / (1 - e))
    solve(f"orbit a=3 mu=2 e={nstr(e, 2)}", kepler, [3 * (1 - e), 0], [0, speed], [tenth(5), 9])

push = lambda t: 35 / (2 - t / 4) - g
for t in (tenth(15), 4, 6):
    burn = min(t, mpf(4))
    v = quad(push, [0, burn]) - g * (t - burn)
    x = quad(lambda s: (t - s) * push(s), [0, burn]) - g * (t - burn) ** 2 / 2
    show(f"rocket t={nstr(t, 3)}", x, v)

for angle in (tenth(1), 1, 3):
    # T = 4 sqrt(L / g) K(sin(angle / 2)), with Legendre's integral, by quadrature.
    k = sin(mpf(angle) / 2)
    legendre = quad(lambda phi: 1 / sqrt(1 - (k * sin(phi)) ** 2), [0, 1, mp.pi / 2])
    show(f"pendulum period angle={nstr(angle, 2)}", 4 * sqrt(1 / g) * legendre)
solve("pendulum angle=1", lambda x, v, t: [-g * sin(x[0])], [1], [0], [tenth(7), 2])

mp.dps = 25
published = pathlib.Path(__file__).with_name("outer_solar_system.csv").read_text().splitlines()
rows = [[mpf(cell) for cell in row[1:]] for row in csv.reader(published[4:])]
masses = [row[0] for row in rows]
G = mpf("2.95912208286e-4")


def separation(x, i, j):
    return [x[3 * j + k] - x[3 * i + k] for k in range(3)]


def gravity(x):
    a = [mpf(0)] * len(x)
    for i in range(len(masses)):
        for j in range(len(masses)):
            if i != j:
                d = separation(x, i, j)
                r = sqrt(sum(c * c for c in d))
                for k in range(3):
                    a[3 * i + k] += G * masses[j] * d[k] / r**3
    return a


def add(x, h, v):
    return [a + h * b for a, b in zip(x, v)]


def leapfrog(x, v, h, steps):
    x = add(x, h / 2, v)
    for n in range(steps):
        v = add(v, h, gravity(x))
        x = add(x, h if n < steps - 1 else h / 2, v)
    return x + v


def extrapolated(x, v, length, rows=9):
    """One long step: leapfrogs of ever shorter steps, extrapolated to step zero after Neville."""
    table = []
    for row in range(rows):
        now = [leapfrog(x, v, length / (2 * row + 2), 2 * row + 2)]
        for k in range(row):
            factor = (mpf(row + 1) / (row - k)) ** 2 - 1
            now.append([a + (a - b) / factor for a, b in zip(now[k], table[row - 1][k])])
        table.append(now)
    return table[-1][-1][: len(x)], table[-1][-1][len(x) :]


x0 = [c for row in rows for c in row[1:4]]
v0 = [c for row in rows for c in row[4:7]]
potential = -sum(G * masses[i] * masses[j] / sqrt(sum(c * c for c in separation(x0, i, j)))
                 for i in range(len(masses)) for j in range(i))
kinetic = sum(row[0] * sum(c * c for c in row[4:7]) / 2 for row in rows)
show("outer solar system: energy", kinetic + potential)
x, v = x0, v0
for _ in range(40):
    x, v = extrapolated(x, v, mpf(100))
for i, row in enumerate(rows):
    show(f"  body {i}: x after 4000 days", *x[3 * i : 3 * i + 3])

