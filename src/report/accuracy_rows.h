/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 164, 0.0317, 0.132},
{4, 428, 0.00158, 0.0243},
{8, 582, 0.00113, 0.0149},
{16, 575, 0.000234, 0.00802},
{32, 570, 4.86e-05, 0.00373},
{64, 533, 7.88e-06, 0.00156},
{128, 408, 1.71e-06, 0.000868},
{256, 342, 1.58e-06, 0.000459},
{512, 258, 1.9e-06, 0.000495},
{1024, 170, 1.16e-06, 0.000256},
