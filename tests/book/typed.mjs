// Steps that tests type as a reader would.
export const RK4 = `const Vec a1 = acceleration(x, v, t), v2 = v + h / 2 * a1;
const Vec a2 = acceleration(x + h / 2 * v, v2, t + h / 2), v3 = v + h / 2 * a2;
const Vec a3 = acceleration(x + h / 2 * v2, v3, t + h / 2), v4 = v + h * a3;
const Vec a4 = acceleration(x + h * v3, v4, t + h);
x = x + h / 6 * (v + 2 * (v2 + v3) + v4);
v = v + h / 6 * (a1 + 2 * (a2 + a3) + a4);`;
