// Random numbers as a pure function of (seed, pixel, sample, dimension).
