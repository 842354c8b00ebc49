inline void step(double& x, double v, double h) {}
